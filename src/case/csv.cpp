#include "case/csv.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/csv_text.hpp"
#include "case/nearest.hpp"
#include "case/parts.hpp"
#include "pmr/base/text.hpp"

namespace pmr::casefile {
namespace {

struct Column {
  std::string name;
  double offset = 0.0, factor = 1.0;  // SI = offset + factor * number
};

const std::vector<NumberColumn> particle_columns{{"species", Dimension::none},
                                                 {"x", Dimension::length},
                                                 {"y", Dimension::length},
                                                 {"z", Dimension::length},
                                                 {"vx", Dimension::speed},
                                                 {"vy", Dimension::speed},
                                                 {"vz", Dimension::speed},
                                                 {"wx", Dimension::spin},
                                                 {"wy", Dimension::spin},
                                                 {"wz", Dimension::spin},
                                                 {"temperature", Dimension::temperature},
                                                 {"radius", Dimension::length}};

class Sheet {
 public:
  Sheet(Reading& reading, std::string file, std::vector<NumberColumn> known)
      : reading_(reading), file_(std::move(file)), known_(std::move(known)) {}

  void read_header(const CsvLine& line) {
    header_ = line.number;
    for (const std::string& cell : cells_of(line.text)) {
      Column column = read_column(cell);
      if (has(column.name)) fault(header_, column.name, "the column stands twice");
      columns_.push_back(std::move(column));
    }
  }

  void require(std::initializer_list<const char*> names) {
    for (const char* name : names)
      if (!has(name)) fault(header_, name, "the column is missing");
  }

  ExplicitParticle read_row(const CsvLine& line, std::span<const Species> species) {
    const std::vector<std::string> cells = row_of(line);
    ExplicitParticle particle{0, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), {}, {}};
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (columns_[k].name == "species")
        particle.species =
            species_index(reading_, {file_, line.number, 1}, "species", cells[k], species);
      else
        store(particle, columns_[k].name, read_number(line.number, columns_[k], cells[k]));
    }
    return particle;
  }

  // The numbers of a row, each to its column in the order of the known ones.
  void read_numbers(const CsvLine& line, std::vector<std::vector<double>>& columns) {
    const std::vector<std::string> cells = row_of(line);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto at = find(columns_[k].name) - known_.begin();
      columns[static_cast<std::size_t>(at)].push_back(
          read_number(line.number, columns_[k], cells[k]));
    }
  }

 private:
  bool has(const std::string& name) const {
    return std::any_of(columns_.begin(), columns_.end(),
                       [&](const Column& column) { return column.name == name; });
  }

  std::vector<NumberColumn>::const_iterator find(const std::string& name) const {
    return std::find_if(known_.begin(), known_.end(),
                        [&](const NumberColumn& column) { return column.name == name; });
  }

  // As many cells as the header has, or none after a fault.
  std::vector<std::string> row_of(const CsvLine& line) {
    std::vector<std::string> cells = cells_of(line.text);
    if (cells.size() == columns_.size()) return cells;
    fault(line.number, "",
          fmt::format("has {} cells; the header has {}", cells.size(), columns_.size()));
    return {};
  }

  void fault(unsigned line, const std::string& key, const std::string& problem) {
    reading_.fault({file_, line, 1}, key, problem);
  }

  Column read_column(const std::string& cell) {
    const Heading heading = heading_of(cell);
    Column column{heading.name};
    const auto known = find(column.name);
    if (known == known_.end()) {
      std::vector<std::string> names;
      for (const NumberColumn& one : known_) names.push_back(one.name);
      fault(header_, column.name, unknown_word("column", column.name, names));
      return column;
    }
    const Dimension dimension = known->dimension;
    if (dimension == Dimension::none && !heading.unit) return column;
    if (!heading.unit) {
      fault(header_, column.name, "has no unit; wanted such as 'x [mm]'");
      return column;
    }
    const Scale scale = reading_.units.scale(*heading.unit, dimension);
    if (!scale.problem.empty()) fault(header_, column.name, scale.problem);
    return {column.name, scale.offset, scale.factor};
  }

  double read_number(unsigned line, const Column& column, const std::string& cell) {
    const std::optional<double> number = finite_number(cell);
    if (!number) fault(line, column.name, fmt::format("'{}' is no finite number", cell));
    const double value = column.offset + column.factor * number.value_or(0.0);
    if (column.name == "radius" && !(value > 0.0))
      fault(line, column.name, fmt::format("'{}' is out of range; wanted above zero", cell));
    if (column.name == "temperature" && !a_state_temperature.range.holds(value))
      fault(line, column.name,
            fmt::format("'{}' is out of range; wanted between {} and {} K", cell,
                        a_state_temperature.range.low, a_state_temperature.range.high));
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
  std::vector<NumberColumn> known_;
  std::vector<Column> columns_;  // of the file
  unsigned header_ = 1;          // [1] its line
};

// The lines of a file, its header first; none after a fault.
std::vector<CsvLine> lines_of(Reading& reading, const std::filesystem::path& file) {
  auto lines = csv_lines(file);
  if (!lines || lines->empty())
    reading.fault({file.string()}, "", lines ? "is empty" : "cannot be read");
  return lines ? *std::move(lines) : std::vector<CsvLine>{};
}

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
  const std::vector<CsvLine> lines = lines_of(reading, file);
  if (lines.empty()) return particles;
  Sheet sheet(reading, file.string(), particle_columns);
  const std::size_t before = reading.faults();
  sheet.read_header(lines.front());
  sheet.require({"species", "x", "y", "z"});
  if (reading.faults() != before) return particles;
  for (std::size_t k = 1; k < lines.size(); ++k)
    particles.push_back(sheet.read_row(lines[k], species));
  return particles;
}

std::optional<std::vector<std::vector<double>>> read_number_csv(
    Reading& reading, const std::filesystem::path& file, const std::vector<NumberColumn>& wanted) {
  const std::size_t before = reading.faults();
  const std::vector<CsvLine> lines = lines_of(reading, file);
  if (lines.empty()) return std::nullopt;
  Sheet sheet(reading, file.string(), wanted);
  sheet.read_header(lines.front());
  std::vector<std::vector<double>> columns(wanted.size());
  for (std::size_t k = 1; reading.faults() == before && k < lines.size(); ++k)
    sheet.read_numbers(lines[k], columns);
  if (reading.faults() != before) return std::nullopt;
  return columns;
}

}  // namespace pmr::casefile
