#include <catch2/catch.hpp>
#include <fstream>

#include "helpers.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

TEST_CASE("the small case has no fault") {
  const Case made = load(small_case);
  CHECK(made.title == "test");
  CHECK(made.species.at(0).diameter == Approx(2.99e-3).epsilon(1e-15));
  CHECK(made.text == small_case);
}

TEST_CASE("a mistyped key is one fault that names the nearest valid key") {
  CHECK(only_fault("diameter =", "diametr =") ==
        "x.toml:8:1: species.bead.diametr: key 'diametr' is unknown; did you mean 'diameter'?");
  CHECK(only_fault("[fill]", "[fil]") ==
        "x.toml:17:2: fil: key 'fil' is unknown; did you mean "
        "'fill'?");
}

TEST_CASE("a key far from all others is answered with the list of valid keys") {
  CHECK_THAT(only_fault("[fill]\n", "[fill]\nwindspeed = 3\n"),
             Contains("key 'windspeed' is unknown; valid: duration, rest_speed, rest_hold"));
}

TEST_CASE("a missing key is named with what was wanted") {
  CHECK(only_fault("duration = \"1 s\"\n", "") ==
        "x.toml:17:2: fill.duration: is missing; wanted a time such as \"125 ms\"");
}

TEST_CASE("a bare number where a unit belongs is a fault") {
  CHECK(only_fault("\"2.99 mm\"", "2.99") ==
        "x.toml:8:1: species.bead.diameter: 2.99 has no unit; wanted a length such as \"2.99 mm\"");
}

TEST_CASE("a text without a unit is a fault") {
  CHECK_THAT(only_fault("\"2.99 mm\"", "\"2.99\""), Contains("'2.99' has no unit"));
}

TEST_CASE("a unit of the wrong dimension is a fault that says which it is") {
  CHECK(only_fault("\"2.99 mm\"", "\"5 kg\"") ==
        "x.toml:8:1: species.bead.diameter: '5 kg' is a mass; wanted a length such as "
        "\"2.99 mm\"");
}

TEST_CASE("an unknown unit is a fault") {
  CHECK_THAT(only_fault("\"2.99 mm\"", "\"2.99 mn\""), Contains("has the unknown unit 'mn'"));
}

TEST_CASE("figures out of range are faults") {
  CHECK_THAT(only_fault("\"10 g\"", "\"-10 g\""),
             Contains("-10 g is out of range; wanted a mass such as \"1 kg\", above 0"));
  CHECK_THAT(only_fault("\"2.99 mm\"", "\"0 mm\""), Contains("out of range"));
  CHECK_THAT(only_fault("\"20 degC\"", "\"-300 degC\""), Contains("out of range"));
}

TEST_CASE("numbers that are not finite are faults") {
  CHECK_THAT(only_fault("\"2.99 mm\"", "\"nan mm\""), Contains("is not finite"));
  CHECK_THAT(only_fault("\"2.99 mm\"", "nan"), Contains("nan is not finite"));
  CHECK_THAT(only_fault("[0, 0, 1]", "[0, 0, inf]"), Contains("inf is not finite"));
}

TEST_CASE("an unknown material is named with the nearest one") {
  CHECK(only_fault("\"Al2O3\"", "\"Al203\"") ==
        "x.toml:7:1: species.bead.material: material 'Al203' is unknown; did you mean 'Al2O3'?");
}

TEST_CASE("a missing STL file is named") {
  const std::string stl = "kind = \"stl\"\nfile = \"no/such.stl\"\nscale = \"1 mm\"\n";
  const std::string fault =
      only_fault("kind = \"plane\"", stl +
                                         "[walls.other]\nkind = \"plane\"\nmaterial = \"Al2O3\"\n"
                                         "[walls.third]\nkind = \"plane\"");
  CHECK_THAT(fault, Contains("no/such.stl' does not exist"));
}

TEST_CASE("an empty file and a file that is not there are named") {
  CHECK_THAT(faults_of("# only a comment\n").at(0), Contains("x.toml: is empty"));
  try {
    casefile::load_case("/no/such/case.toml");
    FAIL("must throw");
  } catch (const CaseError& error) {
    CHECK(to_string(error.faults().at(0)) ==
          "/no/such/case.toml: cannot be read: No such file or directory");
  }
}

