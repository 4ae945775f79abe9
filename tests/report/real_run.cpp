#include "real_run.hpp"

#include <unistd.h>

#include <atomic>
#include <vector>

#include "case/case.hpp"
#include "pmr/base/errors.hpp"
#include "sim/simulation.hpp"
#include "sim/summary.hpp"

namespace pmr::report {
namespace {

namespace fs = std::filesystem;

// A title that would end the page's scripts, and something to look at.
const std::vector<std::string> with_tool{
    R"(title="</script><b>not bold</b>")",
    // cool enough to be warmed by the beads before the walls cool both
    R"(species.SrFeO3.temperature="400 degC")",
    R"(species.SrFeO3.delta={equilibrium_at="700 degC", oxygen="0.21 bar"})",
    R"(walls.floor.thermal.temperature="400 degC")",
    // two lines of one text
    (R"(decomposition={axis_point="0 0 0 m", ramp_azimuth="0 deg", layer_fraction=[0.5, 0.4], )"
     R"(sectors=4, reference_source="none"})")};

class Folder {
 public:
  explicit Folder(const std::vector<std::string>& sets)
      : path_(fs::temp_directory_path() /
              ("pmr-test-page-" + std::to_string(::getpid()) + "-" + std::to_string(sets.size()))) {
    const Case c = casefile::load_case(fs::path(PMR_SOURCE_DIR) / "tests/sim/tiny.toml", sets);
    io::RunHeader header{c.text, {{"version", "of the test"}}, {}, {}};
    for (const Species& species : c.species) header.species.push_back(species.name);
    for (const auto& patch : coupling::number_nodes(c, 0).patches)
      header.patches.push_back(patch.name);
    io::create_run(path_, header);
    sim::Simulation simulation(c, path_);
    const std::atomic<bool> never{false};
    ensure(simulation.run(never, [](const auto&) {}) == sim::Ending::completed, "the run ends");
    sim::write_summary(
        path_, {c, simulation.state(), simulation.nodes(), simulation.timings(),
                io::read_series(path_), simulation.time_step(), "completed", header.provenance});
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

const fs::path& real_folder() {
  static const Folder folder(with_tool);
  return folder.path();
}

RunData real_run(const std::string& name) {
  RunData run = read_run(real_folder());
  run.name = name;
  return run;
}

RunData moved_alone() {
  const Folder folder({"models.mechanics_only=true",
                       R"(species.Al2O3.temperature="700 degC")"});  // as the granules
  RunData run = read_run(folder.path());
  std::vector<io::Snapshot> all;
  for (std::size_t k = 0; k < run.snapshot_times.size(); ++k) all.push_back(run.snapshot(k));
  run.snapshot = [all](std::size_t index) { return all.at(index); };
  return run;
}

}  // namespace pmr::report
