// pmr report, pmr render, pmr analyse: looks at finished runs.
#include <fmt/format.h>

#include <cstdio>

#include "case/case.hpp"
#include "case/reference.hpp"
#include "cli/console.hpp"
#include "cli/machine.hpp"
#include "cli/mixture_print.hpp"
#include "cli/start.hpp"
#include "cli/verbs.hpp"
#include "coupling/nodes.hpp"
#include "instruments/course.hpp"
#include "io/run_file.hpp"
#include "physics/time_step.hpp"
#include "pmr/base/errors.hpp"
#include "report/report.hpp"
#include "sim/summary.hpp"
#include "sim/verdict.hpp"

namespace pmr::cli {

namespace fs = std::filesystem;

namespace {

// A page takes its time: told before it is drawn.
void require_folder_of(const fs::path& file) {
  const fs::path folder = fs::absolute(file).parent_path();
  if (!fs::is_directory(folder))
    throw CaseError({{folder.string(), "", "there is no such folder"}});
}

}  // namespace

int report(const std::vector<fs::path>& folders, fs::path html,
           const report::ReportWishes& wishes) {
  if (html.empty()) html = folders.size() == 1 ? folders.front() / "report.html" : "compare.html";
  require_folder_of(html);
  report::write_report(folders, html, wishes);
  fmt::print("{}\n", html.string());
  return done;
}

int render(const RenderOptions& options) {
  const auto colour = options.colour == "delta"     ? report::Colour::delta
                      : options.colour == "species" ? report::Colour::species
                                                    : report::Colour::temperature;
  require_folder_of(options.png);
  report::render_picture(options.folder, options.time, colour, options.png);
  fmt::print("{}\n", options.png.string());
  return done;
}

int analyse(const fs::path& folder, const fs::path& reference) {
  const io::RunHeader header = io::read_header(folder);
  Case c = case_of_run(folder);
  if (!reference.empty()) casefile::set_reference(c, reference, folder.string());
  const State state = io::load_checkpoint(folder);
  const io::Series series = io::read_series(folder);
  instruments::write_instruments(folder, c, series, state);
  auto provenance = header.provenance;
  provenance["state_hash"] = hexadecimal(io::state_hash(state));
  const std::string status = state.phase != Phase::done               ? "stopped"
                             : sim::reasons_to_fail(c, state).empty() ? "completed"
                                                                      : "failed";
  sim::write_summary(folder / "instruments",
                     {c, state, coupling::number_nodes(c, state.opening.particles), Timings{},
                      series, physics::time_step(c).step, status, provenance});
  print_mixture(c, state.particles);
  fmt::print("{}\n", (folder / "instruments").string());
  return done;
}

}  // namespace pmr::cli