TEST_CASE("a mistake in the syntax is told with its place") {
  CHECK_THAT(only_fault("[fill]", "[fill"), Contains("x.toml:17:6: not TOML"));
}

TEST_CASE("all faults are told together, in the order of their lines") {
  std::string text = replaced(small_case, "\"2.99 mm\"", "\"5 kg\"");
  text = replaced(text, "\"10 g\"", "\"-10 g\"");
  text = replaced(text, "rest_hold", "rest_hald");
  text = replaced(text, "\"0 0 0 m\", radius", "\"0 0 m\", radius");
  const std::vector<std::string> faults = faults_of(text);
  REQUIRE(faults.size() == 4);
  CHECK_THAT(faults[0], Contains("x.toml:8:1: species.bead.diameter"));
  CHECK_THAT(faults[1], Contains("x.toml:9:1: species.bead.mass"));
  CHECK_THAT(faults[2], Contains("x.toml:11:11: species.bead.region.base: wanted three numbers"));
  CHECK_THAT(faults[3], Contains("x.toml:20:1: fill.rest_hald"));
}

TEST_CASE("particles that do not fit their region are a fault") {
  CHECK_THAT(only_fault("\"10 g\"", "\"10 kg\""), Contains("do not fit"));
}

TEST_CASE("a choice that does not exist is one fault") {
  CHECK(only_fault("\"plane\"", "\"plain\"") ==
        "x.toml:13:1: walls.floor.kind: choice 'plain' is unknown; did you mean 'plane'?");
}

TEST_CASE("what is built along z wants gravity along -z, and layers of gas want gravity") {
  const std::string sideways =
      replaced(small_case, "\"0 0 -9.80665 m/s2\"", "\"9.80665 0 0 m/s2\"");
  const std::string tool =
      "[decomposition]\naxis_point = \"0 0 0 m\"\nramp_azimuth = \"0 deg\"\nlayer_fraction = "
      "[0.5]\nsectors = 8\n";
  CHECK(faults_of(sideways).empty());
  CHECK(faults_of(small_case + tool).empty());
  const auto told = faults_of(sideways + tool);
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0], Contains("decomposition: its layers lie across z; wanted gravity along -z"));
  const std::string floating = replaced(small_case, "\"0 0 -9.80665 m/s2\"", "\"none\"");
  CHECK(faults_of(floating + tool).empty());
  const std::string gas =
      "[chamber]\npressure = \"1 bar\"\noxygen_fraction = 0.2\ngas_temperature = \"20 degC\"\n"
      "film_coefficient = \"0 W/m2/K\"\nleak = \"0 mol/s/Pa\"\n[models]\nbed_gas = true\n";
  CHECK(faults_of(small_case + gas).empty());
  const auto layers = faults_of(floating + gas);
  REQUIRE(layers.size() == 1);
  CHECK_THAT(layers[0], Contains("bed_gas has layers across gravity; wanted gravity"));
}

