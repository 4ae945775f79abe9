// Experiments as their users see them: a closed form taken for a measurement.
#include <catch2/catch.hpp>

#include "program.hpp"

namespace {

namespace fs = std::filesystem;
using Catch::Contains;

// The pair of cases/heat-pair.toml: T = 421.15 + 10 exp(-7.0104 t) K of the hotter sphere.
fs::path write_experiment(const fs::path& folder, const std::string& deviation) {
  std::ofstream(folder / "pair.csv") << "time [s],temperature [K]\n0.1,426.1107\n0.2,423.6108\n"
                                        "0.3,422.3708\n";
  const fs::path file = folder / "pair.toml";
  std::ofstream(file)
      << "title = \"Two spheres\"\nteaches = \"contact conduction\"\nsource = \"closed "
         "form\"\ncase = \""
      << (source_dir / "cases/heat-pair.toml").string() << "\"\n"
      << R"(
points = "pair.csv"
[settings]
"thermocouples.hot.position" = "-47.5 0 0 um"
"thermocouples.hot.radius" = "10 um"
[variants.contact]
label = "as it is"
settings = {}
[variants.loose]
label = "loose tolerances"
settings = {"models.network.relative_tolerance" = 1e-6}
[axis]
value = "time"
unit = "s"
[figures]
hot = {series = "thermocouple.hot", at = "time"}
[quantities.temperature]
label = "hot sphere"
unit = "K"
computed = "hot"
measured = "temperature"
deviation = ")"
      << deviation << R"("
bar = {largest = 0.01}
on_miss = "cold feet"
)";
  return file;
}

}  // namespace

TEST_CASE("An experiment is run, compared and drawn; the same command makes nothing anew") {
  const Scratch scratch("validate");
  const fs::path file = write_experiment(scratch.path, "0.1"), out = scratch.path / "out";
  const std::string command = "validate " + file.string() + " -o " + out.string();
  const Said said = pmr_says(command);
  INFO(said.text);
  REQUIRE(said.status == 0);
  CHECK_THAT(said.text, Contains("held     pair"));
  const std::string page = text_of(out / "report.html");
  CHECK_THAT(page, Contains("1 of 1 bars are held") && Contains("Two spheres") &&
                       Contains("runs/pair_contact/report.html") && !Contains("cold feet"));
  CHECK_THAT(text_of(out / "validation.csv"),
             Contains("pair,temperature,K,contact,1,0.1,426.1107"));
  const Said again = pmr_says(command);
  CHECK(again.status == 0);
  CHECK_THAT(again.text, Contains("runs     2, 0 to be made"));
  CHECK(text_of(out / "report.html") == page);
}

TEST_CASE("A plan makes nothing, and a wrong experiment is told with status 2") {
  const Scratch scratch("validate-wrong");
  const fs::path file = write_experiment(scratch.path, "0.1"), out = scratch.path / "out";
  const Said plan = pmr_says("validate " + file.string() + " --plan -o " + out.string());
  CHECK(plan.status == 0);
  CHECK_THAT(plan.text, Contains("2 to be made"));
  CHECK(!fs::exists(out));
  const Said unknown = pmr_says("validate pebles -o " + out.string());
  CHECK(unknown.status == 2);
  CHECK_THAT(unknown.text, Contains("did you mean 'pebbles'?"));
  const fs::path wrong = write_experiment(scratch.path, "0.1 +");
  const Said said = pmr_says("validate " + wrong.string() + " -o " + out.string());
  CHECK(said.status == 2);
  CHECK_THAT(said.text, Contains("quantities"));
  CHECK(!fs::exists(out));
}
