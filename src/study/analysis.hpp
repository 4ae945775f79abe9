// What the results of a study say: fitted curves, what matters most, what was best.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "statistics/ranking.hpp"
#include "statistics/surrogate.hpp"
#include "study/results.hpp"

namespace pmr::study {

// Runs that share the levels of all variables that are no numbers; a surrogate joins only those.
struct Group {
  std::string name;               // of the levels, "" where there are none
  std::vector<double> levels;     // of each variable that has levels, in order
  std::vector<std::size_t> rows;  // completed runs
};

// The variables that are numbers and take more than one value.
std::vector<std::size_t> numeric_variables(const Study& study, const Plan& plan);
std::vector<Group> groups_of(const Study& study, const Plan& plan, const Results& results);

// One response of one group over the numeric variables.
struct Fit {
  std::size_t response, group;
  std::vector<std::array<double, 2>> ends;  // of each numeric variable in runs with this figure
  statistics::Surrogate surrogate;
};
std::vector<Fit> fit_all(const Study& study, const Plan& plan, const Results& results,
                         const std::vector<Group>& groups);

// Whether a sampled design asks what uncertain inputs do.
bool is_sampled(const Study& study);

// How a response follows from the numeric variables, by ranks, over all runs.
statistics::Ranking rank(const Study& study, const Plan& plan, const Results& results,
                         std::size_t response);

// Rows that no other row beats in both: more gain at no more cost.
std::vector<std::size_t> pareto_front(const Results& results, std::size_t gain, std::size_t cost);

// Place of a response by its name.
std::size_t response_index(const Study& study, const std::string& name);

}  // namespace pmr::study
