// A calibration: tests that were made in a lab, each with the case that simulates it, and the
// parameters that their results are to tell, stage by stage.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pmr/base/constants.hpp"
#include "statistics/design.hpp"
#include "statistics/posterior.hpp"
#include "study/study.hpp"

namespace pmr::calibrate {

// A figure of a test that was measured. Its errors are standard deviations in its unit.
struct Target {
  study::Response response;
  double value = nan;            // measured
  double error = nan;            // of the measured value
  std::size_t runs = 1;          // [1] experiments behind it
  std::string source;            // of the measured value
  double floor = 0.0;            // of the simulation: what no surrogate and no experiment says
  double discrepancy = 0.0;      // of the model, added where it is known to be wrong
  bool is_logarithmic = false;   // the surrogate is of its logarithm
  std::optional<double> beyond;  // where a run ends without the figure, it is above this
};

// A figure of a run's summary that says that it came to nothing, such as grains left in a hopper.
struct Limit {
  study::Response figure;
  double most;  // a run with more is lost to all responses of its test
};

struct Test {
  std::string name, label;
  std::filesystem::path case_file;
  std::vector<study::Setting> settings;  // laid on the case
  std::vector<study::Setting> small;     // besides, of the cheaper sample; none: there is none
  std::size_t pairs = 0;                 // [1] points run both small and in full
  std::size_t predictions = 3;           // [1] seeds of the runs at the parameters found
  std::size_t synthetic = 5;             // [1] experiments, where the program makes the results
  std::vector<Target> targets;
  std::vector<Limit> limits;
};

struct Parameter {
  std::string name, label, unit;
  std::string key;     // dotted key of the cases that it sets; "": only through settings
  std::string source;  // of box and prior
  statistics::Span box{nan, nan};
  double guess = nan;                       // its value in stages before its own
  std::optional<statistics::Normal> prior;  // none: even over the box
  std::optional<double> reference;          // found elsewhere, for comparison
};

// A parameter that follows from others.
struct Derived {
  std::string name, label, unit, key, formula;
  std::optional<double> reference;
};

// A target by its places.
struct TargetIndex {
  std::size_t test, target;
};

struct Sampling {
  std::size_t points;      // [1] of the first design, a Latin hypercube
  std::size_t most;        // [1] points with those added where they tell most
  std::size_t replicated;  // [1] points of the first design that are run with several seeds
  std::size_t replicates;  // [1] seeds of each of these
  std::size_t batch;       // [1] points added at a time
  std::uint64_t seed;      // of the hypercube
};

struct Stage {
  std::string name, title;
  std::vector<Parameter> parameters;
  std::vector<TargetIndex> use;     // whose levels tell the parameters
  std::vector<TargetIndex> decide;  // which choose between modes
  Sampling sampling;
};

struct Lab {
  std::filesystem::path file;
  std::string text;            // TOML as read, with what it extends; names of cases are absolute
  std::string title, teaches;  // a paragraph on what it is for
  std::map<std::string, double> constants;
  std::vector<study::Setting> settings;  // laid on the case of every test
  std::vector<std::string> sets;         // of the command line, laid on every case
  std::vector<Test> tests;
  std::vector<Stage> stages;
  std::vector<Derived> derived;
  std::size_t rounds = 3;                      // [1] at most, of corrections from such runs
  std::optional<std::filesystem::path> known;  // CSV of runs that were made before

  const Target& target(TargetIndex at) const { return tests[at.test].targets[at.target]; }
  std::string target_name(TargetIndex at) const {
    return tests[at.test].name + "." + target(at).response.name;
  }
};

// Reads a lab file; CaseError with all faults. Each of `sets` names a constant of the file, or else
// is laid on every case.
Lab read_lab(const std::filesystem::path& file, const std::vector<std::string>& sets);

}  // namespace pmr::calibrate
