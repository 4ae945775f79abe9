// Calibrations as their users see them: the shipped example, kills, wrong input.
#include <catch2/catch.hpp>
#include <cmath>

#include "program.hpp"

namespace {

namespace fs = std::filesystem;
using Catch::Contains;

const std::string shipped = (source_dir / "cases/calibration/pump.toml").string();

// The number behind `"name": "speed"` ... `"key": `.
double number_after(const std::string& text, const std::string& name, const std::string& key) {
  const std::size_t at = text.find(key, text.find(name));
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + key.size()));
}

}  // namespace

TEST_CASE(
    "The shipped example finds the pump and the leak, killed twice or not, to the same bytes") {
  const Scratch scratch("calibrate");
  const fs::path whole = scratch.path / "whole", cut = scratch.path / "cut";
  const Said said = pmr_says("calibrate " + shipped + " -o " + whole.string());
  INFO(said.text);
  REQUIRE(said.status == 0);
  const std::string json = text_of(whole / "calibration.json");
  for (const auto& [name, truth] : {std::pair{"speed", 2e-4}, std::pair{"leak", 2e-10}}) {
    const std::string key = std::string("\"name\":\"") + name + "\"";
    const double value = number_after(json, key, "\"value\":");
    const double deviation = number_after(json, key, "\"standard_deviation\":");
    CHECK(std::abs(value / truth - 1.0) < 0.02);
    CHECK(std::abs(value - truth) < 2.0 * deviation);
    CHECK(deviation < 0.04 * truth);
  }
  CHECK_THAT(text_of(whole / "report.html"), Contains("Where the measured levels meet"));

  for (const int after : {700, 1500}) {
    Beside calibrate({"calibrate", shipped, "-o", cut.string()}, scratch.path / "said");
    std::this_thread::sleep_for(std::chrono::milliseconds(after));
    calibrate.signal(SIGKILL);
    calibrate.wait();
  }
  const Said rest = pmr_says("calibrate " + shipped + " -o " + cut.string());
  INFO(rest.text);
  REQUIRE(rest.status == 0);
  for (const char* file : {"calibration.json", "contacts.toml", "runs.csv"})
    CHECK(text_of(cut / file) == text_of(whole / file));

  // What was found is a base for cases: the pump of another case takes it.
  std::ofstream(scratch.path / "case.toml")
      << "extends = [\"" << (source_dir / "cases/calibration/base/evacuation.toml").string()
      << "\", \"" << (whole / "contacts.toml").string() << "\"]\n";
  const Said checked = pmr_says("check " + (scratch.path / "case.toml").string());
  INFO(checked.text);
  CHECK(checked.status == 0);
}

TEST_CASE("A lab file with mistakes is refused with status 2 and leaves no folder") {
  const Scratch scratch("calibrate-wrong");
  std::string text = text_of(shipped);
  const auto replace = [&](const std::string& what, const std::string& with) {
    text.replace(text.find(what), what.size(), with);
  };
  for (int test = 0; test < 2; ++test)
    replace("\"base/", "\"" + (source_dir / "cases/calibration/base/").string());
  replace("chamber.pump.speed", "chamber.pump.sped");
  const fs::path lab = scratch.path / "lab.toml", out = scratch.path / "out";
  std::ofstream(lab) << text;
  const Said key = pmr_says("calibrate " + lab.string() + " -o " + out.string());
  CHECK(key.status == 2);
  CHECK_THAT(key.text, Contains("did you mean 'speed'"));
  replace("predictions", "perdictions");
  replace("[tests.far.responses.pressure]\nkey", "[tests.far.responses.pressure]\nkye");
  std::ofstream(lab) << text;
  const Said said = pmr_says("calibrate " + lab.string() + " -o " + out.string());
  CHECK(said.status == 2);
  CHECK_THAT(said.text, Contains("did you mean 'predictions'") && Contains("did you mean 'key'"));
  CHECK_FALSE(fs::exists(out));
  CHECK(pmr_says("calibrate pomp --plan").status == 2);
  CHECK(pmr_says("calibrate pump --plan").status == 0);
}