TEST_CASE(
    "a delta from which no reaction can start is refused, with the temperature that it takes") {
  const std::string granules =
      "[species.granule]\nmaterial = \"SrFeO3\"\ndiameter = \"1.5 mm\"\ncount = 3\ntemperature = "
      "\"700 degC\"\nregion = {base = \"50 0 0 mm\", radius = \"9 mm\", height = \"9 mm\"}\n"
      "[chamber]\npressure = \"1 bar\"\noxygen_fraction = 0.2\ngas_temperature = \"20 degC\"\n"
      "film_coefficient = \"0 W/m2/K\"\nleak = \"0 mol/s/Pa\"\n[models]\nreaction = true\n";
  const auto told = [&](const std::string& delta) {
    return faults_of(small_case + granules,
                     {"species.granule.delta=" + delta,
                      "materials.SrFeO3.redox.equilibrium.enthalpy=\"arctan\""});
  };
  const auto frozen = [&](const std::string& temperature) {
    return told("{equilibrium_at=\"" + temperature + "\",oxygen=\"0.21 bar\"}");
  };
  CHECK(frozen("20 degC").empty());
  CHECK(frozen("200 K").empty());
  REQUIRE(frozen("160 K").size() == 1);
  CHECK_THAT(frozen("160 K")[0],
             Contains("species.granule.delta: an equilibrium at 160 K is too cold") &&
                 Contains("no reaction can start at 973.15 K; wanted 1") && Contains(" K or more"));
  REQUIRE(frozen("20 K").size() == 1);
  CHECK_THAT(frozen("20 K")[0], Contains("20 K is out of range; wanted a temperature") &&
                                    Contains("between 150 and 3000"));
  CHECK(told("1e-6").empty());
  REQUIRE(told("1e-12").size() == 1);
  CHECK_THAT(told("1e-12")[0], Contains("species.granule.delta: of 1e-12 no reaction can start"));
  // A law that does not ask for the pressure of such a delta has no trouble with it.
  const std::string relaxation =
      "materials.SrFeO3.redox.rate={law=\"relaxation\",time=\"40 s\",reference_temperature=\"673 "
      "K\",reduction_energy=\"144 kJ/mol\",oxidation_energy=\"92 kJ/mol\",shortest=\"1 s\"}";
  CHECK(faults_of(small_case + granules, {"species.granule.delta=1e-12", relaxation}).empty());
}

TEST_CASE(
    "a law without a unique equilibrium is refused in its fit's range and where one is asked for") {
  const std::string granules =
      "[species.granule]\nmaterial = \"SrFeO3\"\ndiameter = \"1.5 mm\"\ncount = 3\ntemperature = "
      "\"700 degC\"\nregion = {base = \"50 0 0 mm\", radius = \"9 mm\", height = \"9 mm\"}\n"
      "[chamber]\npressure = \"1 bar\"\noxygen_fraction = 0.2\ngas_temperature = \"20 degC\"\n"
      "film_coefficient = \"0 W/m2/K\"\nleak = \"0 mol/s/Pa\"\n[models]\nreaction = true\n";
  // dh falls by c delta: unique where c < 16 a R T, below 600 K here not.
  const auto told = [&](const std::string& delta, const std::string& fit_minimum) {
    const std::string law =
        "materials.SrFeO3.redox.equilibrium.polynomial={entropy=\"115 J/mol/K\",configuration=1,"
        "enthalpy_0=\"100 kJ/mol\",enthalpy_1=\"-79.819 kJ/mol\",enthalpy_2=\"0 "
        "J/mol\",fit_delta_minimum=0.1,"
        "fit_delta_maximum=0.45,fit_temperature_minimum=\"" +
        fit_minimum +
        "\",fit_temperature_maximum=\"1500 K\",fit_pressure_minimum=\"1 mbar\","
        "fit_pressure_maximum=\"1 bar\"}";
    return faults_of(small_case + granules, {law, "species.granule.delta=" + delta});
  };
  CHECK(told("0.3", "610 K").empty());
  REQUIRE(told("0.3", "590 K").size() == 1);
  CHECK_THAT(told("0.3", "590 K")[0], Contains("redox.equilibrium.enthalpy") &&
                                          Contains("at the lowest temperature of its fit"));
  CHECK(told("{equilibrium_at=\"610 K\",oxygen=\"0.21 bar\"}", "610 K").empty());
  CHECK(told("{equilibrium_at=\"590 K\",oxygen=\"0.21 bar\"}", "590 K").size() == 1);
  const std::string asked =
      "species.granule.delta={equilibrium_at=\"700 degC\",oxygen=\"0.21 bar\"}";
  CHECK(faults_of(small_case + granules,
                  {asked, "materials.SrFeO3.redox.equilibrium.enthalpy=\"smooth\""})
            .size() == 1);
  const auto cold = told("{equilibrium_at=\"590 K\",oxygen=\"0.21 bar\"}", "610 K");
  REQUIRE(cold.size() == 1);
  CHECK_THAT(cold[0],
             Contains("species.granule.delta: the law has no unique equilibrium at 590 K"));
}

