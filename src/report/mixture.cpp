#include "report/mixture.hpp"

#include <algorithm>
#include <cmath>

#include "report/mixture_tables.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

bool is_demonstrator(const RunData& run) {
  std::string title = run.setup ? run.setup->title : run.summary.text("case/title");
  std::transform(title.begin(), title.end(), title.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return title.find("demonstrator") != std::string::npos;
}

std::string heading(const RunData& run) {
  const double delay = release_delay(run);
  if (!std::isfinite(delay)) return escape(run.name);
  return escape(run.name) + ", valves released " + with_unit(Quantity::time, delay) + " apart";
}

std::string unrolled_beds(const std::vector<Bed>& beds, Charts& charts) {
  if (beds.size() == 1) return unrolled_chart(beds.front(), "unrolled", "The bed unrolled", charts);
  std::string html;
  for (std::size_t b = 0; b < beds.size(); ++b)
    html += unrolled_chart(beds[b], "unrolled" + std::to_string(b + 1),
                           "The bed unrolled, " + beds[b].name, charts);
  return html;
}

std::string sections_folded(const std::vector<Bed>& beds) {
  if (beds.front().mixture.sections.empty()) return "";
  return element("details",
                 element("summary", "Mass ratio of every section") + section_table(beds));
}

}  // namespace

Section mixture_section(const std::vector<const RunData*>& runs, Charts& charts) {
  std::vector<Bed> beds;
  std::string indices, statements;
  for (const RunData* run : runs) {
    Bed bed{runs.size() == 1 ? "This run" : run->name, mixture_of(*run), is_demonstrator(*run)};
    if (bed.mixture.layers.empty()) continue;
    const std::string name = runs.size() == 1 ? "" : element("h4", heading(*run));
    indices += name + mixture_indices(bed, run->summary.number("homogeneity/lacey_index"));
    if (bed.is_demonstrator) statements += against_measurement(bed, run->settled_time());
    beds.push_back(std::move(bed));
  }
  if (beds.empty())
    return {"mixture", "Mixture", absent("No mixture: no bed was taken apart in this case.")};
  std::string html =
      indices + element("div",
                        layer_chart(beds, charts) + element("div", unrolled_beds(beds, charts)),
                        "class=\"charts\"");
  html += beds.size() == 1 ? layer_table(beds.front()) : compared_layers(beds);
  html += azimuth_chart(beds, charts) + sections_folded(beds) + statements;
  return {"mixture", "Mixture", html};
}

}  // namespace pmr::report
