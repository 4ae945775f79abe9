#include "physics/insertion.hpp"

#include <algorithm>
#include <cmath>

#include "physics/deposition.hpp"
#include "physics/neighbours.hpp"
#include "physics/pouring.hpp"
#include "physics/upright.hpp"
#include "physics/wall_overlaps.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"

namespace pmr::physics {
namespace {

// Distance of neighbours in a layer [1] of the diameter. The rest to 1 is for the jitter: looser
// takes height, tighter keeps the order of the lattice.
constexpr double lattice_spacing = 1.05;
// Distance of layers [1] of the sum of their radii: spheres of two layers never overlap.
constexpr double layer_spacing = 1.001;
// Layers without a single particle after which a region counts as too narrow.
constexpr int most_empty_layers = 16;
constexpr double most_places = 1.0e7;    // [1] of a layer: a region this wide is a mistake
constexpr std::size_t most_faults = 10;  // of one kind

struct Placed {
  SpeciesIndex species;
  double radius;  // [m]
  Vec3 position;  // [m]
};

bool is_same(const Region& a, const Region& b) {
  if (a.index() != b.index()) return false;
  if (const auto* p = std::get_if<CylinderRegion>(&a)) {
    const auto& q = std::get<CylinderRegion>(b);
    return p->base == q.base && p->radius == q.radius && p->inner_radius == q.inner_radius &&
           p->height == q.height;
  }
  const auto &p = std::get<BoxRegion>(a), &q = std::get<BoxRegion>(b);
  return p.low == q.low && p.high == q.high;
}

// Species that share a region.
struct Group {
  Ground ground;
  std::vector<SpeciesIndex> members;
};

std::vector<Group> groups(const Case& c) {
  std::vector<Group> all;
  for (std::size_t s = 0; s < c.species.size(); ++s) {
    if (!c.species[s].region) continue;
    const auto shares = [&](const Group& g) {
      return is_same(*c.species[g.members.front()].region, *c.species[s].region);
    };
    auto found = std::find_if(all.begin(), all.end(), shares);
    if (found == all.end()) {
      found = all.insert(all.end(), Group{ground(*c.species[s].region), {}});
    }
    found->members.push_back(static_cast<SpeciesIndex>(s));
  }
  return all;
}

// True where the layers do not lie across gravity.
bool is_tilted(const Case& c) {
  const auto up = up_against(c.gravity);
  return up && std::abs(up->z()) < 1.0 - 1e-9;
}

// Every so many of the places: a layer that is not full lies thinner everywhere, not on one side.
std::vector<Vec3> thinned(std::vector<Vec3> places, std::size_t wanted) {
  if (places.size() <= wanted) return places;
  for (std::size_t k = 0; k < wanted; ++k)
    places[k] = places[(2 * k + 1) * places.size() / (2 * wanted)];
  places.resize(wanted);
  return places;
}

// Places of one full layer of spheres at height z [m] above the ground, shifted by up to `lift` [m]
// up or down.
std::vector<Vec3> layer(const Ground& g, double diameter, double z, double lift, Random random) {
  const double a = lattice_spacing * diameter, row = a * std::sqrt(0.75);
  const double jitter = 0.5 * (lattice_spacing - 1.0) * diameter;
  const Eigen::Rotation2Dd turn(2.0 * pi * random.uniform());
  const double u = random.uniform(), v = random.uniform();
  const int count = static_cast<int>(g.reach / row) + 2;
  std::vector<Vec3> places;
  for (int k = -count; k <= count; ++k)
    for (int l = -count - 1; l <= count + 1; ++l) {
      const double angle = 2.0 * pi * random.uniform();
      const double shift = jitter * std::sqrt(random.uniform());
      const Eigen::Vector2d node((l + u + 0.5 * (k & 1)) * a, (k + v) * row);
      const Eigen::Vector2d d =
          turn * node + shift * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      const double shifted = lift > 0.0 ? z + lift * (2.0 * random.uniform() - 1.0) : z;
      const Vec3 x = g.centre + Vec3(d[0], d[1], shifted);
      if (g.holds(x, 0.5 * diameter)) places.push_back(x);
    }
  return places;
}

struct Filling {
  std::vector<Placed> placed;
  double height = 0.0;      // [m] that they take
  std::size_t fitting = 0;  // [1] of them below the region's top
  bool is_too_narrow = false;
};

// Takes turns among the species of a group, so that they are placed in proportion.
class Turns {
 public:
  Turns(const Case& c, const Group& group) {
    for (const SpeciesIndex s : group.members) left_.push_back(c.species[s].count);
    count_ = left_;
  }
  // The member that lags behind most.
  std::size_t next() const {
    std::size_t next = 0;
    for (std::size_t m = 1; m < left_.size(); ++m)
      if (share_left(m) > share_left(next)) next = m;
    return next;
  }
  std::size_t left(std::size_t member) const { return left_[member]; }
  std::size_t placed(std::size_t member) const { return count_[member] - left_[member]; }
  void take(std::size_t member, std::size_t count) { left_[member] -= count; }

