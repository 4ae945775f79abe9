#include "physics/pair_contacts.hpp"

#include <algorithm>

#include "pmr/base/parallel.hpp"

namespace pmr::physics {
namespace {

// How many sub-steps lists are to last, and bounds on their skins: of the near list [1] of the wide
// one's; of the wide list and the horizon [1] of the thinnest wide skin.
constexpr double steps_of_near_list = 14.0, thinnest_near_skin = 0.4;
constexpr double steps_of_wide_list = 30.0, thickest_wide_skin = 5.0;
constexpr double steps_of_horizon = 100.0, farthest_horizon = 20.0;
constexpr double far_horizons = 3.0;  // how far blocks around reach past the farthest horizon [1]
constexpr double worn = 0.5;  // what may be left of a wide list's skin [1] that is searched anew

void copy_entry(const ContactHistory& from, std::uint32_t k, ContactHistory& to) {
  to.partner.push_back(from.partner[k]);
  to.tangential.push_back(from.tangential[k]);
  to.rolling.push_back(from.rolling[k]);
}

void sum_up(std::vector<std::uint32_t>& start) {
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
}

Triple<double> triple(const Vec3& v) { return {v[0], v[1], v[2]}; }
Vec3 vec3(const Triple<double>& t) { return {t.x, t.y, t.z}; }

Springs<double> springs_of(const PairGroup& g, std::size_t lane) {
  return {{g.tangential[0][lane], g.tangential[1][lane], g.tangential[2][lane]},
          {g.rolling[0][lane], g.rolling[1][lane], g.rolling[2][lane]}};
}

void put_springs(PairGroup& g, std::size_t lane, const Springs<double>& s) {
  const double d[3] = {s.tangential.x, s.tangential.y, s.tangential.z};
  const double m[3] = {s.rolling.x, s.rolling.y, s.rolling.z};
  for (std::size_t k = 0; k < 3; ++k) {
    g.tangential[k][lane] = d[k];
    g.rolling[k][lane] = m[k];
  }
}

// Seen from the other particle.
Springs<double> reversed(const Springs<double>& s) {
  return {-1.0 * s.tangential, -1.0 * s.rolling};
}

// visit(i, j, springs)
template <class Visit>
void for_each_touching(const std::vector<PairGroup>& groups, const Visit& visit) {
  for (const PairGroup& g : groups)
    for (std::uint32_t left = g.touching; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
      visit(g.i[lane] / PairGroup::index_step, g.j[lane] / PairGroup::index_step,
            springs_of(g, lane));
    }
}

}  // namespace

struct PairContacts::Remembered {
  struct Entry {
    std::uint32_t partner;
    Springs<double> springs;  // of the pair in order
  };
  std::vector<std::uint32_t> start;  // [own + 1]
  std::vector<Entry> entries;

