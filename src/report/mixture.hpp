// Charts of the mixture, shared by the report of one run and the comparison.
#pragma once
#include <string>
#include <vector>

#include "report/page.hpp"

namespace pmr::report {

bool is_demonstrator(const RunData& run);
bool has_layers(const RunData& run);

// Mean mass ratio per layer, all runs in one chart, beside what was published.
std::string layer_chart(const std::vector<const RunData*>& runs, Charts& charts);
// The bed unrolled: azimuth by layer, colours over the log of w.
std::string unrolled_chart(const RunData& run, const std::string& id, const std::string& title,
                           Charts& charts);
// The honest paragraph on the demonstrator's mixture: what was measured, what this run shows.
std::string against_measurement(const RunData& run);

}  // namespace pmr::report
