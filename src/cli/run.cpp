// pmr run, pmr resume.
#include <fmt/format.h>

#include "cli/console.hpp"
#include "cli/finish.hpp"
#include "cli/log.hpp"
#include "cli/machine.hpp"
#include "cli/progress.hpp"
#include "cli/run_folder.hpp"
#include "cli/start.hpp"
#include "cli/stop_signal.hpp"
#include "cli/verbs.hpp"
#include "io/run_file.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"
#include "pmr/base/storage_error.hpp"

namespace pmr::cli {
namespace {

namespace fs = std::filesystem;

sim::Ending run_steps(sim::Simulation& simulation, const io::FolderLock& lock) {
  const AtStake at_stake;
  Progress progress;
  return simulation.run(at_stake.token(), [&](const sim::Simulation& now) {
    progress.show(now);
    lock.require_standing();
  });
}

int carry_out_run(sim::Simulation& simulation, const RunRecord& record,
                  const io::FolderLock& lock) {
  try {
    return finish_run(simulation, record, run_steps(simulation, lock));
  } catch (const StorageError&) {
    throw;
  } catch (const CaseError& error) {  // the input was right when the run began: a file is not
    throw StorageError(error.what());
  } catch (const std::exception& error) {
    return finish_failed(simulation, record, error.what());
  }
}

io::RunHeader header_of(const Case& c, const RunRecord& record) {
  io::RunHeader header{c.text, record.provenance, {}, {}};
  for (const Species& species : c.species) header.species.push_back(species.name);
  for (const auto& patch : coupling::number_nodes(c, 0).patches)
    header.patches.push_back(patch.name);
  for (const Grain& grain : c.walls.grains) header.adhered_radius.push_back(grain.radius);
  return header;
}

int begin(Start& start, const RunOptions& options, const fs::path& folder,
          const io::FolderLock& lock) {
  const Case& c = start.setup;
  open_log(folder);
  log_info(fmt::format("{}: {}", options.case_file.string(), c.title));
  for (const std::string& warning : c.warnings) log_info("warning  " + warning);
  RunRecord record{folder, provenance(options.command, c.text)};
  if (start.bed) {
    record.provenance["bed"] = start.bed->description;
    record.provenance["bed_hash"] = hexadecimal(start.bed->hash);
    log_info("bed      " + start.bed->description);
  }
  io::create_run(folder, header_of(c, record));
  auto simulation =
      start.bed ? sim::Simulation(c, folder, std::move(*start.bed)) : sim::Simulation(c, folder);
  return carry_out_run(simulation, record, lock);
}

int go_on(const fs::path& folder, const std::string& command, const io::FolderLock& lock) {
  const Case c = case_of_run(folder);
  State state = io::load_checkpoint(folder);
  io::drop_after(folder, state.time);
  open_log(folder);
  log_info(fmt::format("{}: goes on from t = {:.6g} s", c.title, state.time));
  RunRecord record{folder, provenance(command, c.text)};
  for (const auto& [key, value] : io::read_header(folder).provenance)
    if (key.rfind("bed", 0) == 0) record.provenance[key] = value;
  sim::Simulation simulation(c, folder, std::move(state));
  return carry_out_run(simulation, record, lock);
}

}  // namespace

int run(const RunOptions& options) {
  end_on_signals();
  Start start = read_start(options.case_file, options.sets);
  const fs::path folder =
      options.folder.empty() ? fs::path("out") / options.case_file.stem() : options.folder;
  const io::FolderLock lock = begin_in(folder);
  const ThreadLimit limit(options.threads);
  try {
    return begin(start, options, folder, lock);
  } catch (const StorageError& error) {
    return finish_unsaved(folder, error.what());
  }
}

int resume(const fs::path& folder, int threads, const std::string& command) {
  end_on_signals();
  const io::FolderLock lock = go_on_in(folder);
  const ThreadLimit limit(threads);
  try {
    return go_on(folder, command, lock);
  } catch (const StorageError& error) {
    return finish_unsaved(folder, error.what());
  }
}

}  // namespace pmr::cli
