// From a study to the runs it asks for, and the mixings that they share.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pmr/base/errors.hpp"
#include "pmr/state/state.hpp"
#include "sim/forecast.hpp"
#include "study/study.hpp"

namespace pmr::study {

struct PlannedRun {
  std::string name;                      // of its folder, made of its values
  std::vector<double> values;            // one per variable, in its unit; the place of a level
  std::optional<std::size_t> replicate;  // from 1, which is its seed; none: the case's own seed
  std::string case_text;                 // the whole case as TOML; "" where there is none
  std::string fault;                     // why there is none
  std::optional<std::size_t> mixing;  // index into Plan::mixings; none: it moves its own particles
  double seconds = 0.0;               // [s] forecast on one core, without the mixing
};

// The motion of the particles, which is the same for all runs of equal mechanics.
struct Mixing {
  std::string name;       // content hash, 16 hexadecimal digits
  std::string case_text;  // of the first run that wants it
  double seconds = 0.0;   // [s] forecast on one core
};

struct Plan {
  std::vector<PlannedRun> runs;  // points in the order of the design, replicates of each together
  std::vector<Mixing> mixings;
};

// Makes a plan run by run. Unit costs are measured once, with the first case: all runs are on one
// machine.
class Planner {
 public:
  // Lays the settings on the case and adds the run that comes of it to the plan. What is wrong with
  // the case: none if it is sound; else the run stands in the plan with its `fault`.
  std::vector<Fault> add(Plan& plan, PlannedRun run, const std::filesystem::path& case_file,
                         const std::vector<std::string>& settings);

 private:
  std::optional<sim::UnitCosts> costs_;
  std::string bed_of_;  // bed and mechanical text of the case that these particles were read for
  Particles bed_;
};

// The points of the design as values of the variables.
std::vector<std::vector<double>> design_points(const Study& study);

// Reads the case of every run. A case that is wrong at some points is told there (`fault`); wrong
// at all of them, it is CaseError.
Plan make_plan(const Study& study);

// "key=value", with the unit where there is one, as `--set` takes it.
std::string key_setting(const std::string& key, const std::string& unit, double value);

// A name for a folder: letters, digits and . - = _ stand, other characters become one '-'.
std::string safe_name(const std::string& text);

// "2.5", "1100 degC", or the name of the level.
std::string value_text(const Variable& variable, double value);

}  // namespace pmr::study
