#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numeric>

#include "chemistry/redox.hpp"
#include "helpers.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {
const Material& material(const Case& made, const std::string& name) {
  for (const Material& one : made.materials.list)
    if (one.name == name) return one;
  throw std::runtime_error("no material " + name);
}
}  // namespace

TEST_CASE("every figure of a shipped material has a mark and a source") {
  const Case made = casefile::load_case(PMR_SOURCE_DIR "/cases/demonstrator.toml");
  REQUIRE(made.materials.list.size() == 5);
  for (const Material& one : made.materials.list) {
    CHECK(one.provenance.size() >= 3);
    for (const Provenance& figure : one.provenance) {
      INFO(one.name << " " << figure.key << " " << figure.value);
      CHECK(std::string("PLDA").find(figure.mark) != std::string::npos);
      CHECK(figure.source != "given in the case");
      CHECK(!figure.value.empty());
    }
  }
}

TEST_CASE("the shipped figures arrive in SI") {
  const Case made = casefile::load_case(PMR_SOURCE_DIR "/cases/demonstrator.toml");
  const Material& ferrite = material(made, "SrFeO3");
  REQUIRE(ferrite.redox);
  CHECK(ferrite.redox->molar_mass == Approx(0.191462));
  CHECK(ferrite.redox->equilibrium.fit_pressure_maximum == Approx(9e4));
  CHECK(std::get<PowerRate>(ferrite.redox->rate).reduction.activation_energy == Approx(75.7e3));
  const Material& alumina = material(made, "Al2O3");
  // NIST: f and h in kJ/mol
  CHECK(std::get<Shomate>(alumina.heat).f == Approx(-1717.930).epsilon(1e-12));
  CHECK(alumina.emissivity(873.15, 0.0) == Approx(0.65));
  CHECK(std::get<AluminaConductivity>(alumina.conductivity).factor == 0.6);
  // 0.14 of 0.18 W/m/K at 600 degC and 1000 Pa, from which gas_share and half_pressure were fitted
  const auto& board = std::get<TabulatedConductivity>(material(made, "fibre-board").conductivity);
  const double left = 1 - board.gas_share * (1 - 1 / (1 + board.half_pressure / 1000.0));
  CHECK(left * board.table(873.15) == Approx(0.14).epsilon(0.01));
}

TEST_CASE("the smooth law of SrFeO3 meets the thermobalance that it was fitted to") {
  const Case made = casefile::load_case(PMR_SOURCE_DIR "/cases/demonstrator.toml");
  const RedoxEquilibrium& eq = material(made, "SrFeO3").redox->equilibrium;
  std::ifstream file(PMR_SOURCE_DIR "/cases/validation/srfeo3-thermobalance.csv");
  std::vector<double> off;  // [1] up to the delta of the balance's zero, which it does not tell
  for (std::string line; std::getline(file, line);) {
    double celsius = 0.0, pressure = 0.0, delta = 0.0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf", &celsius, &pressure, &delta) == 3)
      off.push_back(chemistry::equilibrium_delta(eq, celsius + zero_celsius, pressure * bar) -
                    delta);
  }
  REQUIRE(off.size() == 20);
  const double zero = std::accumulate(off.begin(), off.end(), 0.0) / 20.0;
  CHECK(zero == Approx(0.1409).margin(0.001));
  double square = 0.0;
  for (const double miss : off) square += (miss - zero) * (miss - zero);
  CHECK(std::sqrt(square / 20.0) < 0.005);
  CHECK(chemistry::equilibrium_delta(eq, 1173.15, 0.21 * standard_atmosphere) ==
        Approx(0.40).margin(0.01));  // the anchor
}

