// A study: one base case, variables laid on it, and the figures looked for in each run's summary.
#pragma once
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case/node.hpp"

namespace pmr::study {

// A key of the case and its value. Texts in the value may hold ${expression}; a text that is one
// expression alone becomes a number.
struct Setting {
  std::string key;
  casefile::Node value;
};

// One value of a variable that is no number: a name and what it sets.
struct Level {
  std::string name;
  std::vector<Setting> settings;
};

struct Variable {
  std::string name;            // stands for its value in ${...}; of a level: its place, 0, 1, ...
  std::string label;           // for people
  std::string unit;            // as written behind the value, "" for a bare number
  std::string key;             // dotted key of the case that it sets; "": only through settings
  std::string source;          // where its range comes from, "" for a design's choice
  std::vector<double> values;  // of a grid, in `unit`
  double low = std::numeric_limits<double>::quiet_NaN();  // of a sampled design, in `unit`
  double high = std::numeric_limits<double>::quiet_NaN();
  bool is_logarithmic = false;
  std::vector<Level> levels;  // instead of values
};

// A figure of summary.json; shown = factor * figure + offset, in `unit`.
struct Response {
  std::string name, label, unit;
  std::string key;  // "thermal/temperature_mean/SrFeO3"
  double factor = 1.0, offset = 0.0;
};

// A column of the runs' series whose spread over the runs is drawn over time.
struct Band {
  std::string name, label, unit, column;
  double factor = 1.0, offset = 0.0;
};

// Variables that are normal and depend on each other, such as parameters that a calibration found.
struct Correlated {
  std::vector<std::size_t> variables;  // their places among all
  std::vector<double> mean;            // in the variables' units
  std::vector<std::vector<double>> covariance;
  std::vector<double> low, high;  // values beyond are put there
};

enum class DesignKind { grid, latin_hypercube, sobol };
struct Design {
  DesignKind kind = DesignKind::grid;
  std::size_t samples = 0;  // [1] of a sampled design
  std::uint64_t seed = 1;
};

// Two responses against each other: `gain` is wanted high, `cost` low.
struct TradeOff {
  std::string gain, cost;  // names of responses
};

struct Study {
  std::filesystem::path file;
  std::string text;            // the TOML as read, with what it extends
  std::string title, teaches;  // a paragraph on what the study is for
  std::filesystem::path case_file;
  std::size_t replicates = 1;               // [1] runs of each point, with seeds 1, 2, ...
  std::map<std::string, double> constants;  // none that a variable is named as
  std::vector<std::pair<std::string, std::string>> derived;  // names and their expressions
  std::vector<Variable> variables;                           // in the order of the file
  std::vector<Correlated> correlated;                        // some of the variables
  Design design;
  std::vector<Setting> settings;
  std::vector<std::string> sets;  // of the command line, laid on the case of every run
  std::vector<Response> responses;
  std::vector<Band> bands;
  std::optional<TradeOff> trade_off;
};

// Reads a study file. Each of `sets` names a constant of the study, or else is laid on the case of
// every run. CaseError with all faults, as of a case.
Study read_study(const std::filesystem::path& file, const std::vector<std::string>& sets);

}  // namespace pmr::study
