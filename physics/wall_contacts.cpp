#include "physics/wall_contacts.hpp"

#include <algorithm>
#include <functional>

#include "pmr/base/parallel.hpp"

namespace pmr::physics {
namespace {

// Distance below which a point counts as lying on a surface [1] of the sphere's radius.
constexpr double on_surface = 1e-6;
// Springs pass between contacts whose normals differ by less than 60 degrees: cosine [1].
constexpr double similar_normal = 0.5;
// Particles that are tested against a surface together; neighbours in space [particles].
constexpr std::size_t group_size = 32;
// Bits of touches_: in the last force pass, in this one.
constexpr std::uint8_t touched = 1, touching = 2;

}  // namespace

WallContacts::WallContacts(const Case& c) : case_(c), domain_{c.domain_low, c.domain_high} {
  pose_.resize(c.walls.bodies.size());
  present_.resize(c.walls.surfaces.size());
}

void WallContacts::place(double t) {
  for (std::size_t b = 0; b < pose_.size(); ++b) pose_[b] = pose(case_.walls.bodies[b].motion, t);
  for (std::size_t s = 0; s < present_.size(); ++s)
    present_[s] = is_present(case_.walls.surfaces[s], t);
}

double WallContacts::displacement_bound(double t0, double t1) const {
  double largest = 0.0;
  for (const Body& body : case_.walls.bodies)
    largest = std::max(largest, physics::displacement_bound(body.motion, t0, t1, domain_));
  return largest;
}

Vec3 WallContacts::nearest(std::uint32_t surface, const Vec3& x) const {
  const Surface& s = case_.walls.surfaces[surface];
  const Pose& p = pose_[s.body];
  return p.to_world(closest_point(s.shape, p.to_body(x)));
}

// The distance to a surface changes by no more than the way gone, so one look from the middle of a
// group spares most of its members' looks.
void WallContacts::find_rows_near(std::span<const Sphere> group, double skin,
                                  std::vector<std::uint32_t>& found) {
  Vec3 low = group[0].position, high = low;
  double largest = 0.0;
  for (const Sphere& s : group) {
    low = low.cwiseMin(s.position);
    high = high.cwiseMax(s.position);
    largest = std::max(largest, s.radius);
  }
  const Vec3 middle = 0.5 * (low + high);
  const double reach = 0.5 * (high - low).norm() + largest + skin;
  found.clear();
  for (std::uint32_t s = 0; s < case_.walls.surfaces.size(); ++s)
    if (case_.walls.surfaces[s].holds_particles && (nearest(s, middle) - middle).norm() <= reach)
      found.push_back(s);
}

void WallContacts::rebuild(const Spheres& spheres, double skin, const ContactHistory& history) {
  const std::size_t n = spheres.size();
  start_.assign(n + 1, 0);
  std::vector<std::vector<std::uint32_t>> blocks((n + block_size - 1) / block_size);
  parallel_blocks(n, [&](std::size_t first, std::size_t last) {
    std::vector<std::uint32_t>& rows = blocks[first / block_size];
    std::vector<std::uint32_t> near;
    for (std::size_t i = first; i < last; ++i) {
      if ((i - first) % group_size == 0)
        find_rows_near({&spheres.sphere[i], std::min(group_size, last - i)}, skin, near);
      const Sphere& a = spheres.sphere[i];
      const std::size_t before = rows.size();
      for (const std::uint32_t s : near)
        if ((nearest(s, a.position) - a.position).norm() <= a.radius + skin) rows.push_back(s);
      start_[i + 1] = static_cast<std::uint32_t>(rows.size() - before);
    }
  });
  for (std::size_t i = 0; i < n; ++i) start_[i + 1] += start_[i];
  surface_.clear();
  for (const auto& rows : blocks) surface_.insert(surface_.end(), rows.begin(), rows.end());
  touches_.assign(surface_.size(), 0);
  springs_.assign(surface_.size(), {Vec3::Zero(), Vec3::Zero()});
  if (history.partner.empty()) return;
  for (std::size_t i = 0; i < n; ++i)
    for (std::uint32_t k = history.start[i]; k < history.start[i + 1]; ++k)
      for (std::uint32_t slot = start_[i]; slot < start_[i + 1]; ++slot)
        if (surface_[slot] == history.partner[k]) {
          touches_[slot] = 1;
          springs_[slot] = {history.tangential[k], history.rolling[k]};
        }
}

ContactHistory WallContacts::history() const {
  ContactHistory h;
  for (std::size_t i = 0; i + 1 < start_.size(); ++i) {
    for (std::uint32_t slot = start_[i]; slot < start_[i + 1]; ++slot)
      if (touches_[slot]) {
        h.partner.push_back(surface_[slot]);
        h.tangential.push_back(springs_[slot].tangential);
        h.rolling.push_back(springs_[slot].rolling);
      }
    h.start.push_back(static_cast<std::uint32_t>(h.partner.size()));
  }
  return h;
}

ContactBook WallContacts::set_forces(Spheres& spheres, const ContactLaws& laws, double dt) {
  book_.assign((spheres.size() + force_block - 1) / force_block, {});
  const auto block = [&](std::size_t first, std::size_t last) {
    ContactBook& book = book_[first / force_block];
    for (std::size_t i = first; i < last; ++i) {
      spheres.load[i].force.setZero();
      spheres.load[i].torque.setZero();
      if (start_[i] < start_[i + 1]) add_forces_on(spheres, i, laws, dt, book);
    }
  };
  parallel_blocks(spheres.size(), std::cref(block), force_block);
  ContactBook sum;
  for (const ContactBook& b : book_) {
    sum.dissipated += b.dissipated;
    sum.overlap_ratio = std::max(sum.overlap_ratio, b.overlap_ratio);
  }
  return sum;
}

// Surfaces that the sphere overlaps, deepest first, equal ones by their index.
WallContacts::Meetings WallContacts::meet(const Sphere& sphere, std::size_t row) const {
  Meetings m;
  for (std::uint32_t slot = start_[row]; slot < start_[row + 1]; ++slot) {
    const Surface& surface = case_.walls.surfaces[surface_[slot]];
    if (!present_[surface_[slot]]) continue;
    const Pose& p = pose_[surface.body];
    const Vec3 x = p.to_body(sphere.position);
    if (is_surely_beyond(surface.shape, x, sphere.radius)) continue;
    const Vec3 point = p.to_world(closest_point(surface.shape, x));
    const Vec3 d = sphere.position - point;
    const double distance = d.norm();
    if (distance >= sphere.radius || distance == 0.0) continue;
    const Meeting met{slot, point, d / distance, sphere.radius - distance};
    if (m.count == most_meetings && m.list[m.count - 1].overlap >= met.overlap) continue;
    std::size_t k = m.count < most_meetings ? m.count++ : most_meetings - 1;
    for (; k > 0 && m.list[k - 1].overlap < met.overlap; --k) m.list[k] = m.list[k - 1];
    m.list[k] = met;
  }
  return m;
}

// Keeps a meeting only if its point lies on none of the deeper ones' surfaces.
void WallContacts::drop_shared(Meetings& m, double radius) const {
  std::size_t kept = 1;
  for (std::size_t k = 1; k < m.count; ++k) {
    bool is_shared = false;
    for (std::size_t a = 0; a < kept && !is_shared; ++a) {
      const Vec3& q = m.list[k].point;
      is_shared = (nearest(surface_[m.list[a].slot], q) - q).norm() <= on_surface * radius;
    }
    if (!is_shared) m.list[kept++] = m.list[k];
  }
  m.count = std::min(m.count, kept);
}

// Springs of a contact of the same body that ends now under a similar normal, else loose ones.
Springs WallContacts::inherited(const Meeting& fresh, const Sphere& sphere, std::size_t row) {
  const auto body = [&](std::uint32_t slot) { return case_.walls.surfaces[surface_[slot]].body; };
  for (std::uint32_t slot = start_[row]; slot < start_[row + 1]; ++slot) {
    if (touches_[slot] != touched || body(slot) != body(fresh.slot)) continue;
    const Vec3 away = sphere.position - nearest(surface_[slot], sphere.position);
    if (away.dot(fresh.n) <= similar_normal * away.norm()) continue;
    touches_[slot] = 0;
    return springs_[slot];
  }
  return {Vec3::Zero(), Vec3::Zero()};
}

void WallContacts::add_forces_on(Spheres& s, std::size_t i, const ContactLaws& laws, double dt,
                                 ContactBook& book) {
  const Sphere& sphere = s.sphere[i];
  Meetings m = meet(sphere, i);
  if (m.count > 1) drop_shared(m, sphere.radius);
  for (std::size_t k = 0; k < m.count; ++k) touches_[m.list[k].slot] |= touching;
  for (std::size_t k = 0; k < m.count; ++k) {
    const std::uint32_t slot = m.list[k].slot;
    if (touches_[slot] == touching) springs_[slot] = inherited(m.list[k], sphere, i);
  }
  for (std::size_t k = 0; k < m.count; ++k) push(s, i, m.list[k], laws, dt, book);
  for (std::uint32_t slot = start_[i]; slot < start_[i + 1]; ++slot)
    touches_[slot] = touches_[slot] & touching ? touched : 0;
}

void WallContacts::push(Spheres& s, std::size_t i, const Meeting& met, const ContactLaws& laws,
                        double dt, ContactBook& book) {
  const Sphere& sphere = s.sphere[i];
  const Kinetics& u = s.kinetics[i];
  const Surface& surface = case_.walls.surfaces[surface_[met.slot]];
  const Pose& wall = pose_[surface.body];
  const double arm = sphere.radius - 0.5 * met.overlap;
  const Touch touch{met.n,         met.overlap,        u.velocity - wall.velocity_at(met.point),
                    arm * u.spin,  u.spin - wall.spin, arm / (sphere.radius - met.overlap),
                    sphere.radius, u.inverse_mass};
  const ContactForce f =
      evaluate(laws.with_wall(u.species, surface.material), touch, dt, springs_[met.slot]);
  s.load[i].force += f.force;
  s.load[i].torque -= arm * f.twist + f.rolling;
  book.dissipated += f.dissipated;
  book.overlap_ratio = std::max(book.overlap_ratio, met.overlap / sphere.radius);
}

}  // namespace pmr::physics
