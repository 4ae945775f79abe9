// The folder of a study: which file stands where, what is done, what is left to do.
//   study.toml           the study as last asked for (lab.toml: a calibration)
//   cases/NAME.toml      the whole case of each run, ready for `pmr run`
//   mixings/HASH, runs/NAME   run folders
//   logs/NAME.log        what each job said
//   study.csv, study.h5, report.html
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/folder_lock.hpp"
#include "study/plan.hpp"

namespace pmr::study {

// One process to run.
struct Job {
  std::string name;                  // of a run, or "mixing HASH"
  std::vector<std::string> command;  // words; the first is the program
  std::filesystem::path folder, log;
  std::optional<std::size_t> after;  // job that has to end well before
  double seconds = 0.0;              // [s] forecast on one core
};

class Folder {
 public:
  // `asked_for` is the name of the file that says what the folder is for.
  explicit Folder(std::filesystem::path root, std::string asked_for = "study.toml")
      : root_(std::move(root)), asked_for_(std::move(asked_for)) {}

  // Makes the folders and writes what was asked for. CaseError when the folder holds something
  // else, or another process writes it. The lock is to be held while the study runs.
  [[nodiscard]] io::FolderLock prepare(const std::string& asked_for) const;

  // Writes the cases. A run whose case is another now than when it was run goes. CaseError when
  // another process writes such a run.
  void write_cases(const Plan& plan) const;

  // What is not completed yet, each mixing right before the first run that waits for it; begun runs
  // go on from their checkpoint, and a completed one that has no report gets it. `program` is pmr,
  // each job on `threads`.
  std::vector<Job> jobs(const Plan& plan, const std::string& program, int threads) const;

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path run(const PlannedRun& r) const { return root_ / "runs" / r.name; }
  std::filesystem::path mixing(const Mixing& m) const { return root_ / "mixings" / m.name; }
  // Of a run or a mixing.
  std::filesystem::path log_of(const std::filesystem::path& run_folder) const {
    return root_ / "logs" / (run_folder.filename().string() + ".log");
  }

 private:
  std::filesystem::path case_file(const std::string& name) const {
    return root_ / "cases" / (name + ".toml");
  }
  Job job(const std::string& name, const std::filesystem::path& folder,
          std::vector<std::string> fresh, const std::string& program, int threads) const;

  void check_place() const;

  std::filesystem::path root_;
  std::string asked_for_;
};

// "completed", "stopped", "failed", or "" where no summary stands.
std::string status_of(const std::filesystem::path& run_folder);

}  // namespace pmr::study
