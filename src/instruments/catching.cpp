#include "instruments/catching.hpp"

#include <algorithm>
#include <limits>

namespace pmr::instruments {
namespace {

// An opening with its plane's unit normal towards where particles come from.
struct Plane {
  const CatchInstrument* opening;
  Vec3 normal;  // [1]

  double over(const Vec3& x) const { return (x - opening->corner).dot(normal); }  // [m]
  bool holds(const Vec3& x) const {
    const Vec3 from = x - opening->corner;
    const double u = from.dot(opening->along), v = from.dot(opening->across);
    return u >= 0.0 && u <= opening->along.squaredNorm() && v >= 0.0 &&
           v <= opening->across.squaredNorm();
  }
};

// [1] of the way at which it is crossed; above 1: not.
double crossing(const Plane& plane, const Vec3& from, const Vec3& to) {
  const double before = plane.over(from), after = plane.over(to);
  if (!(before >= 0.0 && after < 0.0)) return 2.0;
  const double part = before / (before - after);
  return plane.holds(from + part * (to - from)) ? part : 2.0;
}

std::vector<Plane> planes_of(const Case& c) {
  std::vector<Plane> planes;
  for (const CatchInstrument& one : c.catches)
    planes.push_back({&one, one.along.cross(one.across).normalized()});
  return planes;
}

}  // namespace

std::vector<CaughtParticle> crossings(const Case& c, const State& before, const State& after) {
  std::vector<CaughtParticle> caught;
  if (c.catches.empty()) return caught;
  const std::vector<Plane> planes = planes_of(c);
  constexpr auto none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(after.opening.particles, none);  // by id
  for (std::uint32_t i = 0; i < before.particles.size(); ++i) place[before.particles.id[i]] = i;
  const Particles& p = after.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (place[p.id[i]] == none) continue;  // came in meanwhile
    const Vec3& from = before.particles.position[place[p.id[i]]];
    double first = 1.5;
    std::uint32_t by = 0;
    for (std::uint32_t k = 0; k < planes.size(); ++k) {
      const double part = crossing(planes[k], from, p.position[i]);
      if (part < first) by = k;
      first = std::min(first, part);
    }
    if (first > 1.0) continue;
    caught.push_back({p.id[i], p.species[i], by, before.time + first * (after.time - before.time),
                      p.mass[i], from + first * (p.position[i] - from)});
  }
  std::sort(caught.begin(), caught.end(), [](const CaughtParticle& a, const CaughtParticle& b) {
    return a.time != b.time ? a.time < b.time : a.id < b.id;
  });
  return caught;
}

std::vector<Caught> caught_so_far(const Case& c, const State& state) {
  std::vector<Caught> all;
  std::vector<double> last(c.catches.size(), 0.0);  // [s] arrival
  for (const CatchInstrument& one : c.catches)
    all.push_back({one.name, 0.0, std::vector<double>(c.species.size(), 0.0), one.threshold, {}});
  for (const CaughtParticle& p : state.caught) {
    Caught& caught = all[p.by];
    const bool is_reached =
        caught.threshold && !caught.time_to_threshold && caught.mass + p.mass >= *caught.threshold;
    if (is_reached)
      caught.time_to_threshold =
          caught.mass > 0.0
              ? last[p.by] + (*caught.threshold - caught.mass) / p.mass * (p.time - last[p.by])
              : p.time;
    last[p.by] = p.time;
    caught.mass += p.mass;
    caught.by_species[p.species] += p.mass;
  }
  return all;
}

bool ends_motion(const Case& c, const State& state) {
  const auto all = caught_so_far(c, state);
  for (std::size_t k = 0; k < all.size(); ++k)
    if (c.catches[k].ends_motion && all[k].time_to_threshold) return true;
  return false;
}

}  // namespace pmr::instruments
