// pmr run, pmr resume.
#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "cli/console.hpp"
#include "cli/finish.hpp"
#include "cli/log.hpp"
#include "cli/machine.hpp"
#include "cli/progress.hpp"
#include "cli/start.hpp"
#include "cli/stop_signal.hpp"
#include "cli/verbs.hpp"
#include "io/run_file.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, const std::string& problem) {
  throw CaseError({{folder.string(), "", problem}});
}

// An empty or new folder, or one that holds an earlier run, which is replaced.
void prepare_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder) && !fs::is_directory(folder)) refuse(folder, "is not a folder");
  const bool used = fs::exists(folder) && !fs::is_empty(folder, error);
  if (used && !fs::exists(folder / "run.h5"))
    refuse(folder, "holds files that are no run of pmr; name another output folder");
  const bool made = fs::create_directories(folder, error);
  if (error) refuse(folder, "cannot be made: " + error.message());
  const fs::path probe = folder / ".write-test";
  if (!std::ofstream(probe)) {
    if (made) fs::remove(folder, error);
    refuse(folder, "is not writable");
  }
  fs::remove(probe, error);
  for (const char* old : {"run.h5", "run.xdmf", "checkpoint.h5", "summary.json", "report.html",
                          "log.txt", "instruments"})
    fs::remove_all(folder / old, error);
}

int carry_out(sim::Simulation& simulation, const RunRecord& record) {
  Progress progress;
  try {
    const sim::Ending ending =
        simulation.run(stop_on_signals(), [&](const sim::Simulation& now) { progress.show(now); });
    progress.finish();
    return finish_run(simulation, record, ending);
  } catch (const NumericsError& error) {
    progress.finish();
    return finish_failed(simulation, record, error.what());
  }
}

}  // namespace

int run(const RunOptions& options) {
  Start start = read_start(options.case_file, options.sets);
  const Case& c = start.setup;
  const fs::path folder =
      options.folder.empty() ? fs::path("out") / options.case_file.stem() : options.folder;
  prepare_folder(folder);
  const ThreadLimit limit(options.threads);
  open_log(folder);
  log_info(fmt::format("{}: {}", options.case_file.string(), c.title));
  RunRecord record{folder, provenance(options.command, c.text)};
  if (start.bed) {
    record.provenance["bed"] = start.bed->description;
    record.provenance["bed_hash"] = hexadecimal(start.bed->hash);
    log_info("bed      " + start.bed->description);
  }
  io::RunHeader header{c.text, record.provenance, {}, {}};
  for (const Species& species : c.species) header.species.push_back(species.name);
  for (const auto& patch : coupling::number_nodes(c, 0).patches)
    header.patches.push_back(patch.name);
  io::create_run(folder, header);
  auto simulation =
      start.bed ? sim::Simulation(c, folder, std::move(*start.bed)) : sim::Simulation(c, folder);
  return carry_out(simulation, record);
}

int resume(const fs::path& folder, int threads, const std::string& command) {
  if (!io::has_checkpoint(folder)) refuse(folder, "holds no checkpoint to go on from");
  const Case c = case_of_run(folder);
  State state = io::load_checkpoint(folder);
  io::drop_after(folder, state.time);
  const ThreadLimit limit(threads);
  open_log(folder);
  log_info(fmt::format("{}: goes on from t = {:.6g} s", c.title, state.time));
  RunRecord record{folder, provenance(command, c.text)};
  for (const auto& [key, value] : io::read_header(folder).provenance)
    if (key.rfind("bed", 0) == 0) record.provenance[key] = value;
  sim::Simulation simulation(c, folder, std::move(state));
  return carry_out(simulation, record);
}

}  // namespace pmr::cli
