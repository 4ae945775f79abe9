#include "study/folder.hpp"

#include <map>
#include <system_error>

#include "io/atomic_file.hpp"
#include "io/run_file.hpp"
#include "pmr/base/errors.hpp"
#include "report/value.hpp"

namespace pmr::study {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, const std::string& problem) {
  throw CaseError({{folder.string(), "", problem}});
}

void check_place(const fs::path& root) {
  std::error_code error;
  if (fs::exists(root) && !fs::is_directory(root)) refuse(root, "is not a folder");
  const bool used = fs::exists(root) && !fs::is_empty(root, error);
  if (used && !fs::exists(root / "study.toml"))
    refuse(root, "holds files that are no study of pmr; name another output folder");
}

// Writes the case; whether another one stood there.
bool replaces(const fs::path& file, const std::string& text) {
  const bool stands = fs::exists(file);
  if (stands && io::read_text(file) == text) return false;
  io::replace_text(file, text);
  return stands;
}

}  // namespace

std::string status_of(const fs::path& run_folder) {
  const fs::path file = run_folder / "summary.json";
  if (!fs::exists(file)) return "";
  try {
    return report::parse_json(io::read_text(file)).text("status");
  } catch (const CaseError&) {
    return "";  // torn by a kill: the run is taken up again
  }
}

void Folder::prepare(const Study& study, const Plan& plan) const {
  check_place(root_);
  std::error_code error;
  for (const char* inner : {"cases", "mixings", "runs", "logs"}) {
    fs::create_directories(root_ / inner, error);
    if (error) refuse(root_ / inner, "cannot be made: " + error.message());
  }
  io::replace_text(root_ / "study.toml", study.text);
  for (const Mixing& m : plan.mixings)
    if (!fs::exists(case_file("mixing-" + m.name)))
      io::replace_text(case_file("mixing-" + m.name), m.case_text);
  for (const PlannedRun& r : plan.runs)
    if (r.fault.empty() && replaces(case_file(r.name), r.case_text)) fs::remove_all(run(r));
}

Job Folder::job(const std::string& name, const fs::path& folder, std::vector<std::string> fresh,
                const std::string& program, int threads) const {
  Job job;
  job.name = name;
  job.folder = folder;
  const bool is_begun = fs::exists(folder / "run.h5") && io::has_checkpoint(folder);
  if (is_begun)
    job.command = {program, "resume", folder.string()};
  else
    job.command = std::move(fresh);
  job.command.insert(job.command.end(), {"--threads", std::to_string(threads)});
  job.log = root_ / "logs" / (folder.filename().string() + ".log");
  return job;
}

std::vector<Job> Folder::jobs(const Plan& plan, const std::string& program, int threads) const {
  std::vector<Job> jobs;
  std::map<std::size_t, std::size_t> job_of_mixing;
  for (const PlannedRun& r : plan.runs) {
    if (!r.fault.empty() || status_of(run(r)) == "completed") continue;
    std::vector<std::string> fresh{program, "run", case_file(r.name).string(), "-o",
                                   run(r).string()};
    std::optional<std::size_t> after;
    if (r.mixing) {
      const Mixing& m = plan.mixings[*r.mixing];
      fresh.insert(fresh.end(), {"--bed", mixing(m).string()});
      const auto known = job_of_mixing.find(*r.mixing);
      if (known != job_of_mixing.end()) {
        after = known->second;
      } else if (status_of(mixing(m)) != "completed") {
        after = jobs.size();
        job_of_mixing[*r.mixing] = jobs.size();
        jobs.push_back(job("mixing " + m.name, mixing(m),
                           {program, "run", case_file("mixing-" + m.name).string(), "--mechanics",
                            "-o", mixing(m).string()},
                           program, threads));
        jobs.back().seconds = m.seconds;
      }
    }
    jobs.push_back(job(r.name, run(r), std::move(fresh), program, threads));
    jobs.back().after = after;
    jobs.back().seconds = r.seconds;
  }
  return jobs;
}

}  // namespace pmr::study
