#include "instruments/course.hpp"

#include <limits>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "instruments/heap.hpp"
#include "instruments/section_ratios.hpp"
#include "io/series.hpp"
#include "physics/upright.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/storage_error.hpp"

namespace pmr::instruments {
namespace {

constexpr std::size_t layers_of_contacts = 10;  // [1] enough to see a trend over the height

// A table that grows by rows.
class TableWriter {
 public:
  explicit TableWriter(const std::vector<std::pair<const char*, const char*>>& heads) {
    for (const auto& [name, unit] : heads) table_.columns.push_back({name, unit, {}});
  }
  void add_row(const std::vector<double>& row) {
    ensure(row.size() == table_.columns.size(), "a row has a value for each column");
    for (std::size_t c = 0; c < row.size(); ++c) table_.columns[c].values.push_back(row[c]);
  }
  io::Series take() { return std::move(table_); }

 private:
  io::Series table_;
};

io::Series selection(const io::Series& series, const std::vector<std::string>& names) {
  io::Series chosen;
  if (series.columns.empty()) return chosen;
  chosen.columns.push_back(series.columns.front());
  for (const std::string& name : names)
    for (const io::Column& column : series.columns)
      if (column.name == name) chosen.columns.push_back(column);
  return chosen;
}

void write_selection(const std::filesystem::path& path, const io::Series& series,
                     const std::vector<std::string>& names) {
  const io::Series chosen = selection(series, names);
  if (chosen.columns.size() > 1) io::write_csv(path, chosen);
}

// A column of ratios; rows beyond its values get NaN.
void add_column(io::Series& table, const char* name, std::vector<double> values) {
  values.resize(table.rows(), std::numeric_limits<double>::quiet_NaN());
  table.columns.push_back({name, "1", std::move(values)});
}

std::filesystem::path make_folder(const std::filesystem::path& dir) {
  std::error_code error;
  std::filesystem::create_directories(dir, error);
  if (error) throw StorageError(dir.string() + ": folder cannot be made: " + error.message());
  return dir;
}

// Each particle with the mass that its material's stated density gives it: oxygen that has left is
// no change of the mixture.
Particles as_stated(const Case& setup, Particles bed) {
  for (std::size_t i = 0; i < bed.size(); ++i) {
    const double r = bed.radius[i];
    bed.mass[i] = setup.materials.list[setup.species[bed.species[i]].material].density * 4.0 / 3.0 *
                  pi * r * r * r;
  }
  return bed;
}

// The profile of a heap: a row a ring.
io::Series heap_table(const Heap& heap) {
  TableWriter table({{"radius", "m"}, {"top", "m"}, {"deviation", "m"}, {"cells", "1"}});
  for (const HeapRing& ring : heap.rings)
    table.add_row({ring.radius, ring.top, ring.deviation, static_cast<double>(ring.cells)});
  return table.take();
}

io::Series landing_table(const State& state) {
  TableWriter table({{"time", "s"},
                     {"opening", "1"},
                     {"species", "1"},
                     {"mass", "kg"},
                     {"x", "m"},
                     {"y", "m"},
                     {"z", "m"}});
  for (const CaughtParticle& p : state.caught)
    table.add_row({p.time, static_cast<double>(p.by), static_cast<double>(p.species), p.mass,
                   p.position.x(), p.position.y(), p.position.z()});
  return table.take();
}

void write_bulk_tests(const std::filesystem::path& folder, const Case& setup,
                      const io::Series& series, const State& state) {
  std::vector<std::string> caught, forces;
  for (const CatchInstrument& one : setup.catches) {
    caught.push_back("catch." + one.name);
    for (const Species& species : setup.species)
      caught.push_back("catch." + one.name + "." + species.name);
  }
  for (const WallForce& wall : setup.wall_forces)
    for (const char* what : {"force.", "torque."})
      for (const char* axis : {".x", ".y", ".z"})
        forces.push_back(std::string("wall_") + what + wall.name + axis);
  write_selection(folder / "catch.csv", series, caught);
  write_selection(folder / "wall_force.csv", series, forces);
  if (!state.caught.empty()) io::write_csv(folder / "landings.csv", landing_table(state));
  if (!setup.heap) return;
  if (const auto heap = measure_heap(state.particles, *setup.heap))
    io::write_csv(folder / "heap.csv", heap_table(*heap));
}

}  // namespace

std::optional<BedSections> decompose(const Case& setup, const Particles& bed) {
  const auto sides = beads_and_granules(setup);
  if (!setup.decomposition || !sides) return std::nullopt;
  return decompose(as_stated(setup, bed), *setup.decomposition, *sides);
}

std::vector<ContactLayer> contact_layers(const Case& setup, const Particles& bed) {
  const Vec3 up = physics::up_against(setup.gravity).value_or(Vec3::UnitZ());
  return contact_layers(bed, setup.species.size(), up, layers_of_contacts);
}

io::Series layer_table(const BedSections& sections, const Decomposition& tool) {
  TableWriter table({{"layer", "1"},
                     {"mass", "kg"},
                     {"thickness", "m"},
                     {"top", "m"},
                     {"mass_ratio", "1"},
                     {"sector_mean_ratio", "1"},
                     {"left_right_asymmetry", "1"}});
  std::vector<Layer> layers = sections.layers;
  layers.push_back(sections.residuum);
  const SectionRatios ratios = section_ratios({layers, {}});
  const Asymmetry asymmetry = left_right_asymmetry(ratios);
  for (std::size_t k = 0; k < layers.size(); ++k)
    table.add_row({static_cast<double>(k + 1), layers[k].mass, layers[k].thickness(), layers[k].top,
                   layers[k].content.mass_ratio(), sector_mean(ratios[k]), asymmetry.layers[k]});
  io::Series result = table.take();
  if (tool.reference) {
    const Deviation from = deviation(section_ratios(sections), *tool.reference);
    add_column(result, "reference_mass_ratio", tool.reference->layers);
    add_column(result, "deviation", from.layers);
  }
  return result;
}

io::Series section_table(const BedSections& sections, const Decomposition& tool) {
  TableWriter table({{"layer", "1"},
                     {"azimuth", "deg"},
                     {"mass_ratio", "1"},
                     {"bead_mass", "kg"},
                     {"granule_mass", "kg"},
                     {"beads", "1"},
                     {"granules", "1"}});
  for (std::size_t k = 0; k < sections.layers.size(); ++k)
    for (std::size_t s = 0; s < sections.layers[k].sectors.size(); ++s) {
      const Portion& section = sections.layers[k].sectors[s];
      table.add_row({static_cast<double>(k + 1), sector_azimuth(tool, s) * 180.0 / pi,
                     section.mass_ratio(), section.bead_mass, section.granule_mass,
                     static_cast<double>(section.beads), static_cast<double>(section.granules)});
    }
  return table.take();
}

void write_instruments(const std::filesystem::path& dir, const Case& setup,
                       const io::Series& series, const State& state) {
  const Particles& bed = state.particles;
  const std::filesystem::path folder = make_folder(dir / "instruments");
  write_selection(folder / "gauge.csv", series, {"pressure"});
  std::vector<std::string> oxygen{"oxygen_pressure", "oxygen_released"};
  for (const Species& species : setup.species) oxygen.push_back("oxygen_released." + species.name);
  oxygen.emplace_back("oxygen_pumped");
  write_selection(folder / "oxygen.csv", series, oxygen);
  std::vector<std::string> probes;
  for (const Thermocouple& probe : setup.thermocouples)
    probes.push_back("thermocouple." + probe.name);
  write_selection(folder / "thermocouples.csv", series, probes);
  write_bulk_tests(folder, setup, series, state);
  if (const auto sections = decompose(setup, bed)) {
    io::write_csv(folder / "decomposition.csv", layer_table(*sections, *setup.decomposition));
    io::write_csv(folder / "sections.csv", section_table(*sections, *setup.decomposition));
  }
  if (const auto layers = contact_layers(setup, bed); !layers.empty()) {
    std::vector<std::string> species;
    for (const Species& one : setup.species) species.push_back(one.name);
    io::write_csv(folder / "contacts.csv", contact_table(layers, species));
  }
}

}  // namespace pmr::instruments
