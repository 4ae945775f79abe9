// pmr calibrate: from a lab file to the parameters that its tests tell.
#include <fmt/format.h>

#include <algorithm>

#include "calibrate/outputs.hpp"
#include "calibrate/page.hpp"
#include "calibrate/stage_runs.hpp"
#include "calibrate/synthetic.hpp"
#include "cli/console.hpp"
#include "cli/jobs.hpp"
#include "cli/log.hpp"
#include "cli/stop_signal.hpp"
#include "cli/verbs.hpp"
#include "io/atomic_file.hpp"
#include "pmr/base/errors.hpp"
#include "version.hpp"

namespace pmr::cli {
namespace {

namespace fs = std::filesystem;
using calibrate::Calibration;
using calibrate::Lab;

std::string version_text() { return std::string(pmr_version) + " (" + pmr_git + ")"; }

void print_calibration_plan(const Lab& lab, const CalibrateOptions& options,
                            const calibrate::Wishes& wishes, calibrate::Runs& runs,
                            const Share& share) {
  say(fmt::format("{}\n", lab.title));
  const auto values = calibrate::guesses(lab);
  double least = 0.0, most = 0.0;
  for (std::size_t s = 0; s < calibrate::stages_wanted(lab, wishes); ++s) {
    const calibrate::Stage& stage = lab.stages[s];
    const auto first = calibrate::first_runs(lab, s, values, options.is_full);
    const double seconds = runs.forecast(first) / share.cores();
    const double each = seconds / static_cast<double>(first.size());
    const std::size_t more =
        (stage.sampling.most - stage.sampling.points) * (calibrate::targets_of(stage).size());
    say(fmt::format("stage    {}: {} points, {} runs, {}; at most {} points\n", stage.name,
                    stage.sampling.points, first.size(), duration_text(seconds),
                    stage.sampling.most));
    least += seconds;
    most += seconds + each * static_cast<double>(more);
  }
  say(fmt::format("forecast {} to {} on {} cores, without the runs at the parameters found\n",
                  duration_text(least), duration_text(most), share.cores()));
}

void print_stage(const Lab& lab, const calibrate::StageResult& result) {
  const calibrate::Stage& stage = lab.stages[result.stage];
  std::string found;
  if (!result.modes.empty())
    for (std::size_t v = 0; v < stage.parameters.size(); ++v) {
      const calibrate::Parameter& p = stage.parameters[v];
      found += fmt::format("{}{} = {:.4g} +- {:.2g}{}{}", v == 0 ? "" : ", ", p.name,
                           result.best().at[v], result.best().mode.deviation(v),
                           p.unit.empty() ? "" : " ", p.unit);
    }
  say(fmt::format("stage    {}: {}; {} points, {}\n", stage.name,
                  found.empty() ? "nothing found" : found, result.points.size(), result.ended));
}

void print_end(const Calibration& c, const calibrate::Runs& runs, const fs::path& folder) {
  std::size_t lost = 0;
  for (const calibrate::Outcome& o : runs.all()) {
    if (o.status != "failed") continue;
    ++lost;
    say(fmt::format("failed   {}: {}\n", o.name, o.reason));
  }
  for (const std::string& warning : c.warnings) say(fmt::format("warning  {}\n", warning));
  say(fmt::format("runs     {}, {} of them failed\n", runs.all().size(), lost));
  say(fmt::format("found    {}\n", (folder / "contacts.toml").string()));
  say(fmt::format("table    {}\n", (folder / "runs.csv").string()));
  say(fmt::format("report   {}\n", (folder / "report.html").string()));
}

int make_lab(const Lab& lab, const CalibrateOptions& options, const fs::path& folder,
             calibrate::Runs& runs) {
  const fs::path file = folder / "synthetic.toml";
  io::replace_text(file, calibrate::synthetic_lab(lab, options.truth, options.is_full, runs));
  say(fmt::format("lab      {}\n", file.string()));
  return done;
}

int carry_through(const Lab& lab, const calibrate::Wishes& wishes, const fs::path& folder,
                  calibrate::Runs& runs) {
  const Calibration c = calibrate::calibrate(lab, wishes, runs);
  calibrate::write_parameters(lab, c, version_text(), folder / "contacts.toml");
  calibrate::write_json(lab, c, version_text(), folder / "calibration.json");
  calibrate::write_page(lab, c, runs, folder);
  print_end(c, runs, folder);
  if (c.is_refused) say("a stage's surrogate does not hold: what follows it was not carried out\n");
  return c.is_refused ? failed : done;
}

}  // namespace

int calibrate(const CalibrateOptions& options) {
  end_on_signals();
  const Lab lab = calibrate::read_lab(options.lab_file, options.sets);
  const fs::path root = fs::absolute(
      options.folder.empty() ? fs::path("out") / options.lab_file.stem() : options.folder);
  const study::Folder folder(root, "lab.toml");
  const Share share = share_of(options.jobs);
  calibrate::Runs runs(lab, folder, this_program(), share.threads,
                       [&](const std::vector<study::Job>& jobs) {
                         return !carry_out(jobs, folder, options.jobs, share);
                       });
  calibrate::Wishes wishes{options.is_full, options.last};
  wishes.on_stage = [&](const calibrate::StageResult& result) { print_stage(lab, result); };
  calibrate::stages_wanted(lab, wishes);  // a wrong name is told before anything is run
  if (options.only_plan || options.truth.empty())
    print_calibration_plan(lab, options, wishes, runs, share);
  if (options.only_plan) return done;
  const io::FolderLock lock = folder.prepare(lab.text);
  try {
    return options.truth.empty() ? carry_through(lab, wishes, root, runs)
                                 : make_lab(lab, options, root, runs);
  } catch (const Stopped&) {
    say(fmt::format("interrupted; the same command goes on in {}\n", root.string()));
    return interrupted;
  }
}

}  // namespace pmr::cli
