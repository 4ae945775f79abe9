// The verbs of `pmr`, one file each. All throw CaseError or NumericsError; console.cpp turns them
// into messages and exit statuses.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/report.hpp"

namespace pmr::cli {

struct RunOptions {
  std::filesystem::path case_file;
  std::filesystem::path folder;   // empty: out/<name of the case file>
  std::vector<std::string> sets;  // key=value
  int threads = 0;                // 0: all cores
  std::string command;            // as typed, for the record
};
int run(const RunOptions& options);
int resume(const std::filesystem::path& folder, int threads, const std::string& command);

int check(const std::filesystem::path& case_file, const std::vector<std::string>& sets);

// `reference`: CSV of mass ratios in place of the case's own; empty: its own.
int analyse(const std::filesystem::path& folder, const std::filesystem::path& reference);
int report(const std::vector<std::filesystem::path>& folders, std::filesystem::path html,
           const report::ReportWishes& wishes);

struct RenderOptions {
  std::filesystem::path folder, png;
  std::optional<double> time;  // [s]; none: the last snapshot
  std::string colour;          // "temperature", "delta" or "species"
};
int render(const RenderOptions& options);

int verify(bool json);

// How the runs of a study or a calibration are made.
struct JobOptions {
  int at_once = 0;               // runs at once; 0: as many as threads
  int threads = 0;               // of all together; 0: all cores
  std::string engine = "local";  // or "slurm"
};

struct SweepOptions {
  std::filesystem::path study_file;
  std::filesystem::path folder;   // empty: out/<name of the study file>
  std::vector<std::string> sets;  // key=value of the study's constants or of every case
  JobOptions jobs;
  bool only_plan = false;  // says what would be done, and does nothing
};
int sweep(const SweepOptions& options);

struct CalibrateOptions {
  std::filesystem::path lab_file;
  std::filesystem::path folder;     // empty: out/<name of the lab file>
  std::filesystem::path truth;      // empty: none; else a lab is made at its parameters
  std::vector<std::string> sets;    // key=value of the lab's constants or of every case
  std::optional<std::string> last;  // stage to end with
  JobOptions jobs;
  bool is_full = false;    // no small samples
  bool only_plan = false;  // says what would be done, and does nothing
};
int calibrate(const CalibrateOptions& options);

struct ValidateOptions {
  std::vector<std::filesystem::path> experiments;
  std::filesystem::path folder;   // empty: out/validation
  std::vector<std::string> sets;  // key=value of the experiments' constants or of every case
  JobOptions jobs;
  bool only_plan = false;  // says what would be done, and does nothing
};
int validate(const ValidateOptions& options);

}  // namespace pmr::cli
