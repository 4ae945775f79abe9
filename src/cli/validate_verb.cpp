// pmr validate: from experiments to a page of computed against measured.
#include <fmt/format.h>

#include <algorithm>

#include "cli/console.hpp"
#include "cli/jobs.hpp"
#include "cli/log.hpp"
#include "cli/stop_signal.hpp"
#include "cli/verbs.hpp"
#include "io/atomic_file.hpp"
#include "validate/page.hpp"

namespace pmr::cli {
namespace {

namespace fs = std::filesystem;
using validate::Experiment;

void print_experiments(const std::vector<Experiment>& experiments,
                       const validate::ValidationPlan& plan, const std::vector<study::Job>& jobs,
                       const Share& share) {
  for (std::size_t k = 0; k < experiments.size(); ++k)
    say(fmt::format("{:24} {} points: {}\n", experiments[k].name, experiments[k].points.rows,
                    experiments[k].title));
  double seconds = 0.0;
  for (const study::Job& job : jobs) seconds += job.seconds;
  say(fmt::format("runs     {}, {} to be made, about {} on {} cores\n", plan.plan.runs.size(),
                  jobs.size(), duration_text(seconds / share.cores()), share.cores()));
}

void print_verdicts(const std::vector<Experiment>& experiments, const validate::Findings& found) {
  for (const validate::Comparison& c : found.comparisons) {
    const Experiment& e = experiments[c.experiment];
    const validate::Quantity& q = e.quantities[c.quantity];
    if (c.variant > 0) continue;
    if (c.verdict == validate::Verdict::not_run) {
      say(fmt::format("not run  {:24} {}\n", e.name, q.label));
      continue;
    }
    say(fmt::format(
        "{:7}  {:24} {}: mean {:.3g}, rms {:.3g}, largest {:.3g} {}{}\n",
        validate::word_of(c.verdict), e.name, q.label, c.mean, c.rms, c.largest,
        validate::unit_of_miss(q),
        q.bar.kind == validate::Bar::Kind::none ? "" : " (wanted: " + validate::bar_text(q) + ")"));
  }
  for (const validate::SlopeFound& s : found.slopes) {
    const Experiment& e = experiments[s.experiment];
    const validate::Slope& slope = e.slopes[s.slope];
    if (s.variant > 0 || s.verdict == validate::Verdict::not_run) continue;
    say(fmt::format("{:7}  {:24} {}: {:.3g} +- {:.2g} (wanted: {} +- {})\n",
                    validate::word_of(s.verdict), e.name, slope.label, s.value, s.error,
                    slope.measured, slope.bar));
  }
  for (const std::string& failure : found.failures) say("failed   " + failure + "\n");
}

std::string asked_for(const std::vector<Experiment>& experiments) {
  std::string text = "# Experiments that were asked for.\n";
  for (const Experiment& e : experiments)
    text += fmt::format("[[experiment]]\nname = \"{}\"\n", e.name);
  return text;
}

}  // namespace

int validate(const ValidateOptions& options) {
  end_on_signals();
  std::vector<Experiment> experiments;
  std::vector<Fault> faults;
  for (const fs::path& file : options.experiments) try {
      experiments.push_back(validate::read_experiment(file, options.sets));
    } catch (const CaseError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  if (!faults.empty()) throw CaseError(std::move(faults));
  const validate::ValidationPlan plan = validate::make_plan(experiments);
  const study::Folder folder(
      fs::absolute(options.folder.empty() ? fs::path("out/validation") : options.folder),
      "experiments.toml");
  const Share share = share_of(options.jobs);
  if (options.only_plan) {
    print_experiments(experiments, plan, folder.jobs(plan.plan, this_program(), share.threads),
                      share);
    return done;
  }
  const io::FolderLock lock = folder.prepare(asked_for(experiments));
  folder.write_cases(plan.plan);
  const auto jobs = folder.jobs(plan.plan, this_program(), share.threads);
  print_experiments(experiments, plan, jobs, share);
  const bool stopped = carry_out(jobs, folder, options.jobs, share);
  const validate::Findings found = validate::compare(experiments, plan, folder);
  validate::write_table(experiments, found, folder.root() / "validation.csv");
  validate::write_page(experiments, plan, found, folder);
  print_verdicts(experiments, found);
  say(fmt::format("table    {}\n", (folder.root() / "validation.csv").string()));
  say(fmt::format("report   {}\n", (folder.root() / "report.html").string()));
  if (stopped) {
    say(fmt::format("interrupted; the same command goes on in {}\n", folder.root().string()));
    return interrupted;
  }
  return found.failures.empty() ? done : failed;
}

}  // namespace pmr::cli
