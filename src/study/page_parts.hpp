// The sections of a study's page.
#pragma once
#include "report/page.hpp"
#include "study/analysis.hpp"

namespace pmr::study {

// All that the sections draw from.
struct Findings {
  const Study& study;
  const Plan& plan;
  const Results& results;
  const Folder& folder;
  std::vector<std::size_t> numeric;  // variables
  std::vector<Group> groups;
  std::vector<Fit> fits;
};

report::Section answer_part(const Findings& f);
std::string trends(const Findings& f);  // what each response does over the one variable
report::Section response_part(const Findings& f, report::Charts& charts);  // over the variables
report::Section trust_part(const Findings& f);                             // of the surrogates
report::Section ranking_part(const Findings& f, report::Charts& charts);   // sampled designs
report::Section trade_off_part(const Findings& f, report::Charts& charts);
report::Section picture_part(const Findings& f);  // beds at the extremes
report::Section runs_part(const Findings& f);     // every run, linked
report::Section reproduction_part(const Findings& f);

std::array<double, 2> ends_of(const Findings& f, std::size_t v);  // of a variable in the plan
// Values of the numeric variable at `place`, even on its axis, where runs have the fit's figure.
std::vector<double> abscissae(const Findings& f, const Fit& fit, std::size_t place,
                              std::size_t count);
bool is_on_log_axis(const Findings& f, std::size_t v);  // where its values span decades
const Fit* fit_of(const Findings& f, std::size_t response, std::size_t group);
bool has_values(const Findings& f, std::size_t response);
std::string unit_shown(const std::string& unit);  // "°C" for "degC"

std::string axis_title(const std::string& label, const std::string& unit);  // "label [unit]"
std::string run_link(const Findings& f, std::size_t row);   // "runs/NAME/report.html", "" if absent
std::string run_title(const Findings& f, std::size_t row);  // its values, for people

}  // namespace pmr::study
