// An experiment: measured points, an ordinary case, and how a run's figures are held against them.
#pragma once
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "study/settings.hpp"
#include "study/study.hpp"

namespace pmr::validate {

// The measured points: columns of numbers in the units of their headings, one row a point.
struct Column {
  std::string name, unit;
  std::vector<double> values;  // [point]
};
struct Points {
  std::vector<Column> columns;
  std::size_t rows = 0;
};

// A figure of a run: of its summary by path, or a column of its series at a time. Shown = factor
// times it plus offset. `key` and `column` may hold ${expressions} of the point, `at` is one.
struct Figure {
  std::string name;
  std::string key;         // "mechanics/solid_fraction"; "": of the series
  std::string column, at;  // "thermocouple.deep", "time"; without `at` the last row
  double factor = 1.0, offset = 0.0;
};

// The case as it is, or with a law or an assumption changed: a computed line of its own.
struct Variant {
  std::string name, label;
  std::vector<study::Setting> settings;
};

// How large a miss may be. All in the quantity's unit, relative ones [1].
struct Bar {
  enum class Kind { none, largest, rms, relative };
  Kind kind = Kind::none;
  double most = std::numeric_limits<double>::quiet_NaN();
  double from = -std::numeric_limits<double>::infinity();  // of the axis: points beyond are shown
  double to = std::numeric_limits<double>::infinity();     // but not judged

  bool judges(double x) const { return x >= from && x <= to; }
};

// What is compared: expressions of columns, constants and figures.
struct Quantity {
  std::string name, label, unit;
  std::string computed, measured, deviation;  // the last: a standard deviation of the measured
  bool has_free_zero =
      false;  // the measured ones have no zero of their own: mean misses are taken off
  Bar bar;
  std::string on_miss;  // a paragraph: the cause, or the best explanation and what would settle it
};

// The slope of a straight line through all points, as of an exponent.
struct Slope {
  std::string name, label;
  std::string x, y;  // expressions, y with figures
  double measured, deviation;
  double bar;  // [unit of the slope] largest miss
  std::string on_miss;
};

struct Axis {
  std::string value, label, unit;  // value: an expression of a point
  bool is_logarithmic = false;
};

struct Experiment {
  std::filesystem::path file;
  std::string name, title, teaches, source;
  std::filesystem::path case_file;
  std::vector<std::string> sets;  // of the command line
  study::Values constants;
  std::vector<study::Setting> settings;  // laid on the case, with ${expressions} of the point
  Points points;
  std::optional<std::size_t> group;  // column by whose values the points make lines
  Axis axis;
  std::size_t replicates = 1;  // [1] seeds of each run
  std::vector<Figure> figures;
  std::vector<Variant> variants;  // at least one; the first is judged
  std::vector<Quantity> quantities;
  std::vector<Slope> slopes;
};

// Constants, and a point's columns.
study::Values known_at(const Experiment& experiment, std::size_t row);

// CaseError with all faults of the file and of its points.
Experiment read_experiment(const std::filesystem::path& file, const std::vector<std::string>& sets);

// `file` as a table of numbers with headings "name [unit]"; CaseError with all faults.
Points read_points(const std::filesystem::path& file);

}  // namespace pmr::validate
