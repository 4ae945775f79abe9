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

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) refuse(folder, "cannot be made: " + error.message());
}

// A run of another case, and what it said, go before the new case is there: a kill in between must
// not leave the one with the other, nor old words the reason of a failure.
void write_case(const fs::path& file, const std::string& text, const fs::path& run,
                const fs::path& log) {
  if (fs::exists(file) && io::read_text(file) == text) return;
  if (fs::exists(run)) {
    const io::FolderLock lock(run);
    fs::remove_all(run);
  }
  fs::remove(log);
  io::replace_text(file, text);
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

void Folder::check_place() const {
  std::error_code error;
  const auto status = fs::status(root_, error);
  if (error && status.type() != fs::file_type::not_found) refuse(root_, error.message());
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) refuse(root_, "is not a folder");
  if (fs::exists(root_ / asked_for_)) return;
  // What is asked for is written first: what was killed before that left at most these.
  for (const fs::directory_entry& entry : fs::directory_iterator(root_))
    if (const fs::path name = entry.path().filename();
        name != io::FolderLock::name && name != asked_for_ + ".tmp")
      refuse(root_, "holds files but no " + asked_for_ + " of pmr; name another output folder");
}

io::FolderLock Folder::prepare(const std::string& asked_for) const {
  check_place();
  make_folder(root_);
  io::FolderLock lock(root_);
  io::replace_text(root_ / asked_for_, asked_for);
  for (const char* inner : {"cases", "mixings", "runs", "logs"}) make_folder(root_ / inner);
  return lock;
}

void Folder::write_cases(const Plan& plan) const {
  for (const Mixing& m : plan.mixings)
    if (!fs::exists(case_file("mixing-" + m.name)))
      io::replace_text(case_file("mixing-" + m.name), m.case_text);
  for (const PlannedRun& r : plan.runs)
    if (r.fault.empty()) write_case(case_file(r.name), r.case_text, run(r), log_of(run(r)));
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
  job.log = log_of(folder);
  return job;
}

std::vector<Job> Folder::jobs(const Plan& plan, const std::string& program, int threads) const {
  std::vector<Job> jobs;
  std::map<std::size_t, std::size_t> job_of_mixing;
  for (const PlannedRun& r : plan.runs) {
    if (!r.fault.empty()) continue;
    if (status_of(run(r)) == "completed") {  // killed before its page stood?
      if (!fs::exists(run(r) / "report.html"))
        jobs.push_back({r.name,
                        {program, "report", run(r).string()},
                        run(r),
                        log_of(run(r)),
                        std::nullopt,
                        0.0});
      continue;
    }
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
