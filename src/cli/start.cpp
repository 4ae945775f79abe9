#include "cli/start.hpp"

#include "case/case.hpp"
#include "io/run_file.hpp"
#include "physics/insertion.hpp"
#include "physics/time_step.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::cli {

namespace fs = std::filesystem;

Start read_start(const fs::path& case_file, const std::vector<std::string>& sets) {
  Start start{casefile::load_case(case_file, sets), std::nullopt};
  if (!start.setup.bed.empty()) {
    start.bed = sim::read_bed(start.setup);
    sim::count_bed(start.bed->particles, start.setup);
    if (const auto problem = physics::time_step_fault(start.setup); !problem.empty())
      throw CaseError({{case_file.string(), "models.mechanics.time_step", problem}});
    return start;
  }
  auto faults = physics::insertion_faults(start.setup);
  for (Fault& fault : faults) fault.where = case_file.string();
  if (!faults.empty()) throw CaseError(std::move(faults));
  return start;
}

std::string bed_setting(const fs::path& bed) {
  std::string quoted;
  for (const char letter : fs::absolute(bed).lexically_normal().string()) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return "bed=\"" + quoted + "\"";
}

Case case_of_run(const fs::path& folder) {
  const io::RunHeader header = io::read_header(folder);
  Case c = casefile::load_case_text(header.case_text, (folder / "run.h5").string(), folder);
  if (!c.bed.empty()) sim::count_bed(io::read_snapshot(folder, 0).particles, c);
  return c;
}

}  // namespace pmr::cli
