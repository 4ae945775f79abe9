// Ended at any moment, a run goes on from its last checkpoint and ends with the same bits.
#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "program.hpp"

namespace {

namespace fs = std::filesystem;
using Catch::Contains;

const std::string often = "output.checkpoint_wall_time=\"50 ms\"";

const std::string& hash_of_whole_run() {
  static const std::string hash = [] {
    const Scratch scratch("whole");
    const std::string out = (scratch.path / "out").string();
    REQUIRE(pmr_says("run " + tiny + " -o " + out + " --set '" + often + "'").status == 0);
    return hash_in(out);
  }();
  return hash;
}

// One grain in a lined box: its rays alone take minutes.
fs::path write_many_rays(const fs::path& folder) {
  fs::path file = folder / "rays.toml";
  std::ofstream(file) << R"(
title = "Many rays"
gravity = "none"
[domain]
low = "-0.4 -0.4 -0.4 m"
high = "0.4 0.4 0.4 m"
[species.grain]
material = "Al2O3"
diameter = "10 mm"
temperature = "1200 K"
[[particles]]
species = "grain"
position = "0 0 0 m"
[walls.box]
kind = "box"
material = "coated-wall"
low = "-0.2 -0.2 -0.2 m"
high = "0.2 0.2 0.2 m"
[walls.box.thermal]
kind = "lining"
layers = [{material = "fibre-board", thickness = "2 mm"}]
initial_temperature = "300 K"
outside_film_coefficient = "10 W/m2/K"
outside_temperature = "300 K"
[react]
end = "10 s"
[models]
conduction = false
[models.radiation]
surroundings = "300 K"
rays_settled = 10_000_000
)";
  return file;
}

double seconds_since(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

}  // namespace

TEST_CASE("A run that was killed or interrupted ends with the bits of one that was not") {
  const Scratch scratch("kill");
  for (const int signal : {SIGKILL, SIGINT, SIGTERM, SIGHUP, SIGUSR1}) {
    const fs::path out = scratch.path / ("cut" + std::to_string(signal));
    Beside run({"run", tiny, "-o", out.string(), "--set", often}, scratch.path / "said");
    REQUIRE(comes(out / "checkpoint.h5"));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    run.signal(signal);
    const int status = run.wait();
    INFO("signal " << signal << ", status " << status);
    if (status != 0) {  // a fast machine may have been done
      CHECK(status == (signal == SIGKILL ? 128 + SIGKILL : 130));
      const Said said = pmr_says("resume " + out.string());
      INFO(said.text);
      REQUIRE(said.status == 0);
    }
    CHECK(hash_in(out) == hash_of_whole_run());
  }
}

TEST_CASE("A run whose output nobody reads any more leaves a checkpoint and ends with 130") {
  const Scratch scratch("pipe");
  const fs::path out = scratch.path / "out", status = scratch.path / "status";
  // Progress comes after two seconds, which so many intervals take: `head` has gone by then.
  const std::string longer = " --set react.growth=0 --set 'react.first_interval=\"2 ms\"'";
  const std::string whole = (scratch.path / "whole").string();
  REQUIRE(pmr_says("run " + tiny + " -o " + whole + longer).status == 0);
  pmr_says("run " + tiny + " -o " + out.string() + longer + " 2>&1; echo $? > " + status.string() +
               "; } | head -n 1 ; true",
           "{ ");
  REQUIRE(text_of(status) == "130\n");
  CHECK_THAT(text_of(out / "log.txt"), Contains("go on with: pmr resume"));
  REQUIRE(pmr_says("resume " + out.string()).status == 0);
  CHECK(hash_in(out) == hash_in(whole));
}

TEST_CASE("A run is stopped within five seconds in the middle of its rays") {
  const Scratch scratch("rays");
  const fs::path out = scratch.path / "out";
  Beside run({"run", write_many_rays(scratch.path).string(), "-o", out.string()},
             scratch.path / "said");
  REQUIRE(comes(out / "checkpoint.h5"));
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const auto asked = std::chrono::steady_clock::now();
  run.signal(SIGTERM);
  CHECK(run.wait() == 130);
  CHECK(seconds_since(asked) < 5.0);
  CHECK_THAT(text_of(scratch.path / "said"), Contains("go on with: pmr resume " + out.string()));
  CHECK(fs::exists(out / "checkpoint.h5"));
}

TEST_CASE("Before there is anything to be saved a signal ends the program at once, with 130") {
  const Scratch scratch("early");
  // Reads its case from a pipe that nobody writes.
  const fs::path never = scratch.path / "never.toml";
  REQUIRE(::mkfifo(never.c_str(), 0600) == 0);
  Beside run({"run", never.string(), "-o", (scratch.path / "out").string()}, scratch.path / "said");
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  run.signal(SIGTERM);
  CHECK(run.wait() == 130);
  CHECK_FALSE(fs::exists(scratch.path / "out"));
}

TEST_CASE("A folder that a run writes is refused to another, and the first is unharmed") {
  const Scratch scratch("two");
  const fs::path out = scratch.path / "out";
  Beside first({"run", tiny, "-o", out.string(), "--set", often}, scratch.path / "said");
  REQUIRE(comes(out / "checkpoint.h5"));
  const std::string holder = "is being written by process " + std::to_string(first.pid());
  for (const std::string& second : {"run " + tiny + " -o ", std::string("resume ")}) {
    const Said said = pmr_says(second + out.string());
    CHECK(said.status == 2);
    CHECK_THAT(said.text, Contains(holder));
  }
  CHECK(first.wait() == 0);
  CHECK(hash_in(out) == hash_of_whole_run());
}
