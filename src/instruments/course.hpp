// What the instruments of a run recorded, as CSV files in DIR/instruments.
#pragma once
#include <filesystem>
#include <optional>

#include "instruments/contact_layers.hpp"
#include "instruments/decomposition.hpp"
#include "io/run_file.hpp"

namespace pmr::instruments {

// Columns of the run's series by name; absent ones are left out, and a file without any but time
// is not written:
//   gauge.csv          pressure
//   oxygen.csv         oxygen_pressure, oxygen_released, oxygen_pumped
//   thermocouples.csv  thermocouple.NAME for each of the case
//   catch.csv          catch.NAME and catch.NAME.SPECIES for each opening of the case
//   wall_force.csv     wall_force.NAME.x ... wall_torque.NAME.z likewise
// and from the final bed, where the case has a decomposition tool and two species:
//   decomposition.csv  a row per layer, then the residuum (layer = number of layers + 1)
//   sections.csv       a row per layer and sector
// and from the final bed, where there is one:
//   contacts.csv       a row per layer of one height: what its particles touch
// where it has a heap:
//   heap.csv           a row per ring of its profile
// and where something was caught:
//   landings.csv       a row per particle: time, opening (its place in the order of names), species
//                      (likewise), mass, place
void write_instruments(const std::filesystem::path& dir, const Case& setup,
                       const io::Series& series, const State& state);

// The decomposition of a bed by the case's tool; none without a tool or a pair of species.
std::optional<BedSections> decompose(const Case& setup, const Particles& bed);

// Contacts in ten layers; none without particles.
std::vector<ContactLayer> contact_layers(const Case& setup, const Particles& bed);

// The two tables of it.
io::Series layer_table(const BedSections& sections, const Decomposition& tool);
io::Series section_table(const BedSections& sections, const Decomposition& tool);

}  // namespace pmr::instruments
