// Full disks, folders that vanish, what a kill leaves: told, and gone on from.
#include <catch2/catch.hpp>

#include "program.hpp"

namespace {

namespace fs = std::filesystem;
using Catch::Contains;

const std::string save_often = " --set 'output.checkpoint_wall_time = \"1 ms\"'";

}  // namespace

TEST_CASE("A run on a full disk ends with 3, says how to go on, and goes on with the same bits") {
  const Scratch scratch("full");
  const fs::path whole = scratch.path / "whole", cut = scratch.path / "cut";
  REQUIRE(pmr_says("run " + tiny + " -o " + whole.string() + save_often).status == 0);
  // In blocks of 512 bytes: files grow to three quarters of what they have to.
  const auto blocks = fs::file_size(whole / "run.h5") * 3 / 4 / 512;
  const std::string limit = "ulimit -f " + std::to_string(blocks) + "; ";
  const Said said = pmr_says("run " + tiny + " -o " + cut.string() + save_often, limit);
  INFO(said.text);
  CHECK(said.status == 3);
  CHECK_THAT(said.text, Contains("File too large"));
  CHECK_THAT(said.text, Contains("go on with: pmr resume " + cut.string()));
  CHECK_FALSE(fs::exists(cut / "run.h5.tmp"));
  CHECK(pmr_says("analyse " + cut.string()).status == 0);  // the last files are whole
  REQUIRE(pmr_says("resume " + cut.string()).status == 0);
  CHECK(hash_in(cut) == hash_in(whole));
}

TEST_CASE("A report that finds no room costs nothing of the run") {
  const Scratch scratch("page");
  const fs::path whole = scratch.path / "whole", cut = scratch.path / "cut";
  REQUIRE(pmr_says("run " + tiny + " -o " + whole.string()).status == 0);
  const auto page = fs::file_size(whole / "report.html");
  REQUIRE(page > fs::file_size(whole / "run.h5"));
  const std::string limit = "ulimit -f " + std::to_string(page / 512) + "; ";
  const Said said = pmr_says("run " + tiny + " -o " + cut.string(), limit);
  CHECK(said.status == 3);
  CHECK_THAT(said.text, Contains("report.html: cannot be written: File too large"));
  CHECK(hash_in(cut) == hash_in(whole));
  CHECK(pmr_says("resume " + cut.string()).status == 0);  // writes what was missing
  CHECK(fs::exists(cut / "report.html"));
}

TEST_CASE("A folder that is removed while a run writes it is no fault of the input") {
  const Scratch scratch("removed");
  const fs::path out = scratch.path / "out";
  Beside run({"run", tiny, "-o", out.string()}, scratch.path / "said");
  REQUIRE(comes(out / "checkpoint.h5"));
  fs::remove_all(out);
  CHECK(run.wait() == 3);
  CHECK_THAT(text_of(scratch.path / "said"), Contains("begin again with: pmr run"));
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("What a run that was killed at once has left is taken over") {
  const Scratch scratch("leftovers");
  const fs::path out = scratch.path / "out";
  fs::create_directories(out);
  const std::string quick = " --set 'react.end = \"0.2 s\"' -o " + out.string();
  std::ofstream(out / "log.txt").close();
  std::ofstream(out / ".lock") << "process 1 on nowhere\n";
  std::ofstream(out / "run.h5.tmp") << "half a file";
  CHECK(pmr_says("run " + tiny + quick).status == 0);
  CHECK_FALSE(fs::exists(out / "run.h5.tmp"));
  CHECK_FALSE(fs::exists(out / ".lock"));
  fs::remove_all(out);
  fs::create_directories(out);
  std::ofstream(out / "log.txt") << "2026-01-31T12:00:00+0000 info Tiny reactor\n";
  CHECK(pmr_says("run " + tiny + quick).status == 0);
  fs::remove_all(out);
  fs::create_directories(out);
  std::ofstream(out / "log.txt") << "My diary of the year\n";
  CHECK(pmr_says("run " + tiny + quick).status == 2);
  CHECK(text_of(out / "log.txt") == "My diary of the year\n");
}

TEST_CASE("Names that no file system takes are refused as input") {
  const std::string name(256, 'x');
  for (const std::string& before :
       {"run " + tiny + " -o ", std::string("resume "), std::string("report "), std::string("run "),
        "run " + tiny + " --bed ", std::string("sweep "), std::string("analyse ")}) {
    const std::string line = before + name;
    const Said said = pmr_says(line);
    INFO(line.substr(0, 20) << " -> " << said.text);
    CHECK(said.status == 2);
    CHECK_THAT(said.text, Contains(name));
  }
}

TEST_CASE("A page or picture whose folder is not there is refused before it is drawn") {
  const Scratch scratch("nowhere");
  const std::string out = (scratch.path / "out").string();
  REQUIRE(pmr_says("run " + tiny + " -o " + out + " --set 'react.end = \"0.2 s\"'").status == 0);
  for (const std::string verb : {"report ", "render "}) {
    const Said said = pmr_says(verb + out + " -o /nowhere/at/all");
    CHECK(said.status == 2);
    CHECK_THAT(said.text, Contains("/nowhere/at"));
  }
}
