#include "physics/pair_contacts.hpp"

#include <algorithm>
#include <functional>

#include "physics/neighbours.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::physics {
namespace {

// Neighbours found for one block of particles, both ways, before the rows' places are known.
struct Found {
  std::vector<std::uint32_t> higher, lower;  // indices of partners with higher and lower ids
};

void sort_by_id(std::vector<std::uint32_t>& list, std::size_t from, const Spheres& spheres) {
  std::sort(list.begin() + static_cast<std::ptrdiff_t>(from), list.end(),
            [&](std::uint32_t a, std::uint32_t b) {
              return spheres.kinetics[a].id < spheres.kinetics[b].id;
            });
}

void copy_entry(const ContactHistory& from, std::uint32_t k, ContactHistory& to) {
  to.partner.push_back(from.partner[k]);
  to.tangential.push_back(from.tangential[k]);
  to.rolling.push_back(from.rolling[k]);
}

void sum_up(std::vector<std::uint32_t>& start) {
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
}

}  // namespace

void PairContacts::rebuild(const Spheres& spheres, double skin, const ContactHistory& history) {
  find_rows(spheres, skin);
  load_springs(spheres, history);
}

// Every particle looks around itself and so finds each pair from both ends; the owner's row and
// the partner's reverse row are written side by side, in parallel, without a sort of the whole.
void PairContacts::find_rows(const Spheres& s, double skin) {
  const std::size_t n = s.size();
  double largest = 0.0;
  for (const Sphere& a : s.sphere) largest = std::max(largest, a.radius);
  start_.assign(n + 1, 0);
  reverse_start_.assign(n + 1, 0);
  std::vector<Found> blocks((n + block_size - 1) / block_size);
  if (n > 0) {
    const CellGrid grid(s.sphere, largest + 0.5 * skin);
    parallel_blocks(n, [&](std::size_t first, std::size_t last) {
      Found& found = blocks[first / block_size];
      for (std::size_t i = first; i < last; ++i) {
        const Sphere& a = s.sphere[i];
        const ParticleId id = s.kinetics[i].id;
        const std::size_t higher = found.higher.size(), lower = found.lower.size();
        const double cube = (a.radius + largest + skin) * (1.0 + 1e-9);  // safe against rounding
        grid.for_each_near(a.position, cube, [&](std::uint32_t j, const Sphere& b) {
          const double reach = (a.radius + b.radius) + skin;
          if ((a.position - b.position).squaredNorm() >= reach * reach || j == i) return;
          (s.kinetics[j].id > id ? found.higher : found.lower).push_back(j);
        });
        sort_by_id(found.higher, higher, s);
        sort_by_id(found.lower, lower, s);
        start_[i + 1] = static_cast<std::uint32_t>(found.higher.size() - higher);
        reverse_start_[i + 1] = static_cast<std::uint32_t>(found.lower.size() - lower);
      }
    });
  }
  sum_up(start_);
  sum_up(reverse_start_);
  partner_.resize(start_[n]);
  std::vector<std::uint32_t> owner(reverse_start_[n]);
  parallel_blocks(n, [&](std::size_t first, std::size_t) {
    const Found& found = blocks[first / block_size];
    std::copy(found.higher.begin(), found.higher.end(), partner_.begin() + start_[first]);
    std::copy(found.lower.begin(), found.lower.end(), owner.begin() + reverse_start_[first]);
  });
  link_reverse(owner);
}

void PairContacts::link_reverse(const std::vector<std::uint32_t>& owner) {
  reverse_.resize(owner.size());
  parallel_for(reverse_start_.size() - 1, [&](std::size_t i) {
    for (std::uint32_t k = reverse_start_[i]; k < reverse_start_[i + 1]; ++k) {
      std::uint32_t slot = start_[owner[k]];
      while (partner_[slot] != i) ++slot;
      reverse_[k] = slot;
    }
  });
}

void PairContacts::load_springs(const Spheres& s, const ContactHistory& history) {
  touches_.assign(partner_.size(), 0);
  springs_.resize(partner_.size());
  reaction_.resize(partner_.size());
  hit_.resize(partner_.size());
  owner_.resize(partner_.size());
  parallel_for(s.size(), [&](std::size_t i) {
    for (std::uint32_t slot = start_[i]; slot < start_[i + 1]; ++slot)
      owner_[slot] = static_cast<std::uint32_t>(i);
  });
  if (history.partner.empty()) return;
  parallel_for(s.size(), [&](std::size_t i) {
    std::uint32_t k = history.start[i];
    for (std::uint32_t slot = start_[i]; slot < start_[i + 1]; ++slot) {
      const ParticleId id = s.kinetics[partner_[slot]].id;
      while (k < history.start[i + 1] && history.partner[k] < id) ++k;
      if (k == history.start[i + 1]) return;
      if (history.partner[k] != id) continue;
      touches_[slot] = 1;
      springs_[slot] = {history.tangential[k], history.rolling[k]};
    }
  });
}