TEST_CASE("solids are given over temperature by rows or by a polynomial") {
  // Graphite of a pebble bed (De Beer 2014): k at 800 K 91.6 W/m/K by hand.
  const Case made = load(
      small_case,
      {"materials.Al2O3.heat={law=\"polynomial\", coefficients=\"600 0.5 J/kg/K\", "
       "minimum_temperature=\"300 K\", maximum_temperature=\"1500 K\"}",
       "materials.Al2O3.conductivity={law=\"polynomial\", coefficients=\"230.01 -0.3179 1.403e-4 "
       "6.566e-8 -7.255e-11 1.595e-14 W/m/K\", minimum_temperature=\"300 K\", "
       "maximum_temperature=\"1300 K\"}",
       "materials.Al2O3.emissivity={coefficients=[0.9, -2e-4], minimum_temperature=\"300 K\", "
       "maximum_temperature=\"1300 K\"}"});
  const Material& alumina = material(made, "Al2O3");
  const auto& heat = std::get<TabulatedHeat>(alumina.heat).rows;
  CHECK(heat.table(1000.0) == Approx(1100.0).epsilon(1e-12));
  CHECK(heat.integral(1000.0) - heat.integral(500.0) == Approx(975.0 * 500.0).epsilon(1e-12));
  const auto& k = std::get<TabulatedConductivity>(alumina.conductivity).table;
  const double T = 800.0;
  const double by_hand = 230.01 - 0.3179 * T + 1.403e-4 * T * T + 6.566e-8 * T * T * T -
                         7.255e-11 * std::pow(T, 4) + 1.595e-14 * std::pow(T, 5);
  CHECK(k(T) == Approx(by_hand).epsilon(1e-5));
  CHECK(k(2000.0) == k(1300.0));
  CHECK(alumina.emissivity(1000.0, 0.0) == Approx(0.7).epsilon(1e-12));

  CHECK_THROWS_WITH(load(small_case, {"materials.Al2O3.emissivity={coefficients=[0.9, -2e-3], "
                                      "minimum_temperature=\"300 K\", "
                                      "maximum_temperature=\"1300 K\"}"}),
                    Contains("coefficients") && Contains("at 450 K they give"));
  CHECK_THROWS_WITH(load(small_case, {"materials.Al2O3.heat={law=\"tabel\"}"}),
                    Contains("did you mean 'table'"));
  const std::string board[] = {
      "materials.fibre-board.heat={law=\"table\", temperature=\"300 600 K\", "
      "value=\"900 1000 J/kg/K\"}"};
  CHECK_THROWS_WITH(
      casefile::load_case(PMR_SOURCE_DIR "/cases/demonstrator.toml", board),
      Contains("materials.fibre-board.heat: wanted the law 'constant' of a material of linings"));
}

TEST_CASE("a case overrides single figures of a shipped material") {
  const Case made = load(small_case + "[materials.Al2O3]\ndensity = \"3000 kg/m3\"\n",
                         {"materials.Al2O3.heat={law=\"constant\", heat_capacity=\"900 J/kg/K\"}"});
  const Material& alumina = material(made, "Al2O3");
  CHECK(alumina.density == 3000);
  CHECK(std::get<ConstantHeat>(alumina.heat).heat_capacity == 900);
  CHECK(alumina.young_real == 300e9);
  CHECK(alumina.provenance.at(0).mark == 'A');
  CHECK(alumina.provenance.at(0).source == "given in the case");
}

TEST_CASE("a setting reaches into a law of a shipped material") {
  const std::string text = replaced(small_case, "temperature =", "delta = 0.3\ntemperature =");
  const Case made =
      load(replaced(text, "\"Al2O3\"", "\"SrFeO3\""), {"materials.SrFeO3.redox.rate.factor=0.1"});
  const auto& rate = std::get<PowerRate>(material(made, "SrFeO3").redox->rate);
  CHECK(rate.factor == 0.1);
  CHECK(rate.reduction.pre_exponential == 623);
}

TEST_CASE("a new material wants every figure of its use and its contact pairs") {
  const std::string glass =
      "[materials.glass]\ndensity = \"2500 kg/m3\"\n"
      "heat = {law = \"constant\", heat_capacity = \"800 J/kg/K\"}\n";
  const auto faults = faults_of(replaced(small_case, "\"Al2O3\"", "\"glass\"") + glass);
  REQUIRE(faults.size() == 3);
  CHECK_THAT(faults[0], Contains("x.toml:7:1: materials.glass.young_soft: is missing"));
  CHECK_THAT(faults[1], Contains("contacts.\"glass|glass\": is missing"));
  CHECK_THAT(faults[2], Contains("contacts.\"coated-wall|glass\": is missing"));
}

TEST_CASE("mistakes in contact pairs are faults, used or not") {
  const auto faults = faults_of(small_case +
                                "[contacts.\"Al2O3|coated-wal\"]\nfriction = 1.0\n"
                                "[contacts.\"SrFeO3|Al2O3\"]\nrestitution = 1.5\n"
                                "[contacts.Al2O3]\nfriction = 0.1\n");
  std::string all;
  for (const auto& fault : faults) all += fault + "\n";
  CHECK_THAT(all, Contains("material 'coated-wal' is unknown; did you mean 'coated-wall'?"));
  CHECK_THAT(all, Contains("contacts.\"Al2O3|SrFeO3\".restitution: 1.5 is out of range"));
  CHECK_THAT(all, Contains("wanted a pair of materials"));
}
