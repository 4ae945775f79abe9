#include "physics/wall_contacts.hpp"

#include <algorithm>
#include <limits>

#include "pmr/base/parallel.hpp"

namespace pmr::physics {
namespace {

// Springs pass between contacts whose normals differ by less than what tells two surfaces apart, 25
// degrees: cosine [1].
constexpr double similar_normal = 0.9063077870366499;
// Particles that are tested against the walls together; neighbours in space [particles].
constexpr std::uint32_t group_size = 16;
// A list is to last this many sub-steps [1], with a skin of at most this many thinnest ones [1].
constexpr double steps_of_list = 20.0, thickest = 10.0;
constexpr double rounding = 0.999;  // of bounds that are sums [1]

Triple<double> triple_of(const Vec3& v) { return {v[0], v[1], v[2]}; }
Vec3 vector_of(const Triple<double>& t) { return {t.x, t.y, t.z}; }

}  // namespace

WallContacts::WallContacts(const Case& c)
    : case_(c), laws_(c), domain_{c.domain_low, c.domain_high}, tree_(c.walls) {
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

void WallContacts::open(const Spheres& spheres, const std::vector<Block>& blocks, double skin,
                        const ContactHistory& history) {
  thinnest_ = skin;
  lists_.assign(blocks.size(), {});
  parallel_for(
      blocks.size(),
      [&](std::size_t b) {
        List& list = lists_[b];
        list.block = blocks[b];
        relist(list, spheres, skin);
        if (history.partner.empty()) return;
        for (const Row& row : list.rows)
          for (std::uint32_t k = history.start[row.particle]; k < history.start[row.particle + 1];
               ++k)
            for (std::uint32_t s = row.first; s < row.last; ++s)
              if (list.slots[s].surface == history.partner[k]) {
                list.slots[s].touches = true;
                list.slots[s].springs = {triple_of(history.tangential[k]),
                                         triple_of(history.rolling[k])};
              }
      },
      1);
}

void WallContacts::follow(std::size_t b, const Spheres& spheres, double closer) {
  List& list = lists_[b];
  list.gone += closer;
  if (list.gone <= rounding * list.skin) return;
  const List old = std::move(list);
  list = {};
  list.block = old.block;
  relist(list, spheres, std::clamp(steps_of_list * closer, thinnest_, thickest * thinnest_));
  auto row = list.rows.begin();
  for (const Row& before : old.rows) {
    while (row != list.rows.end() && row->particle < before.particle) ++row;
    if (row == list.rows.end()) break;
    if (row->particle != before.particle) continue;
    for (std::uint32_t o = before.first; o < before.last; ++o)
      for (std::uint32_t s = row->first; s < row->last; ++s)
        if (old.slots[o].touches && list.slots[s].surface == old.slots[o].surface) {
          list.slots[s].touches = true;
          list.slots[s].springs = old.slots[o].springs;
        }
  }
}

// Neighbours in space ask the tree together.
void WallContacts::relist(List& list, const Spheres& spheres, double skin) {
  list.skin = skin;
  for (std::uint32_t first = list.block.first; first < list.block.last; first += group_size) {
    const std::uint32_t last = std::min(list.block.last, first + group_size);
    Vec3 low = spheres.sphere[first].position, high = low;
    double largest = 0.0;
    for (std::uint32_t i = first; i < last; ++i) {
      low = low.cwiseMin(spheres.sphere[i].position);
      high = high.cwiseMax(spheres.sphere[i].position);
      largest = std::max(largest, spheres.sphere[i].radius);
    }
    const Vec3 half = 0.5 * (high - low);
    const auto near = tree_.near(low + half, half.norm() + largest + skin, pose_);
    for (std::uint32_t i = first; i < last && !near.empty(); ++i) list_row(list, spheres, i, near);
  }
}

void WallContacts::list_row(List& list, const Spheres& spheres, std::uint32_t i,
                            std::span<const WallPart> near) {
  const Sphere& a = spheres.sphere[i];
  const auto before = static_cast<std::uint32_t>(list.slots.size());
  for (std::size_t k = 0; k < near.size();) {
    Slot slot;
    slot.surface = near[k].surface;
    slot.first = static_cast<std::uint32_t>(list.triangles.size());
    double gap = 2.0 * list.skin;
    for (; k < near.size() && near[k].surface == slot.surface; ++k) {
      const double part_gap = distance_to(near[k], a.position, a.radius + list.skin) - a.radius;
      gap = std::min(gap, part_gap);
      if (part_gap <= list.skin && near[k].triangle != WallPart::whole)
        list.triangles.push_back(near[k].triangle);
    }
    if (gap > list.skin) continue;
    slot.last = static_cast<std::uint32_t>(list.triangles.size());
    slot.wake = rounding * gap;
    list.slots.push_back(slot);
  }
  const auto after = static_cast<std::uint32_t>(list.slots.size());
  if (after > before) list.rows.push_back({i, before, after});
}

// Infinite where it is more than `reach` for sure.
double WallContacts::distance_to(const WallPart& part, const Vec3& x, double reach) const {
  const Surface& surface = case_.walls.surfaces[part.surface];
  const Vec3 at = pose_[surface.body].to_body(x);
  if (is_surely_beyond(surface.shape, at, reach)) return std::numeric_limits<double>::infinity();
  if (part.triangle == WallPart::whole) return (closest_point(surface.shape, at) - at).norm();
  return (closest_point(std::get<Facet>(surface.shape), {&part.triangle, 1}, at) - at).norm();
}

Vec3 WallContacts::nearest(const List& list, const Slot& slot, const Vec3& x) const {
  const Surface& surface = case_.walls.surfaces[slot.surface];
  const Pose& p = pose_[surface.body];
  const Vec3 at = p.to_body(x);
  if (slot.first == slot.last) return p.to_world(closest_point(surface.shape, at));
  return p.to_world(closest_point(std::get<Facet>(surface.shape),
                                  {&list.triangles[slot.first], slot.last - slot.first}, at));
}

ContactHistory WallContacts::history(std::size_t particles) const {
  ContactHistory h;
  h.start.assign(particles + 1, 0);
  for (const List& list : lists_)
    for (const Row& row : list.rows)
      for (std::uint32_t s = row.first; s < row.last; ++s) {
        const Slot& slot = list.slots[s];
        if (!slot.touches) continue;
        ++h.start[row.particle + 1];
        h.partner.push_back(slot.surface);
        h.tangential.push_back(vector_of(slot.springs.tangential));
        h.rolling.push_back(vector_of(slot.springs.rolling));
      }
  for (std::size_t i = 1; i < h.start.size(); ++i) h.start[i] += h.start[i - 1];
  return h;
}

// Contacts of the sphere, deepest first.
void WallContacts::meet(List& list, const Row& row, const Sphere& sphere) const {
  list.met.clear();
  for (std::uint32_t s = row.first; s < row.last; ++s) {
    Slot& slot = list.slots[s];
    if (list.gone < slot.wake || !present_[slot.surface]) continue;
    const Vec3 point = nearest(list, slot, sphere.position);
    const Vec3 d = point - sphere.position;
    const double distance = d.norm();
    slot.wake = list.gone + rounding * (distance - sphere.radius);
    if (distance >= sphere.radius || distance == 0.0) continue;
    list.met.push_back({slot.surface, s, point, d / distance, distance});
  }
  keep_one_per_surface(list.met, sphere.radius, [&](const Foot& foot, const Vec3& q) {
    return (nearest(list, list.slots[foot.place], q) - q).norm();
  });
}

// Springs of the contact that ends now under the most similar normal, else loose ones.
Springs<double> WallContacts::inherited(List& list, const Row& row, const Foot& fresh,
                                        const Sphere& sphere) const {
  Slot* heir_of = nullptr;
  double closest = similar_normal;
  for (std::uint32_t s = row.first; s < row.last; ++s) {
    Slot& slot = list.slots[s];
    if (!slot.touches || slot.touches_now) continue;
    const Vec3 towards = nearest(list, slot, sphere.position) - sphere.position;
    const double similarity = towards.dot(fresh.towards) / towards.norm();
    if (!(similarity > closest)) continue;
    heir_of = &slot;
    closest = similarity;
  }
  if (heir_of == nullptr) return {};
  heir_of->touches = false;
  return heir_of->springs;
}

template <class Force, class Rolling>
void WallContacts::push(const Spheres& spheres, std::size_t i, const Foot& met, double dt,
                        Springs<double>& springs, Load& load, ContactBook& book) const {
  const Sphere& sphere = spheres.sphere[i];
  const Kinetics& u = spheres.kinetics[i];
  const Surface& surface = case_.walls.surfaces[met.surface];
  const Pose& wall = pose_[surface.body];
  const double overlap = sphere.radius - met.distance;
  const double arm = sphere.radius - 0.5 * overlap;
  const Touch<double> touch{triple_of(-met.towards),
                            overlap,
                            triple_of(u.velocity - wall.velocity_at(met.point)),
                            triple_of(arm * u.spin),
                            triple_of(u.spin - wall.spin),
                            arm / met.distance,
                            sphere.radius,
                            1.0 / u.inverse_mass};
  const ContactLaw& law = laws_.with_wall(spheres.label[i].kind, surface.material);
  const ContactForce<double> f = evaluate<Force, Rolling>(law, touch, dt, springs);
  load.force += met.share * vector_of(f.force);
  load.torque -= met.share * vector_of(arm * f.twist + f.rolling);
  book.elastic += met.share * f.elastic;
  book.wall_work +=
      dt * met.share *
      (vector_of(f.force).dot(wall.velocity_at(met.point)) - vector_of(f.rolling).dot(wall.spin));
  book.overlap_ratio = std::max(book.overlap_ratio, overlap / sphere.radius);
}

template <class Force, class Rolling>
void WallContacts::add_forces_on(List& list, const Row& row, const Spheres& spheres, double dt,
                                 Load& load, Sums& sums) const {
  const Sphere& sphere = spheres.sphere[row.particle];
  meet(list, row, sphere);
  for (const Foot& met : list.met) list.slots[met.place].touches_now = true;
  for (const Foot& met : list.met) {
    Slot& slot = list.slots[met.place];
    if (!slot.touches) slot.springs = inherited(list, row, met, sphere);
  }
  for (const Foot& met : list.met) {
    const auto push_once = [&] {
      push<Force, Rolling>(spheres, row.particle, met, dt, list.slots[met.place].springs, load,
                           sums.book);
    };
    if (sums.impulse.empty()) {
      push_once();
      continue;
    }
    const Load before = load;
    push_once();
    add_reaction({load.force - before.force, 0.0, load.torque - before.torque, 0.0},
                 sphere.position, dt, sums.impulse[case_.walls.surfaces[met.surface].body]);
  }
  for (std::uint32_t s = row.first; s < row.last; ++s) {
    Slot& slot = list.slots[s];
    slot.touches = slot.touches_now;
    slot.touches_now = false;
  }
}

ContactBook WallContacts::add_forces(std::size_t b, const Spheres& spheres, double dt,
                                     std::span<Load> loads, std::span<Wrench> impulse) {
  List& list = lists_[b];
  Sums sums{{}, impulse};
  const auto add_under = [&]<class Force, class Rolling>(Force, Rolling) {
    for (const Row& row : list.rows)
      add_forces_on<Force, Rolling>(list, row, spheres, dt, loads[row.particle - list.block.first],
                                    sums);
  };
  std::visit(add_under, laws_.model().force, laws_.model().rolling);
  return sums.book;
}

}  // namespace pmr::physics
