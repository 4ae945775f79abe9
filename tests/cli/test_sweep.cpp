// Studies as their users see them: tables, sharing, kills, failures.
#include <catch2/catch.hpp>

#include "program.hpp"

namespace {

namespace fs = std::filesystem;
using Catch::Contains;

// The tiny reactor over two temperatures and two seeds.
fs::path write_study(const fs::path& folder, const std::string& more = "") {
  fs::path file = folder / "study.toml";
  std::ofstream(file) << "title = \"Tiny study\"\nteaches = \"for tests\"\nreplicates = 2\n"
                      << "case = \"" << (source_dir / "tests/sim/tiny.toml").string() << "\"\n"
                      << more << R"(
[settings]
"output.checkpoint_wall_time" = "50 ms"
[responses.delta]
key = "chemistry/delta_final"
[responses.granules]
key = "thermal/temperature_mean/SrFeO3"
unit = "degC"
offset = -273.15
[variables.bead]
key = "species.Al2O3.temperature"
unit = "degC"
values = [900, 1100]
)";
  return file;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("A study that was killed twice ends with the table of one that was not") {
  const Scratch scratch("sweep");
  const fs::path study = write_study(scratch.path);
  const fs::path whole = scratch.path / "whole", cut = scratch.path / "cut";
  const Said said = pmr_says("sweep " + study.string() + " -o " + whole.string());
  INFO(said.text);
  REQUIRE(said.status == 0);
  const std::string table = text_of(whole / "study.csv");
  CHECK(count(table, ",completed,") == 4);
  CHECK(count(text_of(whole / "report.html"), "<section") >= 5);
  CHECK(std::distance(fs::directory_iterator(whole / "mixings"), {}) == 2);  // one a seed

  for (const int after : {700, 1600}) {
    Beside sweep({"sweep", study.string(), "-o", cut.string()}, scratch.path / "said");
    std::this_thread::sleep_for(std::chrono::milliseconds(after));
    sweep.signal(SIGKILL);
    sweep.wait();
  }
  const Said rest = pmr_says("sweep " + study.string() + " -o " + cut.string());
  INFO(rest.text);
  REQUIRE(rest.status == 0);
  CHECK(text_of(cut / "study.csv") == table);

  const Said again = pmr_says("sweep " + study.string() + " -o " + cut.string());
  CHECK(again.status == 0);
  CHECK_THAT(again.text, Contains("to do    0 mixings and 0 runs"));
  CHECK(text_of(cut / "study.csv") == table);
}

TEST_CASE("A run that fails is told with its reason, and the others finish") {
  const Scratch scratch("sweep-fails");
  std::ofstream(scratch.path / "study.toml")
      << "title = \"Too many\"\nteaches = \"for tests\"\ncase = \""
      << (source_dir / "tests/sim/tiny.toml").string() << "\"\n"
      << "[settings]\n\"react.end\" = \"0.2 s\"\n"
      << "[responses.height]\nkey = \"mechanics/bed_height\"\n"
      << "[variables.beads]\nkey = \"species.Al2O3.count\"\nvalues = [20, 4000, -1]\n";
  const Said said = pmr_says("sweep " + (scratch.path / "study.toml").string() + " -o " +
                             (scratch.path / "out").string());
  INFO(said.text);
  CHECK(said.status == 3);
  CHECK_THAT(said.text, Contains("1 completed, 2 failed, 0 missing"));
  const std::string table = text_of(scratch.path / "out" / "study.csv");
  CHECK_THAT(table, Contains("beads=20,completed") && Contains("beads=4000,failed") &&
                        Contains("species.Al2O3.count"));
  CHECK_THAT(table, Contains("Al2O3") && Contains("region"));
}

TEST_CASE("A study file with mistakes is refused with status 2 and leaves no folder") {
  const Scratch scratch("sweep-wrong");
  const fs::path study = write_study(scratch.path, "replicas = 3\n");
  const Said said = pmr_says("sweep " + study.string() + " -o " + (scratch.path / "out").string());
  CHECK(said.status == 2);
  CHECK_THAT(said.text, Contains("did you mean 'replicates'"));
  CHECK_FALSE(fs::exists(scratch.path / "out"));
}

TEST_CASE("A study that is interrupted leaves no run for failed, and goes on to the same table") {
  const Scratch scratch("sweep-stopped");
  const fs::path study = write_study(scratch.path), out = scratch.path / "out";
  Beside sweep({"sweep", study.string(), "-o", out.string()}, scratch.path / "said");
  REQUIRE(comes(out / "logs"));
  const Said second = pmr_says("sweep " + study.string() + " -o " + out.string());
  CHECK(second.status == 2);
  CHECK_THAT(second.text, Contains("is being written by process " + std::to_string(sweep.pid())));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  sweep.signal(SIGHUP);
  REQUIRE(sweep.wait() == 130);
  CHECK_THAT(text_of(out / "study.csv"), !Contains("failed"));
  // What a child that was killed in its first moment leaves.
  const fs::path early = out / "runs" / "bead=1100_seed=2";
  if (!fs::exists(early)) {
    fs::create_directories(early);
    std::ofstream(early / "log.txt").close();
  }
  const Said rest = pmr_says("sweep " + study.string() + " -o " + out.string());
  INFO(rest.text);
  CHECK(rest.status == 0);
  CHECK(count(text_of(out / "study.csv"), ",completed,") == 4);
}

TEST_CASE("What a study that was killed at once has left is taken over") {
  const Scratch scratch("sweep-leftovers");
  const fs::path study = write_study(scratch.path), out = scratch.path / "out";
  fs::create_directories(out);
  std::ofstream(out / "study.toml.tmp") << "half a";
  std::ofstream(out / ".lock") << "process 1 on nowhere\n";
  Beside sweep({"sweep", study.string(), "-o", out.string()}, scratch.path / "said");
  CHECK(comes(out / "logs"));
}