ContactHistory PairContacts::history(const Spheres& s) const {
  ContactHistory h;
  h.start.assign(s.size() + 1, 0);
  parallel_for(s.size(), [&](std::size_t i) {
    for (std::uint32_t slot = start_[i]; slot < start_[i + 1]; ++slot)
      h.start[i + 1] += touches_[slot];
  });
  sum_up(h.start);
  h.partner.resize(h.start.back());
  h.tangential.resize(h.start.back());
  h.rolling.resize(h.start.back());
  parallel_for(s.size(), [&](std::size_t i) {
    std::uint32_t k = h.start[i];
    for (std::uint32_t slot = start_[i]; slot < start_[i + 1]; ++slot) {
      if (!touches_[slot]) continue;
      h.partner[k] = s.kinetics[partner_[slot]].id;
      h.tangential[k] = springs_[slot].tangential;
      h.rolling[k++] = springs_[slot].rolling;
    }
  });
  return h;
}

ContactBook PairContacts::add_forces(Spheres& spheres, const ContactLaws& laws, double dt) {
  book_.assign((spheres.size() + force_block - 1) / force_block, {});
  const auto block = [&](std::size_t first, std::size_t last) {
    const std::size_t count = find_hits(spheres, start_[first], start_[last]);
    book_[first / force_block] = add_forces_of(spheres, laws, dt, start_[first], count);
  };
  parallel_blocks(spheres.size(), std::cref(block), force_block);
  ContactBook sum;
  for (const ContactBook& b : book_) {
    sum.dissipated += b.dissipated;
    sum.overlap_ratio = std::max(sum.overlap_ratio, b.overlap_ratio);
  }
  return sum;
}

// Writes down, without a branch on the outcome, which of the slots touch; a contact that was not
// there before starts with loose springs.
std::size_t PairContacts::find_hits(const Spheres& s, std::uint32_t first, std::uint32_t last) {
  std::uint32_t* const hits = hit_.data() + first;
  std::size_t count = 0;
  for (std::uint32_t slot = first; slot < last; ++slot) {
    const Sphere &a = s.sphere[owner_[slot]], &b = s.sphere[partner_[slot]];
    const double sum = a.radius + b.radius;
    const bool touches = (a.position - b.position).squaredNorm() < sum * sum;
    hits[count] = slot;
    count += touches ? 1 : 0;
    if (touches && !touches_[slot]) springs_[slot] = {Vec3::Zero(), Vec3::Zero()};
    touches_[slot] = touches;
  }
  return count;
}

ContactBook PairContacts::add_forces_of(Spheres& s, const ContactLaws& laws, double dt,
                                        std::size_t first_hit, std::size_t count) {
  ContactBook book;
  for (std::size_t k = first_hit; k < first_hit + count; ++k) {
    const std::uint32_t slot = hit_[k], i = owner_[slot], j = partner_[slot];
    const Sphere &a = s.sphere[i], &b = s.sphere[j];
    const Kinetics &u = s.kinetics[i], &v = s.kinetics[j];
    const Vec3 d = a.position - b.position;
    const double distance = d.norm();
    const double sum = a.radius + b.radius;
    const double overlap = std::max(0.0, sum - distance);  // rounding may deny the hit
    const double arm_i = a.radius - 0.5 * overlap, arm_j = b.radius - 0.5 * overlap;
    const Touch touch{
        (1.0 / distance) * d, overlap, u.velocity - v.velocity,   arm_i * u.spin + arm_j * v.spin,
        u.spin - v.spin,      1.0,     a.radius * b.radius / sum, u.inverse_mass + v.inverse_mass};
    const ContactForce f = evaluate(laws.between(u.species, v.species), touch, dt, springs_[slot]);
    s.load[i].force += f.force;
    s.load[i].torque -= arm_i * f.twist + f.rolling;
    reaction_[slot] = {f.force, f.rolling - arm_j * f.twist};
    book.dissipated += f.dissipated;
    const double smaller = std::min(a.radius, b.radius);
    if (overlap > book.overlap_ratio * smaller) book.overlap_ratio = overlap / smaller;
  }
  return book;
}

ContactHistory reordered(const ContactHistory& h, const std::vector<std::uint32_t>& order) {
  ContactHistory r;
  if (h.partner.empty()) {
    r.start.assign(order.size() + 1, 0);
    return r;
  }
  for (const std::uint32_t old : order) {
    for (std::uint32_t k = h.start[old]; k < h.start[old + 1]; ++k) copy_entry(h, k, r);
    r.start.push_back(static_cast<std::uint32_t>(r.partner.size()));
  }
  return r;
}

ContactHistory without(const ContactHistory& h, const std::vector<ParticleId>& gone) {
  ContactHistory r;
  for (std::size_t i = 0; i + 1 < h.start.size(); ++i) {
    for (std::uint32_t k = h.start[i]; k < h.start[i + 1]; ++k)
      if (std::find(gone.begin(), gone.end(), h.partner[k]) == gone.end()) copy_entry(h, k, r);
    r.start.push_back(static_cast<std::uint32_t>(r.partner.size()));
  }
  return r;
}

}  // namespace pmr::physics