  const Springs<double>* find(std::uint32_t row, std::uint32_t partner) const {
    for (std::uint32_t k = start[row]; k < start[row + 1]; ++k)
      if (entries[k].partner == partner) return &entries[k].springs;
    return nullptr;
  }
};

PairContacts::PairContacts(const ContactLaws& laws)
    : laws_(laws.pairs()),
      kinds_(static_cast<std::uint32_t>(laws.kinds())),
      kernel_(best_pair_kernel(places_of(laws.model()))) {}

void PairContacts::open(const Spheres& spheres, const std::vector<Block>& blocks, double dt,
                        double skin, const ContactHistory& history) {
  search_ = WideSearch(spheres, blocks);
  thinnest_ = skin;
  lists_.assign(blocks.size(), {});  // nothing of an earlier call may live on
  parallel_for(
      blocks.size(),
      [&](std::size_t b) {
        Lists& lists = lists_[b];
        lists.block = blocks[b];
        look_around(lists, spheres);
        lists.runs.resize((blocks[b].size() + run_length - 1) / run_length);
        for (Run& run : lists.runs) run.wide.around = {number_of(lists, run)};
        renew(lists, spheres, dt);
        thin_out(lists, spheres, remembered(lists, spheres, history));
      },
      1);
}

void PairContacts::follow(std::size_t b, const Spheres& spheres, double spread, double dt) {
  Lists& lists = lists_[b];
  lists.far.gone += spread * dt;
  if (lists.far.left() < 0.0) look_around(lists, spheres);
  const double outside = speed_around(lists, spheres) * dt;
  bool is_over = false;
  for (Run& run : lists.runs) {
    const double closer = speed_around(run, spheres) * dt;
    run.near_term.gone += closer;
    run.wide_term.gone += closer;
    run.horizon.gone += outside;
    is_over = is_over || run.near_term.left() < 0.0 || run.horizon.left() < 0.0;
  }
  if (!is_over) return;
  const Remembered springs = remembered(lists);
  renew(lists, spheres, dt);
  thin_out(lists, spheres, springs);
}

// What is left out stays beyond every run's horizon while `far` lasts.
void PairContacts::look_around(Lists& lists, const Spheres& spheres) const {
  const double horizon = farthest_horizon * thinnest_;
  lists.far = {far_horizons * horizon};
  lists.around = search_.blocks_around(spheres, lists.block.number, (1.0 + far_horizons) * horizon);
}

std::uint32_t PairContacts::number_of(const Lists& lists, const Run& run) {
  return lists.block.first / run_length + static_cast<std::uint32_t>(&run - lists.runs.data());
}

// Bound on the relative speed of the pairs that the run may form [m/s].
double PairContacts::speed_around(const Run& run, const Spheres& spheres) {
  VelocityRange range;
  for (const std::uint32_t r : run.wide.around) range.include(spheres.run_velocity[r]);
  return range.spread();
}

// Likewise of pairs with runs of the blocks around.
double PairContacts::speed_around(const Lists& lists, const Spheres& spheres) {
  VelocityRange range;
  for (const std::uint32_t c : lists.around) range.include(spheres.block_velocity[c]);
  return range.spread();
}

// Sets the near terms of all runs, after a new search for those that are soon at their end.
void PairContacts::renew(Lists& lists, const Spheres& spheres, double dt) const {
  const double outside = speed_around(lists, spheres) * dt;
  for (Run& run : lists.runs) {
    const double closer = speed_around(run, spheres) * dt;
    const double wanted = std::max(steps_of_near_list * closer, thinnest_near_skin * thinnest_);
    const double skin =
        std::clamp(steps_of_wide_list * closer, thinnest_, thickest_wide_skin * thinnest_);
    const bool is_worn = run.wide_term.left() < std::min(wanted, worn * skin);
    if (is_worn || run.horizon.left() <= 0.0) {
      // what is not around must stay away for as long as the list is likely to last
      const double steps = std::min(steps_of_horizon, 1.2 * skin / std::max(closer, 1e-12));
      const double horizon = std::clamp(steps * outside, skin, farthest_horizon * thinnest_);
      search_.find(spheres, number_of(lists, run), lists.around, skin, horizon, run.wide);
      run.wide_term = {skin};
      run.horizon = {horizon};
    }
    run.near_term = {std::min(wanted, run.wide_term.left())};
  }
}

ContactBook PairContacts::add_forces(std::size_t b, const Spheres& spheres, double dt,
                                     std::span<Load> loads) {
  static_assert(sizeof(Sphere) == 4 * sizeof(double) && sizeof(Kinetics) == 8 * sizeof(double) &&
                sizeof(Load) == 8 * sizeof(double));
  Lists& lists = lists_[b];
  return kernel_({.sphere = spheres.sphere[0].position.data(),
                  .kinetics = spheres.kinetics[0].velocity.data(),
                  .load = loads[0].force.data(),
                  .first = lists.block.first * PairGroup::index_step,
                  .laws = laws_.data(),
                  .groups = lists.near.data(),
                  .group_count = lists.near.size(),
                  .dt = dt});
}

// Groups hold pairs of one law, and pairs that touch apart from others, so that groups touch or not
// as a whole.
void PairContacts::thin_out(Lists& lists, const Spheres& s, const Remembered& springs) const {
  std::vector<NearRun> runs;
  for (const Run& run : lists.runs) runs.push_back({&run.wide, run.near_term.reach});
  const std::vector<NearPair> pairs = near_pairs(s, lists.block, runs, kinds_);
  lists.near.clear();
  for (std::size_t first = 0, last = 0; first < pairs.size(); first = last) {
    while (last < pairs.size() && last < first + PairGroup::count &&
           pairs[last].kind == pairs[first].kind)
      ++last;
    lists.near.push_back(group_of({&pairs[first], last - first}, lists.block, springs));
  }
}

PairGroup PairContacts::group_of(std::span<const NearPair> pairs, const Block& block,
                                 const Remembered& springs) {
  PairGroup group{};
  group.law = pairs[0].kind / 2;
  for (std::size_t lane = 0; lane < PairGroup::count; ++lane) {
    const bool is_used = lane < pairs.size();
    const auto [own, partner, kind] = pairs[is_used ? lane : 0];
    const std::uint32_t i = std::min(own, partner), j = std::max(own, partner);
    group.i[lane] = PairGroup::index_step * i;
    group.j[lane] = PairGroup::index_step * j;
    if (!is_used) continue;
    const auto bit = static_cast<std::uint8_t>(1U << lane);
    group.used |= bit;
    if (block.holds(i)) group.own_i |= bit;
    if (block.holds(j)) group.own_j |= bit;
    if (const Springs<double>* kept = springs.find(own - block.first, partner)) {
      put_springs(group, lane, *kept);
      group.touching |= bit;
    }
  }
  return group;
}

PairContacts::Remembered PairContacts::remembered(const Lists& lists) const {
  Remembered r;
  const auto own_row = [&](std::uint32_t i, std::uint32_t j) {
    return (lists.block.holds(i) ? i : j) - lists.block.first;
  };
  r.start.assign(lists.block.size() + 1, 0);
  for_each_touching(lists.near, [&](std::uint32_t i, std::uint32_t j, const Springs<double>&) {
    ++r.start[own_row(i, j) + 1];
  });
  sum_up(r.start);
  r.entries.resize(r.start.back());
  std::vector<std::uint32_t> next(r.start.begin(), r.start.end() - 1);
  for_each_touching(lists.near, [&](std::uint32_t i, std::uint32_t j, const Springs<double>& s) {
    r.entries[next[own_row(i, j)]++] = {lists.block.holds(i) ? j : i, s};
  });
  return r;
}

// The state keeps a pair in the row of its lower id, seen from there.
PairContacts::Remembered PairContacts::remembered(const Lists& lists, const Spheres& s,
                                                  const ContactHistory& history) const {
  Remembered r;
  r.start.assign(lists.block.size() + 1, 0);
  if (history.partner.empty()) return r;
  for (std::uint32_t row = 0; row < lists.block.size(); ++row) {
    const std::uint32_t i = lists.block.first + row;
    for (const std::uint32_t j : lists.runs[row / run_length].wide.row(row % run_length)) {
      const bool i_keeps = s.label[i].id < s.label[j].id;
      const std::uint32_t keeper = i_keeps ? i : j;
      const ParticleId other = s.label[i_keeps ? j : i].id;
      for (std::uint32_t e = history.start[keeper]; e < history.start[keeper + 1]; ++e) {
        if (history.partner[e] != other) continue;
        const Springs<double> springs{triple(history.tangential[e]), triple(history.rolling[e])};
        r.entries.push_back({j, keeper < (i_keeps ? j : i) ? springs : reversed(springs)});
      }
    }
    r.start[row + 1] = static_cast<std::uint32_t>(r.entries.size());
  }
  return r;
}

ContactHistory PairContacts::history(const Spheres& s, std::size_t particles) const {
  struct Entry {
    std::uint32_t keeper;
    ParticleId partner;
    Springs<double> springs;
  };
  std::vector<Entry> entries;
  for (const Lists& lists : lists_)
    for_each_touching(
        lists.near, [&](std::uint32_t i, std::uint32_t j, const Springs<double>& springs) {
          if (!lists.block.holds(i)) return;  // its own block counts it
          const ParticleId a = s.label[i].id, b = s.label[j].id;
          entries.push_back(a < b ? Entry{i, b, springs} : Entry{j, a, reversed(springs)});
        });
  std::sort(entries.begin(), entries.end(), [](const Entry& p, const Entry& q) {
    return p.keeper != q.keeper ? p.keeper < q.keeper : p.partner < q.partner;
  });
  ContactHistory h;
  h.start.assign(particles + 1, 0);
  for (const Entry& e : entries) {
    ++h.start[e.keeper + 1];
    h.partner.push_back(e.partner);
    h.tangential.push_back(vec3(e.springs.tangential));
    h.rolling.push_back(vec3(e.springs.rolling));
  }
  sum_up(h.start);
  return h;
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
