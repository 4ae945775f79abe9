// The page under construction: sections in order, and the data its scripts draw from.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "report/run_data.hpp"
#include "report/value.hpp"

namespace pmr::report {

struct Section {
  std::string id;     // "pictures", the anchor
  std::string title;  // "Pictures"
  std::string html;
};

// Chart data: columns of numbers, each stored once, and charts that refer to them by name.
class Charts {
 public:
  // Returns the name under which the scripts find the column.
  std::string column(const std::string& name, const std::vector<double>& values);
  // Adds a chart and returns the figure that holds its place. `spec` is read by page/*.js.
  std::string add(const std::string& id, const std::string& title, Value spec,
                  const std::string& caption = "");
  std::string to_json() const;

 private:
  std::set<std::string> known_;
  Value columns_ = Value(Value::Object());
  Value charts_ = Value(Value::Object());
};

std::string absent(const std::string& reason);  // the one line instead of what is left out

Section answer_section(const RunData& run);
Section picture_section(const RunData& run);
Section course_section(const RunData& run, Charts& charts);
Section books_section(const RunData& run, Charts& charts);
Section conductivity_section(const RunData& run, Charts& charts);  // where it was measured
// Where the case has a heap, openings that catch, or forces on walls.
bool has_bulk_tests(const RunData& run);
Section bulk_tests_section(const RunData& run, Charts& charts);
Section reproduction_section(const RunData& run);

std::string assemble(const std::string& title, const std::string& subtitle,
                     const std::vector<Section>& sections, const Charts& charts);

}  // namespace pmr::report
