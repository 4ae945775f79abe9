// The simulations that a calibration asks for: made, found done, or known from a table.
#pragma once
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "calibrate/lab.hpp"
#include "study/folder.hpp"
#include "study/settings.hpp"

namespace pmr::calibrate {

// A test at values of all parameters.
struct Wanted {
  std::size_t test;
  bool is_small;
  study::Values values;  // of constants, parameters and what is derived, by name
  std::string label;     // what sets this run apart from others of the test ("1-S_mu=0.3")
  std::size_t seed;
};

struct Outcome {
  std::string name;  // of the run's folder
  std::size_t test;
  bool is_small;
  std::size_t seed;
  std::string case_hash;          // of what is simulated, titles and output aside
  std::string status;             // "completed" or "failed"
  std::string reason;             // of a failure
  std::vector<double> responses;  // one to a target of the test, in its unit; NaN: none
  bool is_known = false;          // from the table: there is no folder
};

// Carries out jobs; false when it was stopped before the end.
using Execute = std::function<bool(const std::vector<study::Job>&)>;

class Runs {
 public:
  // `program` is pmr, each run on `threads`. CaseError where a case is wrong at the parameters'
  // guesses, where no case knows a parameter's key, or where the table of known runs is wrong.
  Runs(const Lab& lab, const study::Folder& folder, std::string program, int threads,
       Execute execute);

  // What came of each, in order. Runs that fail are told so; Stopped where it was interrupted, and
  // the table of runs is written either way.
  std::vector<Outcome> get(const std::vector<Wanted>& wanted);

  // Of one core, of all that is not done yet [s].
  double forecast(const std::vector<Wanted>& wanted);

  // Whether the case of a test changes with a parameter (or what is derived) of that name.
  bool reaches(const std::string& name, std::size_t test) const;
  const std::vector<Outcome>& all() const { return all_; }  // in the order first asked for
  // Of each target that no run has a figure for.
  std::vector<std::string> warnings() const;

 private:
  struct Known {
    std::string status, reason;
    std::map<std::string, double> responses;
  };
  void find_reach();
  bool takes(const std::string& key, const std::string& unit, double value, std::size_t test,
             std::vector<Fault>& faults) const;
  std::vector<std::string> settings_of(const Wanted& wanted, bool with_parameters) const;
  Outcome planned(const Wanted& wanted, study::Plan& plan);
  void write_table() const;

  const Lab& lab_;
  study::Folder folder_;
  std::string program_;
  int threads_;
  Execute execute_;
  study::Planner planner_;
  std::map<std::string, Known> known_;                  // by the case's hash and the seed
  std::map<std::string, std::set<std::size_t>> reach_;  // tests, by the parameter's name
  std::vector<Outcome> all_;
};

// The values of all constants, parameters at their guesses, and what is derived from them.
study::Values guesses(const Lab& lab);
// With what is derived from them; CaseError where a formula has no value.
study::Values completed(const Lab& lab, study::Values values);

}  // namespace pmr::calibrate