TEST_CASE("an emissivity that would be read as another is refused") {
  const std::string shiny = "[materials.Al2O3]\nemissivity = ";
  CHECK(faults_of(small_case + shiny + "0.001\n").empty());
  const auto told = faults_of(small_case + shiny + "0.0009\n");
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0], Contains("emissivity"));
}

TEST_CASE("heat models want the walls' thermal boundary and the gas") {
  const auto faults =
      faults_of(small_case + "[react]\nend = \"1 s\"\n[models]\nconduction = true\n");
  REQUIRE(faults.size() == 2);
  CHECK_THAT(faults[0], Contains("walls.floor.thermal: is missing"));
  CHECK_THAT(faults[1], Contains("the gas gaps want [chamber]"));
}

TEST_CASE("a CSV file of particles is read with the units of its header") {
  const std::string file = temporary("pmr_test_particles.csv");
  std::ofstream(file) << "species,x [mm],y [mm],z [mm],vx [m/s],temperature [degC]\n"
                         "bead,1,2,3,0.5,100\nbead,-1,2,3,0,200\n";
  std::string text = replaced(small_case, "mass = \"10 g\"\n", "");
  text =
      replaced(text, "region = {base = \"0 0 0 m\", radius = \"20 mm\", height = \"80 mm\"}", "");
  text = "particles = {csv = \"" + file + "\"}\n" + text;
  const Case made = load(text);
  REQUIRE(made.particles.size() == 2);
  CHECK(made.particles[0].position.isApprox(Vec3(1e-3, 2e-3, 3e-3)));
  CHECK(made.particles[0].velocity == Vec3(0.5, 0, 0));
  CHECK(made.particles[1].temperature.value() == Approx(473.15));
  CHECK(made.species[0].count == 2);

  std::ofstream(file) << "species,x [mm],y,z [kg]\n";
  const auto header_faults = faults_of(text);
  REQUIRE(header_faults.size() >= 2);
  CHECK_THAT(header_faults[0] + header_faults[1], Contains("has no unit") && Contains("is a mass"));
  std::ofstream(file) << "species,x [mm],y [mm],z [mm]\nbeed,1,2,x\n";
  const auto row_faults = faults_of(text);
  REQUIRE(row_faults.size() >= 2);
  CHECK_THAT(row_faults[0], Contains(file + ":2:1: species") && Contains("'bead'"));
  CHECK_THAT(row_faults[1], Contains("'x' is no finite number"));
}

TEST_CASE("a case of mechanics alone needs no heat data, no temperatures and no rest") {
  const std::string powder =
      "[materials.powder]\ndensity = \"2500 kg/m3\"\nyoung_soft = \"5 MPa\"\n"
      "poisson_soft = 0.3\n";
  std::string contacts;
  for (const char* pair : {"powder|powder", "powder|coated-wall"})
    contacts += "[contacts.\"" + std::string(pair) +
                "\"]\nfriction = 0.5\nrolling_friction = 0.0\nrestitution = 0.5\n";
  std::string text = replaced(small_case, "\"Al2O3\"", "\"powder\"");
  text = replaced(text, "temperature = \"20 degC\"\n", "");
  text = replaced(text, "rest_speed = \"2 mm/s\"\nrest_hold = \"20 ms\"\n", "") + powder + contacts;
  const Case made = load(text);
  CHECK(made.species[0].initial_temperature == Approx(293.15));
  CHECK(std::get<ConstantHeat>(made.materials.list[0].heat).heat_capacity == 0.0);
  CHECK(made.fill->rest.rms_speed == 0.0);

  const auto with_heat = faults_of(text +
                                   "[react]\nend = \"1 s\"\n[models]\nradiation = {surroundings = "
                                   "\"20 degC\"}\n");
  std::string all;
  for (const std::string& fault : with_heat) all += fault + "\n";
  CHECK_THAT(all, Contains("materials.powder.heat: is missing") &&
                      Contains("species.bead.temperature: is missing"));
}

TEST_CASE("half of the rest's criterion is a fault") {
  CHECK_THAT(only_fault("rest_hold = \"20 ms\"\n", ""), Contains("fill.rest_hold: is missing"));
}
