#include "physics/pouring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "physics/ground.hpp"
#include "physics/spheres.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"

namespace pmr::physics {
namespace {

constexpr int inlet_places_tried = 64;  // [1] for one particle in one call

double end_of_motion(const Case& c) {  // [s]
  return c.mix ? c.mix->duration : 0.0;
}

double mass_of(const Case& c, const Entry& e) {
  return c.materials.list[c.species[e.species].material].density * 4.0 / 3.0 * pi * e.radius *
         e.radius * e.radius;
}

void add_entries(const Case& c, SpeciesIndex s, std::vector<Entry>& all) {
  const Species& species = c.species[s];
  const Pour& source = *species.pour;
  double due = std::max(source.begin, begin_of_run(c));
  for (std::size_t k = 0; k < species.count; ++k) {
    const double d = species.diameters.empty() ? species.diameter : species.diameters[k];
    all.push_back({due, s, 0.5 * d});
    due += std::isnan(source.mass_rate) ? 1.0 / source.particle_rate
                                        : mass_of(c, all.back()) / source.mass_rate;
  }
}

// Spheres that a newcomer may meet.
class Company {
 public:
  void add(const Vec3& position, double radius) { spheres_.push_back({position, radius}); }
  bool leaves_free(const Vec3& x, double radius) const {
    return std::none_of(spheres_.begin(), spheres_.end(), [&](const Sphere& other) {
      const double reach = radius + other.radius;
      return (other.position - x).squaredNorm() < reach * reach;
    });
  }

 private:
  std::vector<Sphere> spheres_;
};

// Those near the sources.
Company company_of(const Case& c, const Particles& p) {
  Company company;
  for (const Species& species : c.species) {
    if (!species.pour) continue;
    const Ground g = ground(species.pour->region);
    const double most = 0.5 * largest_diameter(species);
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vec3 d = p.position[i] - g.centre;
      const double reach = p.radius[i] + most;
      if (d.head<2>().norm() < g.reach + reach && d[2] > -reach - most &&
          d[2] < g.height + reach + most)
        company.add(p.position[i], p.radius[i]);
    }
  }
  return company;
}

std::optional<Vec3> free_place(const Ground& g, const Company& company, double radius,
                               Random random) {
  const double room = std::max(0.0, g.height - 2.0 * radius);
  for (int k = 0; k < inlet_places_tried; ++k) {
    const double u = 2.0 * random.uniform() - 1.0, v = 2.0 * random.uniform() - 1.0;
    const double z = 0.5 * g.height + room * (random.uniform() - 0.5);
    const Vec3 x = g.centre + Vec3(g.reach * u, g.reach * v, z);
    if (g.holds(x, radius) && company.leaves_free(x, radius)) return x;
  }
  return std::nullopt;
}

// The newcomer's row in a history that has rows.
void add_row(ContactHistory& history, std::size_t particles) {
  if (history.start.size() == particles) history.start.push_back(history.start.back());
}

void move_in(State& state, std::size_t k, const Vec3& position, const Vec3& velocity) {
  Particles& p = state.particles;
  const std::size_t i = p.size();
  const auto append = [](auto& to, const auto& from) { to.push_back(from); };
  append(p.id, state.waiting.id[k]);
  append(p.species, state.waiting.species[k]);
  append(p.radius, state.waiting.radius[k]);
  append(p.mass, state.waiting.mass[k]);
  append(p.position, position);
  append(p.velocity, velocity);
  append(p.spin, Vec3(Vec3::Zero()));
  append(p.force, Vec3(Vec3::Zero()));
  append(p.torque, Vec3(Vec3::Zero()));
  append(p.formula_units, state.waiting.formula_units[k]);
  append(p.delta, state.waiting.delta[k]);
  append(p.enthalpy, state.waiting.enthalpy[k]);
  append(p.temperature, state.waiting.temperature[k]);
  add_row(state.pair_contacts, i + 1);
  add_row(state.wall_contacts, i + 1);
}

}  // namespace

double begin_of_run(const Case& c) { return c.fill ? -c.fill->duration : 0.0; }

std::vector<Entry> entries(const Case& c) {
  std::vector<Entry> all;
  for (std::size_t s = 0; s < c.species.size(); ++s)
    if (c.species[s].pour && c.bed.empty()) add_entries(c, static_cast<SpeciesIndex>(s), all);
  std::stable_sort(all.begin(), all.end(),
                   [](const Entry& a, const Entry& b) { return a.due < b.due; });
  return all;
}

Particles waiting_particles(const Case& c, ParticleId first) {
  const std::vector<Entry> all = entries(c);
  Particles p;
  resize(p, all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    p.id[k] = first + static_cast<ParticleId>(k);
    p.species[k] = all[k].species;
    p.radius[k] = all[k].radius;
    p.mass[k] = mass_of(c, all[k]);
    p.temperature[k] = c.species[all[k].species].initial_temperature;
  }
  return p;
}

std::size_t pour(const Case& c, const std::vector<Entry>& all, State& state) {
  const std::size_t left = state.waiting.size(), gone = all.size() - left;
  std::size_t came = 0;
  if (left == 0 || all[gone].due > state.time) return 0;
  Company company = company_of(c, state.particles);
  for (; came < left && all[gone + came].due <= state.time; ++came) {
    const Pour& source = *c.species[all[gone + came].species].pour;
    const double radius = state.waiting.radius[came];
    const auto place =
        free_place(ground(source.region), company, radius,
                   Random(c.seed, Purpose::pouring, state.waiting.id[came], state.interval));
    if (!place) break;
    company.add(*place, radius);
    move_in(state, came, *place, source.velocity);
  }
  for_each_field(state.waiting, [&](const char*, const char*, auto& field) {
    field.erase(field.begin(), field.begin() + static_cast<std::ptrdiff_t>(came));
  });
  return came;
}

std::vector<Fault> pouring_faults(const Case& c) {
  std::vector<Fault> faults;
  for (const Species& species : c.species) {
    if (!species.pour || !c.bed.empty()) continue;
    const std::string key = "species." + species.name + ".pour";
    const Ground g = ground(species.pour->region);
    const double d = largest_diameter(species);
    const double width = g.half[0] > 0.0 ? 2.0 * g.half.minCoeff() : g.reach - g.inner;
    if (d > (g.inner > 0.0 || g.half[0] > 0.0 ? width : 2.0 * g.reach))
      faults.push_back(
          {"case", key, fmt::format("is too narrow for a particle of {:.4g} mm", 1e3 * d)});
    const Vec3 side = g.half[0] > 0.0 ? Vec3(g.half[0], g.half[1], 0) : Vec3(g.reach, g.reach, 0);
    const Vec3 low = g.centre - side, high = g.centre + side + Vec3(0, 0, g.height);
    if ((low.array() < c.domain_low.array()).any() || (high.array() > c.domain_high.array()).any())
      faults.push_back({"case", key, "lies outside the domain"});
  }
  const std::vector<Entry> all = entries(c);
  if (!all.empty() && all.back().due >= end_of_motion(c))
    faults.push_back({"case", "species." + c.species[all.back().species].name + ".pour",
                      fmt::format("the last particle is due at {:.4g} s; wanted before the motion "
                                  "ends at {:.4g} s",
                                  all.back().due, end_of_motion(c))});
  return faults;
}

}  // namespace pmr::physics
