// pmr sweep: a study from its file to its table and report.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cli/console.hpp"
#include "cli/jobs.hpp"
#include "cli/log.hpp"
#include "cli/stop_signal.hpp"
#include "cli/verbs.hpp"
#include "pmr/base/errors.hpp"
#include "study/page.hpp"
#include "study/results.hpp"

namespace pmr::cli {
namespace {

namespace fs = std::filesystem;

void print_plan(const study::Study& study, const study::Plan& plan,
                const std::vector<study::Job>& jobs, const Share& share) {
  std::size_t faulty = 0, runs_left = 0;
  double seconds = 0.0;
  for (const auto& run : plan.runs) faulty += run.fault.empty() ? 0 : 1;
  for (const auto& job : jobs) {
    seconds += job.seconds;
    runs_left += job.name.rfind("mixing ", 0) == 0 ? 0 : 1;
  }
  say(fmt::format("{}\n", study.title));
  say(fmt::format("design   {} runs ({} points, {} of each), {} mixing{} shared by them\n",
                  plan.runs.size(), plan.runs.size() / study.replicates, study.replicates,
                  plan.mixings.size(), plan.mixings.size() == 1 ? "" : "s"));
  if (faulty > 0)
    say(fmt::format("wrong    {} runs whose case cannot be made; see the table\n", faulty));
  say(fmt::format("to do    {} mixings and {} runs, {} at once, {} thread{} each\n",
                  jobs.size() - runs_left, runs_left, share.at_once, share.threads,
                  share.threads == 1 ? "" : "s"));
  say(fmt::format("forecast about {}\n", duration_text(seconds / share.cores())));
}

void print_results(const study::Results& results, const fs::path& folder, bool stopped) {
  std::map<std::string, std::size_t> count;
  for (const study::Row& row : results.rows) ++count[row.status];
  for (const study::Row& row : results.rows)
    if (row.status == "failed") say(fmt::format("failed   {}: {}\n", row.name, row.reason));
  for (const std::string& warning : results.warnings) say(fmt::format("warning  {}\n", warning));
  say(fmt::format("runs     {} completed, {} failed, {} missing\n", count["completed"],
                  count["failed"], count["missing"]));
  say(fmt::format("table    {}\n", (folder / "study.csv").string()));
  if (!stopped) say(fmt::format("report   {}\n", (folder / "report.html").string()));
}

int status_of(const study::Results& results, const fs::path& folder, bool stopped) {
  const auto is = [&](const char* status) {
    return std::any_of(results.rows.begin(), results.rows.end(),
                       [&](const study::Row& row) { return row.status == status; });
  };
  if (!stopped && is("failed")) return failed;
  if (!stopped && !is("missing")) return done;
  say(fmt::format("interrupted; the same command goes on in {}\n", folder.string()));
  return interrupted;
}

}  // namespace

int sweep(const SweepOptions& options) {
  end_on_signals();
  const study::Study study = study::read_study(options.study_file, options.sets);
  const study::Plan plan = study::make_plan(study);
  const study::Folder folder(fs::absolute(
      options.folder.empty() ? fs::path("out") / options.study_file.stem() : options.folder));
  const Share share = share_of(options.jobs);
  if (options.only_plan) {
    print_plan(study, plan, folder.jobs(plan, this_program(), share.threads), share);
    return done;
  }
  const io::FolderLock lock = folder.prepare(study.text);
  folder.write_cases(plan);
  const auto jobs = folder.jobs(plan, this_program(), share.threads);
  print_plan(study, plan, jobs, share);
  const bool stopped = carry_out(jobs, folder, options.jobs, share);
  const study::Results results = study::collect(study, plan, folder);
  study::write_tables(study, plan, results, folder.root());
  if (!stopped) study::write_page(study, plan, results, folder);
  print_results(results, folder.root(), stopped);
  return status_of(results, folder.root(), stopped);
}

}  // namespace pmr::cli