 private:
  double share_left(std::size_t m) const {
    return count_[m] > 0 ? static_cast<double>(left_[m]) / static_cast<double>(count_[m]) : 0.0;
  }
  std::vector<std::size_t> left_, count_;
};

// Stacks layers until all are placed. Layers that gravity does not press onto each other are
// jittered out of their planes, too: a flat one would fall as it is, edge on, and stand as a wall
// one particle thick, for no force in it points out of its plane.
Filling stack(const Case& c, const Group& group, std::uint64_t key) {
  Filling f;
  Turns turns(c, group);
  const double spacing = is_tilted(c) ? lattice_spacing : layer_spacing;
  int empty = 0;
  for (std::uint64_t number = 0; empty < most_empty_layers; ++number) {
    const std::size_t next = turns.next();
    if (turns.left(next) == 0) return f;
    const SpeciesIndex s = group.members[next];
    const double diameter = c.species[s].diameter;
    const double lift = is_tilted(c) ? 0.5 * (lattice_spacing - 1.0) * diameter : 0.0;
    const double z = f.height + 0.5 * diameter + lift;
    const auto places = thinned(
        layer(group.ground, diameter, z, lift, Random(c.seed, Purpose::insertion, key, number)),
        turns.left(next));
    empty = places.empty() ? empty + 1 : 0;
    if (places.empty()) continue;
    f.height += spacing * diameter;
    turns.take(next, places.size());
    for (const Vec3& x : places) f.placed.push_back({s, 0.5 * diameter, x});
    if (f.height <= group.ground.height) f.fitting = f.placed.size();
  }
  f.is_too_narrow = true;
  return f;
}

// Lets all down one by one, for sizes that differ.
Filling let_down(const Case& c, const Group& group, std::uint64_t key) {
  Filling f;
  std::vector<double> radii;
  Turns turns(c, group);
  for (std::size_t m = turns.next(); turns.left(m) > 0; m = turns.next()) {
    const Species& species = c.species[group.members[m]];
    radii.push_back(
        0.5 * (species.diameters.empty() ? species.diameter : species.diameters[turns.placed(m)]));
    f.placed.push_back({group.members[m], radii.back(), Vec3::Zero()});
    turns.take(m, 1);
  }
  const std::vector<Vec3> places = deposit(group.ground, radii, c.seed, key);
  f.is_too_narrow = places.size() < f.placed.size();
  f.placed.resize(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    f.placed[k].position = places[k];
    const double top = places[k][2] + radii[k] - group.ground.centre[2];
    f.height = std::max(f.height, top);
    f.fitting += top <= group.ground.height ? 1 : 0;
  }
  return f;
}

Filling fill(const Case& c, const Group& group, std::uint64_t key) {
  const bool differ = std::any_of(group.members.begin(), group.members.end(),
                                  [&](SpeciesIndex s) { return !c.species[s].diameters.empty(); });
  return differ ? let_down(c, group, key) : stack(c, group, key);
}

void place(Particles& p, const Case& c, const Placed& placed) {
  const double radius = placed.radius;
  const Species& species = c.species[placed.species];
  const std::size_t i = p.size();
  resize(p, i + 1);
  p.id[i] = static_cast<ParticleId>(i);
  p.species[i] = placed.species;
  p.radius[i] = radius;
  p.mass[i] =
      c.materials.list[species.material].density * 4.0 / 3.0 * pi * radius * radius * radius;
  p.position[i] = placed.position;
  p.temperature[i] = species.initial_temperature;
}

Particles place_all(const Case& c, std::vector<Fault>& faults) {
  Particles p;
  std::uint64_t key = 0;
  for (const Group& group : groups(c)) {
    const Filling f = fill(c, group, key++);
    std::size_t wanted = 0;
    for (const SpeciesIndex s : group.members) wanted += c.species[s].count;
    const std::string name = "species." + c.species[group.members.front()].name + ".region";
    if (f.is_too_narrow)
      faults.push_back({"case", name, "is too narrow for a single particle"});
    else if (f.fitting < f.placed.size())
      faults.push_back({"case", name,
                        "holds " + std::to_string(f.fitting) + " of " + std::to_string(wanted) +
                            " particles; all of them need a height of " +
                            std::to_string(1e3 * f.height) + " mm instead of " +
                            std::to_string(1e3 * group.ground.height) + " mm"});
    for (const Placed& placed : f.placed) place(p, c, placed);
  }
  for (const ExplicitParticle& e : c.particles) {
    place(p, c, {e.species, e.radius.value_or(0.5 * c.species[e.species].diameter), e.position});
    p.velocity.back() = e.velocity;
    p.spin.back() = e.spin;
    if (e.temperature) p.temperature.back() = *e.temperature;
  }
  return p;
}

std::string name_of(const Case& c, const Particles& p, std::size_t i) {
  const std::size_t first_explicit = p.size() - c.particles.size();
  if (i >= first_explicit) return "particles[" + std::to_string(i - first_explicit) + "]";
  return "species." + c.species[p.species[i]].name;
}

void find_places_outside(const Case& c, const Particles& p, std::vector<Fault>& faults) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < p.size() && found < most_faults; ++i) {
    const auto x = p.position[i].array();
    if ((x >= c.domain_low.array()).all() && (x <= c.domain_high.array()).all()) continue;
    faults.push_back({"case", name_of(c, p, i), "a particle starts outside the domain"});
    ++found;
  }
}

