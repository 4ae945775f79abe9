#include "case/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "case/csv_text.hpp"
#include "case/nearest.hpp"

namespace pmr::casefile {
namespace {

struct Column {
  std::string name;
  double offset = 0.0, factor = 1.0;  // SI = offset + factor * number
};

const std::vector<std::string> known_columns{"species", "x",  "y",  "z",  "vx",          "vy",
                                             "vz",      "wx", "wy", "wz", "temperature", "radius"};

Dimension dimension_of(const std::string& column) {
  if (column.size() == 1 || column == "radius") return Dimension::length;
  if (column == "temperature") return Dimension::temperature;
  return column[0] == 'v' ? Dimension::speed : Dimension::spin;
}

class Sheet {
 public:
  Sheet(Reading& reading, std::string file) : reading_(reading), file_(std::move(file)) {}

  void read_header(const std::string& line) {
    for (const std::string& cell : cells_of(line)) columns_.push_back(read_column(cell));
    for (const char* name : {"species", "x", "y", "z"})
      if (std::none_of(columns_.begin(), columns_.end(),
                       [&](const Column& column) { return column.name == name; }))
        fault(1, name, "the column is missing");
  }

  ExplicitParticle read_row(unsigned line_number, const std::string& line,
                            std::span<const Species> species) {
    const std::vector<std::string> cells = cells_of(line);
    ExplicitParticle particle{0, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), {}, {}};
    if (cells.size() != columns_.size()) {
      fault(line_number, "",
            fmt::format("has {} cells; the header has {}", cells.size(), columns_.size()));
      return particle;
    }
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (columns_[k].name == "species")
        particle.species =
            species_index(reading_, {file_, line_number, 1}, "species", cells[k], species);
      else
        store(particle, columns_[k].name, read_number(line_number, columns_[k], cells[k]));
    }
    return particle;
  }

 private:
  void fault(unsigned line, const std::string& key, const std::string& problem) {
    reading_.fault({file_, line, 1}, key, problem);
  }

  Column read_column(const std::string& cell) {
    const Heading heading = heading_of(cell);
    Column column{heading.name};
    if (std::find(known_columns.begin(), known_columns.end(), column.name) == known_columns.end()) {
      fault(1, column.name, unknown_word("column", column.name, known_columns));
      return column;
    }
    if (column.name == "species") return column;
    if (!heading.unit) {
      fault(1, column.name, "has no unit; wanted such as 'x [mm]'");
      return column;
    }
    const Dimension dimension = dimension_of(column.name);
    const Quantities ends = reading_.units.parse("0 1 " + *heading.unit, dimension);
    if (!ends.problem.empty()) {
      fault(1, column.name, ends.problem);
      return column;
    }
    column.offset = ends.values[0];
    column.factor = ends.values[1] - ends.values[0];
    return column;
  }

  double read_number(unsigned line, const Column& column, const std::string& cell) {
    const std::optional<double> number = finite_number(cell);
    if (!number) fault(line, column.name, fmt::format("'{}' is no finite number", cell));
    const double value = column.offset + column.factor * number.value_or(0.0);
    if ((column.name == "radius" || column.name == "temperature") && !(value > 0.0))
      fault(line, column.name, fmt::format("'{}' is out of range; wanted above zero", cell));
    return value;
  }

  static void store(ExplicitParticle& particle, const std::string& column, double value) {
    if (column == "radius") {
      particle.radius = value;
    } else if (column == "temperature") {
      particle.temperature = value;
    } else {
      const int component = column.back() - 'x';
      Vec3& target = column.size() == 1 ? particle.position
                     : column[0] == 'v' ? particle.velocity
                                        : particle.spin;
      if (component >= 0 && component < 3) target[component] = value;
    }
  }

  Reading& reading_;
  std::string file_;
  std::vector<Column> columns_;
};

}  // namespace

SpeciesIndex species_index(Reading& reading, const Place& place, const std::string& key,
                           const std::string& name, std::span<const Species> species) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < species.size(); ++k) {
    if (species[k].name == name) return static_cast<SpeciesIndex>(k);
    names.push_back(species[k].name);
  }
  reading.fault(place, key, unknown_word("species", name, names));
  return 0;
}

std::vector<ExplicitParticle> read_particles_csv(Reading& reading,
                                                 const std::filesystem::path& file,
                                                 std::span<const Species> species) {
  std::vector<ExplicitParticle> particles;
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line)) {
    reading.fault({file.string()}, "", "cannot be read, or is empty");
    return particles;
  }
  Sheet sheet(reading, file.string());
  const std::size_t before = reading.faults();
  sheet.read_header(line);
  if (reading.faults() != before) return particles;
  for (unsigned number = 2; std::getline(in, line); ++number)
    if (!trimmed(line).empty()) particles.push_back(sheet.read_row(number, line, species));
  return particles;
}

}  // namespace pmr::casefile
