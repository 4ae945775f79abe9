// Cases that lie on others.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>

#include "helpers.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {
void write(const std::string& name, const std::string& text) {
  std::ofstream(temporary(name)) << text;
}

std::string fault_of(const std::string& file) {
  try {
    casefile::load_case(temporary(file), {});
  } catch (const CaseError& error) {
    return to_string(error.faults().front());
  }
  return "";
}
}  // namespace

TEST_CASE("a case says only what differs from the one it extends") {
  write("base.toml", small_case);
  write("over.toml",
        "extends = \"base.toml\"\ntitle = \"over\"\n[species.bead]\nmass = \"20 g\"\n"
        "[walls.floor]\nthermal = {kind = \"adiabatic\"}\n");
  const Case base = casefile::load_case(temporary("base.toml"), {});
  const Case over = casefile::load_case(temporary("over.toml"), {});
  CHECK(over.title == "over");
  CHECK(over.species.at(0).diameter == base.species.at(0).diameter);
  CHECK(over.species.at(0).requested_mass == Approx(0.02));
  CHECK(load(over.text).species.at(0).count == over.species.at(0).count);  // stands on its own
}

TEST_CASE("a case lies on several, each laid on the one before") {
  write("base.toml", small_case);
  write("contacts.toml",
        "[contacts.\"Al2O3|Al2O3\"]\nfriction = 0.37\n[calibration]\nlab = \"L\"\n");
  write("over.toml", "extends = [\"base.toml\", \"contacts.toml\"]\ntitle = \"over\"\n");
  const Case over = casefile::load_case(temporary("over.toml"), {});
  CHECK(over.title == "over");
  const auto& list = over.materials.list;
  const auto bead =
      std::find_if(list.begin(), list.end(), [](const Material& m) { return m.name == "Al2O3"; });
  REQUIRE(bead != list.end());
  const auto i = static_cast<std::size_t>(bead - list.begin());
  CHECK(over.materials.pair(i, i).friction == 0.37);
  CHECK(over.materials.pair(i, i).restitution == 0.75);  // as shipped
  write("over.toml", "extends = [\"base.toml\", 3]\ntitle = \"over\"\n");
  CHECK_THAT(fault_of("over.toml"), Contains("over.toml:1:") && Contains("or a list of them"));
}

TEST_CASE("a base that is not there, is no name or comes back to itself is told with its place") {
  write("lost.toml", "extends = \"nowhere.toml\"\n");
  CHECK_THAT(fault_of("lost.toml"), Contains("lost.toml:1:1: extends: there is no case file"));
  write("number.toml", "extends = 3\n");
  CHECK_THAT(fault_of("number.toml"), Contains("wanted a case file's name in quotes"));
  write("circle.toml", "extends = \"circle.toml\"\n");
  CHECK_THAT(fault_of("circle.toml"), Contains("in a circle"));
}

TEST_CASE("a pump's curve, a vent and the bed's gas are read") {
  const std::string text = small_case + R"([react]
end = "10 s"
[chamber]
closing = "1 s"
volume = "1 l"
pressure = "1 atm"
oxygen_fraction = 0.21
gas_temperature = "20 degC"
film_coefficient = "0 W/m2/K"
leak = "0 mol/s/Pa"
[chamber.pump]
start = "1 s"
speed = {pressure = "10 1000 Pa", speed = "1 2 l/s"}
ultimate = "1 Pa"
set_point = "1000 Pa"
[chamber.vent]
start = "9 s"
conductance = "1e-7 mol/s/Pa"
[models]
reaction = true
bed_gas = {layers = 5}
)";
  const Case made = load(text);
  CHECK(made.chamber->pump->speed(505.0) == Approx(1.5e-3));
  CHECK(made.chamber->vent->conductance == Approx(1e-7));
  CHECK(made.models.bed_gas->layers == 5);
  CHECK_THAT(faults_of(small_case + "[models]\nbed_gas = true\n").front(),
             Contains("the bed's gas wants [chamber]"));
}