void find_overlaps(const Case& c, const Particles& p, std::vector<Fault>& faults) {
  std::size_t found = 0;
  for (const NeighbourPair& pair : pairs_within(p, 0.0)) {
    const double overlap = -pair.gap / std::min(p.radius[pair.i], p.radius[pair.j]);
    if (overlap <= largest_opening_overlap) continue;
    faults.push_back({"case", name_of(c, p, pair.j),
                      "a particle starts with an overlap of " + std::to_string(100.0 * overlap) +
                          " % of the radius with one of " + name_of(c, p, pair.i) +
                          "; at most 10 %"});
    if (++found == most_faults) return;
  }
}

void find_in_walls(const Case& c, const Particles& p, std::vector<Fault>& faults) {
  const double begin = begin_of_run(c);
  const auto is_there = [&](const Surface& surface) { return is_present(surface, begin); };
  for (const DeepInWall& deep :
       wall_overlaps(p, c.walls, begin, largest_opening_overlap, is_there).excessive)
    faults.push_back({"case", name_of(c, p, deep.deepest),
                      "at the start " + to_text(deep, p, c.walls, largest_opening_overlap)});
  for (const DeepInWall& deep :
       grain_overlaps(p, c.walls, begin, largest_opening_overlap).excessive)
    faults.push_back(
        {"case", name_of(c, p, deep.deepest),
         "at the start, by its grains, " + to_text(deep, p, c.walls, largest_opening_overlap)});
}

// Too wide a region, or too narrow particles: its layers could not be looked through.
void find_too_wide(const Case& c, std::vector<Fault>& faults) {
  for (const Species& species : c.species) {
    if (!species.region || species.count == 0) continue;
    const double across = 2.0 * ground(*species.region).reach / smallest_diameter(species);
    if (across * across > most_places)
      faults.push_back({"case", "species." + species.name + ".region",
                        "is more than 3000 diameters of the smallest particle wide"});
  }
}

Particles place_and_check(const Case& c, std::vector<Fault>& faults) {
  find_too_wide(c, faults);
  if (!faults.empty()) return {};
  Particles p = place_all(c, faults);
  for (Fault& fault : pouring_faults(c)) faults.push_back(std::move(fault));
  find_places_outside(c, p, faults);
  if (p.size() > 1) find_overlaps(c, p, faults);
  find_in_walls(c, p, faults);
  return p;
}

}  // namespace

Particles insert(const Case& c) {
  std::vector<Fault> faults;
  Particles p = place_and_check(c, faults);
  if (!faults.empty()) throw CaseError(std::move(faults));
  return p;
}

std::vector<Fault> insertion_faults(const Case& c) {
  std::vector<Fault> faults;
  place_and_check(c, faults);
  return faults;
}

}  // namespace pmr::physics
