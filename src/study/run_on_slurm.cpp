#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <thread>
#include <vector>

#include "io/atomic_file.hpp"
#include "pmr/base/errors.hpp"
#include "study/engine.hpp"

namespace pmr::study {
namespace {

namespace fs = std::filesystem;

// A word as a shell takes it literally.
std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

struct Said {
  int status;
  std::string text;
};
Said shell(const std::string& command) {
  FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return {-1, "no shell"};
  std::array<char, 4096> buffer{};
  std::string text;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
    text.append(buffer.data(), n);
  const int status = ::pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

// What a job runs, with all that it says in its log.
std::string line_of(const Job& job) {
  std::string line;
  for (const std::string& word : job.command) line += quoted(word) + " ";
  return line + "> " + quoted(job.log.string()) + " 2>&1\n";
}

// The script of a job array: each task runs its line of the list.
fs::path write_array(const fs::path& folder, const std::string& name,
                     const std::vector<const Job*>& jobs, int threads) {
  std::string list;
  for (const Job* job : jobs) list += line_of(*job);
  const fs::path commands = folder / (name + ".commands");
  fs::path script = folder / (name + ".sh");
  io::replace_text(commands, list);
  io::replace_text(script, fmt::format("#!/bin/sh\n"
                                       "#SBATCH --job-name=pmr-{}\n"
                                       "#SBATCH --array=1-{}\n"
                                       "#SBATCH --cpus-per-task={}\n"
                                       "#SBATCH --output=/dev/null\n"
                                       "eval \"$(sed -n \"${{SLURM_ARRAY_TASK_ID}}p\" {})\"\n",
                                       name, jobs.size(), threads, quoted(commands.string())));
  return script;
}

// Number of the job that Slurm makes of the script.
std::string submit(const fs::path& script, const std::string& after) {
  const std::string dependency = after.empty() ? "" : "--dependency=afterany:" + after + " ";
  const Said said = shell("sbatch --parsable " + dependency + quoted(script.string()));
  if (said.status != 0)
    throw CaseError({{"--engine slurm", "",
                      "sbatch did not take " + script.string() + ": " +
                          (said.text.empty() ? "it said nothing" : said.text)}});
  return said.text.substr(0, said.text.find_first_of(";\n"));
}

// Whether any of the jobs waits or runs. A controller that does not answer says nothing of them.
bool is_alive(const std::string& ids) {
  const Said said = shell("squeue --noheader --jobs=" + ids);
  if (said.status == 0) return !said.text.empty();
  return said.text.find("Invalid job id") == std::string::npos;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  std::string text;
  std::getline(in, text);
  return text;
}

// Job numbers, "12,13": of what an earlier call submitted and still runs, or of a new submission.
std::string submitted(std::span<const Job> jobs, const fs::path& folder, int threads) {
  const fs::path note = folder / "submitted";
  std::string earlier = text_of(note);
  if (!earlier.empty() && is_alive(earlier)) return earlier;
  std::vector<const Job*> mixings, runs;
  for (const Job& job : jobs) (job.name.rfind("mixing ", 0) == 0 ? mixings : runs).push_back(&job);
  const std::string first =
      mixings.empty() ? "" : submit(write_array(folder, "mixings", mixings, threads), "");
  const std::string second = submit(write_array(folder, "runs", runs, threads), first);
  std::string ids = first.empty() ? second : first + "," + second;
  io::replace_text(note, ids + "\n");
  return ids;
}

}  // namespace

void run_on_slurm(std::span<const Job> jobs, const fs::path& folder, int threads,
                  const StopToken& stop, const OnEvent& on_event) {
  if (jobs.empty()) return;
  fs::create_directories(folder / "slurm");
  const std::string ids = submitted(jobs, folder / "slurm", threads);
  std::vector<bool> told(jobs.size(), false);
  bool alive = true;
  while (alive && !stop.is_set()) {
    std::this_thread::sleep_for(std::chrono::seconds(1));
    alive = is_alive(ids);
    for (std::size_t k = 0; k < jobs.size(); ++k)
      if (!told[k] && status_of(jobs[k].folder) == "completed") {
        told[k] = true;
        on_event({jobs[k], JobState::done, ""});
      }
  }
  for (std::size_t k = 0; k < jobs.size() && !alive; ++k)
    if (!told[k]) on_event({jobs[k], JobState::failed, last_words(jobs[k].log)});
}

}  // namespace pmr::study
