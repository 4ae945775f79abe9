// A study on a real Slurm cluster of one node gives the numbers of the study on this machine.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

#include "program.hpp"

namespace {

namespace fs = std::filesystem;

// The cluster of scripts/one-node-slurm, for as long as the value lives.
struct Cluster {
  fs::path folder;
  std::string environment;  // "export SLURM_CONF=..."
  explicit Cluster(fs::path at) : folder(std::move(at)) {
    const fs::path said = folder.string() + ".said";
    const int status =
        std::system((script() + "start " + folder.string() + " > " + said.string()).c_str());
    INFO("one-node-slurm start");
    REQUIRE(status == 0);
    environment = text_of(said);
    environment.erase(environment.find_last_not_of('\n') + 1);
  }
  ~Cluster() {
    [[maybe_unused]] const int status = std::system((script() + "stop " + folder.string()).c_str());
  }
  Cluster(const Cluster&) = delete;
  Cluster& operator=(const Cluster&) = delete;

 private:
  static std::string script() { return (source_dir / "scripts/one-node-slurm").string() + " "; }
};

}  // namespace

TEST_CASE("Slurm runs the same study to the same table, mixings first") {
  const Scratch scratch("slurm");
  const fs::path study = scratch.path / "study.toml";
  std::ofstream(study)
      << "title = \"Tiny study\"\nteaches = \"for tests\"\nreplicates = 2\ncase = \""
      << (source_dir / "tests/sim/tiny.toml").string() << R"("
[responses.delta]
key = "chemistry/delta_final"
[variables.bead]
key = "species.Al2O3.temperature"
unit = "degC"
values = [900, 1100]
)";
  const fs::path here = scratch.path / "here", there = scratch.path / "there";
  REQUIRE(pmr_says("sweep " + study.string() + " -o " + here.string()).status == 0);

  const Cluster cluster(scratch.path / "cluster");
  const std::string value = cluster.environment.substr(cluster.environment.find('=') + 1);
  REQUIRE(::setenv("SLURM_CONF", value.c_str(), 1) == 0);
  const Said said =
      pmr_says("sweep " + study.string() + " -o " + there.string() + " --engine slurm");
  INFO(said.text);
  REQUIRE(said.status == 0);
  CHECK(text_of(there / "study.csv") == text_of(here / "study.csv"));
  CHECK(text_of(there / "slurm" / "mixings.sh").find("--array=1-2") != std::string::npos);
  CHECK(text_of(there / "slurm" / "runs.sh").find("--array=1-4") != std::string::npos);
}
