// Section 6: how to get the same again.
#include <cmath>

#include "report/page.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

// From the summary, else from the run file's header.
std::string known(const RunData& run, const std::string& key) {
  std::string direct = run.summary.text(key);
  if (!direct.empty()) return direct;
  std::string provenance = run.summary.text("provenance/" + key);
  if (!provenance.empty()) return provenance;
  const auto found = run.header.provenance.find(key);
  return found == run.header.provenance.end() ? "" : found->second;
}

std::string facts(const RunData& run) {
  struct Row {
    const char* key;
    const char* label;
  };
  static constexpr Row wanted[] = {{"version", "version"},
                                   {"git", "source revision"},
                                   {"case_hash", "hash of the case"},
                                   {"bed", "bed taken from"},
                                   {"bed_hash", "hash of that file"},
                                   {"state_hash", "hash of the final state"},
                                   {"threads", "threads"},
                                   {"machine", "machine"},
                                   {"status", "status"}};
  std::vector<std::vector<std::string>> rows;
  for (const Row& row : wanted) {
    const std::string value = known(run, row.key);
    if (!value.empty()) rows.push_back({row.label, "<code>" + escape(value) + "</code>"});
  }
  return table({}, rows, "class=\"facts\"");
}

std::string timings(const RunData& run) {
  double total = 0.0;
  for (const Member& m : run.summary.members("timing"))
    total = std::max(total, m.value.as_number());
  if (!(total > 0.0)) return absent("No timings were recorded.");
  std::vector<std::vector<std::string>> rows;
  for (const Member& m : run.summary.members("timing")) {
    const double share = m.value.as_number() / total;
    const std::string width = std::to_string(std::lround(100.0 * share));
    rows.push_back({escape(m.key), with_unit(Quantity::time, m.value.as_number()),
                    "<i class=\"meter\" style=\"width:" + width + "%\"></i>"});
  }
  return element("h3", "Where the time went") +
         table({"stage", "wall time", ""}, rows, "class=\"numbers timing\"");
}

}  // namespace

Section reproduction_section(const RunData& run) {
  std::string html;
  const std::string command = known(run, "command");
  html += command.empty() ? absent("The command was not recorded.")
                          : element("pre", escape(command), "class=\"command\"");
  html += facts(run) + timings(run);
  html += element("details", element("summary", "The case, as it was read") +
                                 element("pre", escape(run.header.case_text), "class=\"case\""));
  return {"reproduction", "Reproduction", html};
}

}  // namespace pmr::report
