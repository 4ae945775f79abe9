// Species and explicit particles.
#include <fmt/format.h>

#include <cmath>

#include "case/csv.hpp"
#include "case/nearest.hpp"
#include "case/parts.hpp"
#include "case/regions.hpp"
#include "case/sizes.hpp"
#include "chemistry/kinetics.hpp"
#include "chemistry/redox.hpp"
#include "pmr/base/constants.hpp"

namespace pmr::casefile {
namespace {

constexpr std::size_t most_species = 255;  // SpeciesIndex is a byte
constexpr double densest_random = 0.64;    // [1] solid fraction of random close packing
constexpr double most_particles = 4.0e9;   // ParticleId is 32 bits
constexpr double room_temperature = zero_celsius + 20.0;  // [K] where nothing depends on it
constexpr double most_drawn = 4.0e8;  // [1] typical particles; their sizes are kept in memory

double sphere_volume(double diameter) { return pi / 6.0 * diameter * diameter * diameter; }  // [m3]

InitialDelta read_delta(Table& table) {
  const Want delta{Dimension::none, {0.0, 3.0, true, true}};
  const Node* node = table.need(table.moves_nothing("delta"),
                                "a number, or {equilibrium_at = \"700 degC\", oxygen = "
                                "\"21278 Pa\"}");
  if (node == nullptr) return 0.0;
  if (node->find("equilibrium_at") == nullptr && node->find("oxygen") == nullptr)
    return table.value("delta", delta);
  Table inner(table.reading(), *node, table.path("delta"));
  return EquilibriumDelta{inner.value("equilibrium_at", a_state_temperature),
                          inner.value("oxygen", {Dimension::pressure, positive})};
}

// [1/s] |d(delta)/dt| of a fresh particle without oxygen around it, where the rate is largest.
double first_rate(const Material& material, double temperature, double delta) {
  const double concentration = chemistry::formula_unit_concentration(material);
  const chemistry::RateState fresh{temperature, delta, 0.0, concentration};
  return std::abs(2.0 * chemistry::oxygen_rate(*material.redox, fresh) / concentration);
}

// A delta so near to nothing that its equilibrium pressure is none that a gas could have: the
// network would have to follow a change within less than rounding of any time.
void check_delta(Table& table, const Material& material, const Species& species, bool reacts) {
  // Runs at 673 and 1173 K went well at 9e29, and not from 2e32 on.
  constexpr double fastest = 1e31;  // [1/s]
  const RedoxEquilibrium& equilibrium = material.redox->equilibrium;
  const double T = species.initial_temperature;
  const auto starts = [&](double delta) { return first_rate(material, T, delta) < fastest; };
  if (const double* delta = std::get_if<double>(&species.initial_delta)) {
    if (*delta >= equilibrium.delta_limit)
      table.fault("delta", fmt::format("wanted below {}", equilibrium.delta_limit));
    else if (reacts && *delta > 0.0 && std::isfinite(T) && !starts(*delta))
      table.fault("delta",
                  fmt::format("of {} no reaction can start at {} K: wanted more", *delta, T));
    return;
  }
  const auto& frozen = std::get<EquilibriumDelta>(species.initial_delta);
  const bool is_read = a_state_temperature.range.holds(frozen.temperature) &&
                       frozen.oxygen_pressure > 0.0 && T > 0.0;
  if (!reacts || !is_read) return;
  // A law that could not be read, or is not unique anywhere, is told where it stands.
  const double least = equilibrium.fit_temperature_minimum;
  if (!(least > 0.0) || !chemistry::is_stable(equilibrium, least)) return;
  if (!chemistry::is_stable(equilibrium, frozen.temperature)) {
    table.fault("delta",
                fmt::format("the law has no unique equilibrium at {} K: wanted a number, or "
                            "a higher temperature",
                            frozen.temperature));
    return;
  }
  const auto delta_at = [&](double temperature) {
    return chemistry::equilibrium_delta(equilibrium, temperature, frozen.oxygen_pressure);
  };
  if (starts(delta_at(frozen.temperature))) return;
  double low = frozen.temperature, high = std::max(low, T);  // it rises with the temperature
  while (high - low > 0.5) (starts(delta_at(0.5 * (low + high))) ? high : low) = 0.5 * (low + high);
  table.fault(
      "delta",
      fmt::format(
          "an equilibrium at {} K is too cold: of a delta of {:.1e} no reaction can start at {} K; "
          "wanted {:.0f} K or more",
          frozen.temperature, delta_at(frozen.temperature), T, std::ceil(high)));
}

double volume_of(const CylinderRegion& r) {  // [m3]
  return pi * (r.radius * r.radius - r.inner_radius * r.inner_radius) * r.height;
}
double volume_of(const BoxRegion& r) { return (r.high - r.low).prod(); }  // [m3]

void check_room(Table& table, const Species& species) {
  if (!species.region) return;
  const double room =
      std::visit([](const auto& region) { return volume_of(region); }, *species.region);
  const double solid = solid_volume(species);
  if (solid > densest_random * room)
    table.fault("region", fmt::format("{} particles of {:.4g} mm do not fit: they are {:.4g} cm3 "
                                      "of solid, the region holds at most {:.4g} cm3",
                                      species.count, species.diameter * 1e3, solid * 1e6,
                                      densest_random * room * 1e6));
}

// mass: count = round(mass / (density * volume)), the density as the material states it.
void read_amount(Table& table, const Material& material, Species& species) {
  const double each = material.density * sphere_volume(species.diameter);
  const bool by_count = table.has("count");
  if (by_count && table.has("mass")) table.fault("count", "wanted mass or count, not both");
  if (by_count) {
    species.count = table.count("count", 1);
    table.look("mass");
    species.requested_mass = static_cast<double>(species.count) * each;
    return;
  }
  const bool is_explicit = !table.has("region") && !table.has("pour") && !table.has("mass");
  if (is_explicit) return;
  species.requested_mass = table.value("mass", {Dimension::mass, positive});
  const double count = std::round(species.requested_mass / each);
  if (count > most_particles) table.fault("mass", "makes too many particles");
  if (species.requested_mass > 0.0 && count < 1.0) table.fault("mass", "is less than one particle");
  if (count >= 1.0 && count <= most_particles) species.count = static_cast<std::size_t>(count);
}

// mass: particles are drawn until it is met as closely as one particle allows.
void draw_amount(Table& table, const physics::SizeDistribution& sizes,
                 const physics::SizeSample& sample, Species& species) {
  const double typical = sample.density * sphere_volume(physics::diameter_at(sizes, 0.5));
  const bool by_count = table.has("count");
  if (by_count && table.has("mass")) table.fault("count", "wanted mass or count, not both");
  if (!species.region && !species.pour)
    table.fault("size", "wanted a region or pour to draw particles for");
  if (by_count) {
    table.look("mass");
    species.diameters = physics::sizes_of_count(sizes, sample, table.count("count", 1));
  } else {
    const double mass = table.value("mass", {Dimension::mass, positive});
    if (mass > most_drawn * typical)
      table.fault("mass", "makes too many particles");
    else
      species.diameters = physics::sizes_of_mass(sizes, sample, mass);
    species.requested_mass = mass;
  }
  species.count = species.diameters.size();
  if (species.count == 0) return;
  species.diameter = physics::sauter_diameter(species.diameters);
  if (by_count) species.requested_mass = sample.density * solid_volume(species);
}

// Size and amount; those of the bed stand where there is one.
void read_particles_of(Table& table, const Material& material, std::size_t index,
                       const ParticleSetting& at, Species& species) {
  if (at.has_bed) {
    for (const char* unread : {"mass", "count", "size"}) table.look(unread);
    species.diameter = table.value("diameter", a_length, 0.0);
    return;
  }
  if (table.has("size")) {
    const auto sizes = read_sizes(table);
    if (table.look("diameter") != nullptr) table.fault("size", "wanted diameter or size, not both");
    if (sizes)
      draw_amount(table, *sizes, {at.seed, index, material.density}, species);
    else
      for (const char* unread : {"mass", "count"}) table.look(unread);
  } else {
    table.look("size");
    species.diameter = table.value("diameter", a_length);
    read_amount(table, material, species);
  }
  check_room(table, species);
}

Species read_one(Table& table, const std::string& name, std::size_t index, MaterialBook& book,
                 const ParticleSetting& at) {
  Species species{};
  species.name = name;
  species.material = book.use(table, "material", MaterialBook::Role::particle);
  species.dump_type = static_cast<std::uint32_t>(table.count("dump_type", 1, 0));
  table.moves_nothing("temperature");
  species.initial_temperature =
      at.heat ? table.value("temperature", a_state_temperature)
              : table.value("temperature", a_state_temperature, room_temperature);
  species.region = read_region(table, at.rig, at.rig_is_faulty);
  species.pour = read_pour(table);
  if (table.has("region") && table.has("pour"))
    table.fault("pour", "wanted region or pour, not both");
  if (table.node().find("material") == nullptr || book.empty()) {
    table.ignore_rest();
    return species;
  }
  const Material& material = book[species.material];
  read_particles_of(table, material, index, at, species);
  if (material.redox) {
    species.initial_delta = read_delta(table);
    check_delta(table, material, species, at.reacts);
  } else if (table.has("delta")) {
    table.look("delta");
    table.fault("delta", fmt::format("material '{}' holds no oxygen to give", material.name));
  }
  return species;
}

void check_dump_types(Table& root, const std::vector<Species>& all) {
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (all[k].dump_type != 0 && all[k].dump_type == all[j].dump_type)
        root.fault("species", fmt::format("{} and {} have the same dump_type {}", all[j].name,
                                          all[k].name, all[k].dump_type));
}

ExplicitParticle read_particle(Table& table, std::span<const Species> species) {
  ExplicitParticle particle{};
  const std::string name = table.word("species", "the name of a species");
  if (!name.empty())
    particle.species = species_index(table.reading(), table.node().find("species")->place,
                                     table.path("species"), name, species);
  particle.position = table.vector("position", Dimension::length);
  particle.velocity = table.vector("velocity", Dimension::speed, Vec3::Zero());
  particle.spin = table.vector("spin", Dimension::spin, Vec3::Zero());
  particle.temperature = table.maybe(table.moves_nothing("temperature"), a_state_temperature);
  particle.radius = table.maybe("radius", a_length);
  return particle;
}

}  // namespace

std::vector<Species> read_species(Table& root, MaterialBook& book, const ParticleSetting& at) {
  std::vector<Species> all;
  root.need_table("species");
  for_each_table(root, "species", [&](Table& table, const std::string& name) {
    all.push_back(read_one(table, name, all.size(), book, at));
  });
  check_dump_types(root, all);
  if (all.size() > most_species) root.fault("species", "wanted at most 255 species");
  return all;
}

std::vector<ExplicitParticle> read_particles(Table& root, std::span<const Species> species) {
  std::vector<ExplicitParticle> all;
  const Node* node = root.look("particles");
  if (node == nullptr) return all;
  if (node->is_table()) {
    Table table(root.reading(), *node, "particles");
    const std::string file = table.file("csv", "the name of a CSV file");
    return file.empty() ? all : read_particles_csv(root.reading(), file, species);
  }
  if (node->kind != Node::Kind::array) {
    root.fault("particles", "wanted [[particles]] or {csv = \"file.csv\"}");
    return all;
  }
  for (std::size_t k = 0; k < node->items.size(); ++k) {
    Table table(root.reading(), node->items[k], fmt::format("particles.{}", k));
    all.push_back(read_particle(table, species));
  }
  return all;
}

void count_explicit(Table& root, Case& made) {
  std::vector<std::size_t> count(made.species.size(), 0);
  for (const ExplicitParticle& particle : made.particles)
    if (particle.species < count.size()) ++count[particle.species];
  for (std::size_t k = 0; k < count.size(); ++k) {
    Species& species = made.species[k];
    const auto fault = [&](const std::string& problem) {
      root.reading().fault(root.node().find("species")->place, "species." + species.name, problem);
    };
    const bool is_filled = species.region || species.pour;
    if (is_filled && count[k] > 0)
      fault("has a region or pour and explicit particles; wanted one of them");
    if (is_filled) continue;
    if (count[k] == 0) fault("has no particles: wanted a region, pour, or [[particles]] of it");
    if (species.count != 0 && species.count != count[k])
      fault(fmt::format("asks for {} particles, but {} are given one by one", species.count,
                        count[k]));
    species.count = count[k];
    species.requested_mass = static_cast<double>(count[k]) *
                             made.materials.list[species.material].density *
                             sphere_volume(species.diameter);
  }
}

}  // namespace pmr::casefile
