// Whole calibrations, with closed forms in place of simulations: x + y and x y of two coefficients.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "bench.hpp"
#include "calibrate/outputs.hpp"
#include "calibrate/synthetic.hpp"
#include "pmr/base/random.hpp"
#include "pmr/base/stop.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

const std::string wall = "SrFeO3|coated-wall\".";

std::string two_unknowns(const std::string& stage) {
  return unknown(stage, "x", wall + "friction") + unknown(stage, "y", wall + "rolling_friction");
}

const std::string plain = "predictions = 0\n[sampling]\npoints = 14\nmost = 20\nreplicated = 0\n";

// Levels of x + y, x y and x itself.
std::string levels(double sum, double product, double sum_error, double product_error) {
  return test_table("t") + response("t", "sum", sum, sum_error) +
         response("t", "product", product, product_error) + response("t", "first", 0.4, 0.03);
}

Said closed_forms(const Case& c) {
  const PairContact p = on_wall(c, "SrFeO3");
  return {{{"sum", p.friction + p.rolling_friction},
           {"product", p.friction * p.rolling_friction},
           {"first", p.friction}},
          ""};
}

}  // namespace

TEST_CASE("Two levels that cross twice give two modes, and a third level picks one of them") {
  const std::string lab =
      plain + levels(0.5, 0.04, 0.01, 0.001) + "[stages.s]\nuse = [\"t.sum\", \"t.product\"]\n";
  Bench bench(lab + two_unknowns("s"), closed_forms);
  const auto open = bench.solved();
  INFO(open.stages.at(0).ended);
  for (const std::string& warning : open.warnings) UNSCOPED_INFO(warning);
  REQUIRE(open.stages.at(0).modes.size() == 2);
  CHECK(open.stages[0].points.size() <= 20);
  for (const auto& mode : open.stages[0].modes) {
    CHECK(mode.is_crossing);
    CHECK(std::min(mode.at[0], mode.at[1]) == Approx(0.1).margin(0.005));
    CHECK(std::max(mode.at[0], mode.at[1]) == Approx(0.4).margin(0.005));
    CHECK(mode.mode.mass == Approx(0.5).margin(0.05));
  }
  CHECK_THAT(open.warnings.at(0), Contains("none clearly the heaviest"));

  bench.rewrite(lab + "decide = [\"t.first\"]\n" + two_unknowns("s"));
  const auto decided = bench.solved();
  CHECK(decided.found.values.at(0) == Approx(0.4).margin(0.005));
  CHECK(decided.found.values.at(1) == Approx(0.1).margin(0.005));
  CHECK(decided.stages[0].best().weight > 0.99);
  CHECK_THAT(decided.stages[0].decided, Contains("t.first"));
  CHECK(std::sqrt(decided.found.covariance[0][0]) == Approx(0.01374).epsilon(0.1));
  CHECK(std::sqrt(decided.found.covariance[1][1]) == Approx(0.00471).epsilon(0.1));
}

TEST_CASE("A prior decides where the levels do not, and the report says so") {
  Bench bench(plain + levels(0.5, 0.04, 0.01, 0.001) +
                  "[stages.s]\nuse = [\"t.sum\", \"t.product\"]\n" +
                  unknown("s", "x", wall + "friction", "prior = {mean = 0.1, sd = 0.05}\n") +
                  unknown("s", "y", wall + "rolling_friction"),
              closed_forms);
  const auto c = bench.solved();
  CHECK(c.found.values.at(0) == Approx(0.1).margin(0.005));
  CHECK(c.stages[0].best().weight > 0.99);
}

TEST_CASE("Levels that do not cross give the closest point, its misses and what reconciles them") {
  Bench bench(plain + levels(0.5, 0.07, 0.001, 0.001) +
                  "[stages.s]\nuse = [\"t.sum\", \"t.product\"]\n" + two_unknowns("s"),
              closed_forms);
  const auto c = bench.solved();
  CHECK(c.stages.at(0).is_closest);
  CHECK(c.found.values.at(0) == Approx(0.2509).margin(0.005));
  CHECK(c.found.values.at(1) == Approx(0.2509).margin(0.005));
  std::string all;
  for (const std::string& warning : c.warnings) all += warning + "\n";
  CHECK_THAT(all, Contains("do not cross") && Contains("t.product is missed by -0.00") &&
                      Contains("would reconcile"));
}

TEST_CASE("A prior does not move the closest point, which is of the levels alone") {
  Bench bench(plain + levels(0.5, 0.07, 0.001, 0.001) +
                  "[stages.s]\nuse = [\"t.sum\", \"t.product\"]\n" +
                  unknown("s", "x", wall + "friction", "prior = {mean = 0.4, sd = 0.002}\n") +
                  unknown("s", "y", wall + "rolling_friction"),
              closed_forms);
  const auto c = bench.solved();
  CHECK(c.stages.at(0).is_closest);
  CHECK(c.stages[0].best().mode.best[0] > 0.3);
  CHECK(c.found.values.at(0) == Approx(0.2509).margin(0.005));
}

TEST_CASE("A level beyond all runs is said to be out of reach") {
  Bench bench(plain + levels(2.5, 0.04, 0.01, 0.01) +
                  "[stages.s]\nuse = [\"t.sum\", \"t.product\"]\n" + two_unknowns("s"),
              closed_forms);
  std::string all;
  for (const std::string& warning : bench.solved().warnings) all += warning + "\n";
  CHECK_THAT(all, Contains("target out of reach: t.sum = 2.5") && Contains("widen the box"));
}

TEST_CASE("A run that fails is lost to its own response alone") {
  // The sum and the product come from two tests; that of the sum jams at high friction.
  const std::string lab = plain + test_table("a", "settings = {title = \"a\"}\n") +
                          response("a", "sum", 0.5, 0.01) + test_table("b") +
                          response("b", "product", 0.04, 0.001) +
                          "[stages.s]\nuse = [\"a\", \"b\"]\n" + two_unknowns("s");
  std::size_t failed = 0;
  Bench bench(lab, [&](const Case& c) {
    const bool is_jammed = c.title == "a" && on_wall(c, "SrFeO3").friction > 0.6;
    failed += is_jammed;
    return is_jammed ? Said{{}, "the orifice is jammed"} : closed_forms(c);
  });
  const auto c = bench.solved();
  REQUIRE(failed > 0);
  CHECK(c.stages.at(0).levels.at(0).fit.lost == failed);
  CHECK(c.stages.at(0).levels.at(1).fit.lost == 0);
  REQUIRE(c.stages[0].modes.size() == 2);
  for (const auto& mode : c.stages[0].modes)
    CHECK(std::max(mode.at[0], mode.at[1]) == Approx(0.4).margin(0.005));
  CHECK_THAT(io::read_text(bench.root / "out" / "runs.csv"), Contains(",failed,sum,,the orifice"));
}

TEST_CASE("A run that exceeds a limit of its test is lost to its responses") {
  const std::string lab = plain + test_table("t", "at_most = {left = 3}\n") +
                          response("t", "first", 0.3, 0.01) + "[stages.s]\nuse = [\"t\"]\n" +
                          unknown("s", "x", wall + "friction");
  const auto left = [](const Case& c) {
    const double friction = on_wall(c, "SrFeO3").friction;
    return Said{
        {{"first", friction < 0.5 ? friction : 0.0}, {"left", friction < 0.5 ? 3.0 : 200.0}}, ""};
  };
  Bench bench(lab, left);
  const auto c = bench.solved();
  CHECK(c.found.values.at(0) == Approx(0.3).margin(0.01));
  CHECK(c.stages.at(0).levels.at(0).fit.lost > 2);
  CHECK_THAT(io::read_text(bench.root / "out" / "runs.csv"),
             Contains(",failed,first,,left is 200 where at most 3 is wanted"));
}

TEST_CASE("A calibration that was killed goes on to the same bytes, and makes no run twice") {
  const std::string lab = "predictions = 0\n[sampling]\npoints = 7\nmost = 20\nreplicated = 0\n" +
                          levels(0.5, 0.04, 0.01, 0.001) +
                          "[stages.s]\nuse = [\"t.sum\", \"t.product\"]\n" + two_unknowns("s");
  const auto outputs = [](const Bench& bench, const calibrate::Calibration& c) {
    calibrate::write_parameters(bench.lab, c, "v", bench.root / "contacts.toml");
    calibrate::write_json(bench.lab, c, "v", bench.root / "calibration.json");
    return io::read_text(bench.root / "contacts.toml") +
           io::read_text(bench.root / "calibration.json") +
           io::read_text(bench.root / "out" / "runs.csv");
  };
  std::string whole;
  std::size_t runs = 0;
  {
    Bench bench(lab, closed_forms);
    whole = outputs(bench, bench.solved());
    runs = bench.carried_out;
  }
  {
    Bench bench(lab, closed_forms);
    CHECK_THROWS_AS(bench.solved({}, 4), Stopped);  // in the first design
    CHECK_THROWS_AS(bench.solved({}, 5), Stopped);  // among the points added
    CHECK(outputs(bench, bench.solved()) == whole);
    CHECK(bench.carried_out == runs);
  }
  // From the table alone, in another folder: no run at all.
  std::string table = whole.substr(whole.rfind("run,case,status"));
  Bench bench(lab, closed_forms);
  std::ofstream(bench.root / "made-before.csv") << table;
  bench.rewrite("known = \"made-before.csv\"\n" + lab);
  CHECK(outputs(bench, bench.solved()) == whole);
  CHECK(bench.carried_out == 0);
}

TEST_CASE(
    "Replicates of a noisy test make the surrogate's noise, and the truth is within its error") {
  const std::string lab = "predictions = 0\n" + levels(0.5, 0.04, 0.01, 0.002) +
                          "[stages.s]\nuse = [\"t.sum\", \"t.product\"]\ndecide = [\"t.first\"]\n" +
                          two_unknowns("s");
  std::map<std::uint64_t, std::set<double>> points_of_seed;
  Bench bench(lab, [&](const Case& c) {
    points_of_seed[c.seed].insert(on_wall(c, "SrFeO3").friction);
    Said said = closed_forms(c);
    Random random(c.seed, Purpose::test,
                  static_cast<std::uint64_t>(1e6 * on_wall(c, "SrFeO3").friction));
    for (auto& [name, value] : said.figures)  // even between +-0.01 sqrt(3): deviation 0.01
      value +=
          (name == "product" ? 0.2 : 1.0) * 0.01 * std::sqrt(3.0) * (2.0 * random.uniform() - 1.0);
    return said;
  });
  const auto c = bench.solved();
  REQUIRE_FALSE(c.is_refused);
  // Eight degrees of freedom: within a factor of two.
  CHECK(c.stages[0].levels[0].fit.surrogate.basis().noise == Approx(0.01).epsilon(0.5));
  const double x = c.found.values.at(0), y = c.found.values.at(1);
  CHECK(std::abs(x - 0.4) < 2.5 * std::sqrt(c.found.covariance[0][0]));
  CHECK(std::abs(y - 0.1) < 2.5 * std::sqrt(c.found.covariance[1][1]));
  CHECK(std::sqrt(c.found.covariance[0][0]) < 0.04);
  // What a seed does at one point it does at others, and would not average out.
  for (const auto& [seed, points] : points_of_seed) CHECK(points.size() == 1);
}

TEST_CASE("A small sample is corrected by pairs of full ones, with their scatter as an error") {
  // Full samples give 0.05 more of the sum; small ones say so by their title.
  const std::string lab = "predictions = 0\n[sampling]\npoints = 14\nmost = 20\nreplicated = 0\n" +
                          test_table("t", "small = {title = \"small\"}\npairs = 5\n") +
                          response("t", "sum", 0.5, 0.01) + response("t", "product", 0.04, 0.001) +
                          response("t", "first", 0.4, 0.03) +
                          "[stages.s]\nuse = [\"t.sum\", \"t.product\"]\ndecide = [\"t.first\"]\n" +
                          two_unknowns("s");
  double scatter = 0.0;
  Bench bench(lab, [&](const Case& c) {
    Said said = closed_forms(c);
    if (c.title == "small")
      return Said{
          {{"sum", said.figures[0].second - 0.05 + scatter * (on_wall(c, "SrFeO3").friction - 0.4)},
           said.figures[1],
           said.figures[2]},
          ""};
    return said;
  });
  const auto c = bench.solved();
  REQUIRE_FALSE(c.is_refused);
  CHECK(c.stages[0].levels[0].small.value == Approx(0.05).epsilon(1e-3));
  CHECK(c.stages[0].levels[0].small.error < 1e-4);
  CHECK(c.found.values.at(0) == Approx(0.4).margin(0.005));
  CHECK(bench.lab.tests[0].pairs == 5);
  scatter = 0.1;  // between -0.04 and 0.04: the difference goes with the point
  std::filesystem::remove_all(bench.root / "out");
  const auto wide = bench.solved();
  CHECK(wide.stages[0].levels[0].small.error > 0.01);
  CHECK(std::sqrt(wide.found.covariance[0][0]) > 1.2 * std::sqrt(c.found.covariance[0][0]));

  std::filesystem::remove_all(bench.root / "out");
  bench.carried_out = 0;
  const auto full = bench.solved({true, std::nullopt});
  CHECK(full.stages[0].levels[0].small.value == 0.0);
  CHECK(full.found.values.at(0) == Approx(0.4).margin(0.005));
}

TEST_CASE("Errors of an earlier stage widen those of the next, by the slope of its tests") {
  // First x = 0.4 +- 0.02 of itself; then y of x + y = 0.5 +- 0.001: +-0.02 again.
  Bench bench(plain + levels(0.5, 0.04, 0.001, 0.001) +
                  "[tests.u]\ncase = \"" PMR_SOURCE_DIR "/cases/two-body-bounce.toml\"\n" +
                  response("u", "first", 0.4, 0.02) + "[stages.one]\nuse = [\"u.first\"]\n" +
                  unknown("one", "x", wall + "friction") + "[stages.two]\nuse = [\"t.sum\"]\n" +
                  unknown("two", "y", wall + "rolling_friction"),
              closed_forms);
  const auto c = bench.solved();
  REQUIRE(c.stages.size() == 2);
  CHECK(c.stages[1].levels[0].others == Approx(0.02).epsilon(0.03));
  CHECK(std::sqrt(c.found.covariance[1][1]) == Approx(0.02).epsilon(0.05));
  CHECK(c.found.values.at(1) == Approx(0.1).margin(0.001));
  CHECK(bench.solved({false, "one"}).stages.size() == 1);
  CHECK_THROWS_WITH(bench.solved({false, "on"}), Contains("did you mean 'one'"));
}

TEST_CASE(
    "What correlated parameters leave of a later level and of a formula takes both together") {
  // x + y and x y at (0.4, 0.1) have the inverse Jacobian ((0.4, -1), (-0.1, 1)) / 0.3. So with the
  // levels' deviations 0.01 and 0.001: var x 1.889e-4, var y 2.22e-5, cov -5.56e-5, and x + 2 y has
  // 5.56e-5: deviation 0.00745, where independent errors would give 0.0167.
  const double both = std::sqrt((0.04 * 1e-4 + 1e-6) / 0.09);
  Bench bench(
      plain + "[derived.d]\nformula = \"x + 2 * y\"\n" + levels(0.5, 0.04, 0.01, 0.001) +
          test_table("u") + response("u", "third", 1.1, 0.001) +
          "[stages.one]\nuse = [\"t.sum\", \"t.product\"]\ndecide = [\"t.first\"]\n" +
          two_unknowns("one") + "[stages.two]\nuse = [\"u.third\"]\n" +
          unknown("two", "z", wall + "restitution"),
      [](const Case& c) {
        const PairContact p = on_wall(c, "SrFeO3");
        Said said = closed_forms(c);
        said.figures.push_back({"third", p.friction + 2.0 * p.rolling_friction + p.restitution});
        return said;
      });
  const auto c = bench.solved();
  REQUIRE(c.stages.size() == 2);
  CHECK(c.stages[1].levels[0].others == Approx(both).epsilon(0.1));
  CHECK(c.found.values.at(2) == Approx(0.5).margin(0.005));
  CHECK(c.derived.at(0).value == Approx(0.6).margin(0.005));
  CHECK(c.derived.at(0).deviation == Approx(both).epsilon(0.1));
}

TEST_CASE("Stages that mind each other's parameters settle where all tests are met at once") {
  // x + y + 0.5 (z - 0.5), x y and z + 0.2 (x - y) at (0.4, 0.1, 0.7); z is guessed as 0.5 first,
  // which alone would put x + y at 0.6.
  const std::string lab =
      "predictions = 2\n[sampling]\npoints = 14\nmost = 20\nreplicated = 0\n" +
      levels(0.6, 0.04, 0.01, 0.001) + test_table("u") + response("u", "third", 0.76, 0.02) +
      "[stages.one]\nuse = [\"t.sum\", \"t.product\"]\ndecide = [\"t.first\"]\n" +
      two_unknowns("one") + "[stages.two]\nuse = [\"u.third\"]\n" +
      unknown("two", "z", wall + "restitution", "guess = 0.5\n");
  const auto coupled = [](const Case& c) {
    const PairContact p = on_wall(c, "SrFeO3");
    Said said = closed_forms(c);
    said.figures[0].second += 0.5 * (p.restitution - 0.5);
    said.figures.push_back({"third", p.restitution + 0.2 * (p.friction - p.rolling_friction)});
    return said;
  };
  Bench bench(lab, coupled);
  const auto c = bench.solved();
  CHECK(c.found.values.at(0) == Approx(0.4).margin(0.01));
  CHECK(c.found.values.at(1) == Approx(0.1).margin(0.005));
  CHECK(c.found.values.at(2) == Approx(0.7).margin(0.01));
  CHECK(c.stages[0].levels[0].guesses.value == Approx(0.1).margin(0.01));
  // The deviation 0.02 of z, half of it in the sum.
  CHECK(c.stages[0].levels[0].others == Approx(0.01).epsilon(0.3));
  CHECK(c.warnings.empty());

  Bench once("rounds = 0\n" + lab, coupled);
  const auto guessed = once.solved();
  CHECK(guessed.found.values.at(0) > 0.5);
  REQUIRE_FALSE(guessed.warnings.empty());
  CHECK_THAT(guessed.warnings.back(), Contains("set their guesses to what was found"));
}

TEST_CASE(
    "A correction that holds at one place alone is taken back by half, and widens the result") {
  // x, but with z found instead of guessed 0.1 more beyond x = 0.35: the level 0.4 is crossed
  // there, and corrections by the whole difference swing between 0.4 and 0.3.
  const std::string lab =
      "predictions = 2\n[sampling]\npoints = 9\nmost = 9\nreplicated = 0\n" + test_table("t") +
      response("t", "there", 0.4, 0.002) + test_table("u") + response("u", "third", 0.7, 0.02) +
      "[stages.one]\nuse = [\"t.there\"]\n" + unknown("one", "x", wall + "friction") +
      "[stages.two]\nuse = [\"u.third\"]\n" +
      unknown("two", "z", wall + "restitution", "guess = 0.5\n");
  Bench bench(lab, [](const Case& c) {
    const PairContact p = on_wall(c, "SrFeO3");
    const bool is_beyond = p.restitution > 0.6 && p.friction > 0.351;
    return Said{{{"there", p.friction + (is_beyond ? 0.1 : 0.0)}, {"third", p.restitution}}, ""};
  });
  const auto c = bench.solved();
  const double x = c.found.values.at(0), deviation = std::sqrt(c.found.covariance[0][0]);
  CHECK(x > 0.32);
  CHECK(x < 0.38);
  CHECK(deviation > 0.02);
  CHECK(std::abs(x - 0.351) < 2.0 * deviation);
}

TEST_CASE("A noise that no surrogate can foretell is refused, and nothing follows it") {
  Bench bench(plain + levels(0.5, 0.04, 0.001, 0.001) +
                  "[stages.s]\nuse = [\"t.sum\", \"t.product\"]\n" + two_unknowns("s") +
                  "[stages.after]\nuse = [\"t.first\"]\n" +
                  "[stages.after.unknowns.z]\nkey = 'contacts.\"" + wall +
                  "restitution'\nfrom = 0.1\nto = 0.9\n",
              [](const Case& c) {
                Said said = closed_forms(c);
                Random random(1, Purpose::test,
                              static_cast<std::uint64_t>(1e6 * on_wall(c, "SrFeO3").friction));
                said.figures[0].second = random.uniform();
                return said;
              });
  const auto c = bench.solved();
  CHECK(c.is_refused);
  CHECK(c.stages.size() == 1);
  CHECK(c.found.parameters.empty());
  CHECK_THAT(c.warnings.at(0), Contains("refused: the surrogate of t.sum does not hold"));
}

TEST_CASE("The composite restitution follows from those of its materials, with their errors") {
  // Equation 10 of Richter et al. with radii 1.495 and 0.735 mm: e^2 = (0.75^2 0.735^(1/3) + 0.24^2
  // 1.495^(1/3)) / (0.735^(1/3) + 1.495^(1/3)) = 0.2803. Straight instead of crosswise: 0.5829.
  const std::string formula =
      "[derived.e]\nformula = \"sqrt((e_A^2 * R_S^(1/3) + e_S^2 * R_A^(1/3)) / (R_S^(1/3) + "
      "R_A^(1/3)))\"\n";
  Bench bench("predictions = 0\n[sampling]\npoints = 14\nmost = 20\nreplicated = 0\n" + formula +
                  "[constants]\nR_A = 1.495\nR_S = 0.735\n" + test_table("t") +
                  response("t", "bead", 0.75, 0.02) + response("t", "granule", 0.24, 0.01) +
                  "[stages.s]\nuse = [\"t.bead\", \"t.granule\"]\n" +
                  "[stages.s.unknowns.e_A]\nkey = 'contacts.\"Al2O3|coated-wall\".restitution'\n"
                  "from = 0.1\nto = 0.9\n"
                  "[stages.s.unknowns.e_S]\nkey = 'contacts.\"SrFeO3|coated-wall\".restitution'\n"
                  "from = 0.1\nto = 0.9\n",
              [](const Case& c) {
                return Said{{{"bead", on_wall(c, "Al2O3").restitution},
                             {"granule", on_wall(c, "SrFeO3").restitution}},
                            ""};
              });
  const auto c = bench.solved();
  CHECK(c.derived.at(0).value == Approx(0.5294).margin(5e-5));
  // de = 0.625 de_A + 0.258 de_S
  CHECK(c.derived.at(0).deviation == Approx(std::hypot(0.625 * 0.02, 0.258 * 0.01)).epsilon(0.05));
}

TEST_CASE("What is derived is given only where all that it rests on was found") {
  const std::string formulas =
      "[derived.both]\nformula = \"x + z\"\nkey = 'contacts.\"Al2O3|coated-wall\".friction'\n"
      "[derived.first]\nformula = \"2 * x\"\n"
      "key = 'contacts.\"Al2O3|coated-wall\".restitution'\n";
  Bench bench(plain + formulas + levels(0.5, 0.04, 0.01, 0.001) +
                  "[stages.one]\nuse = [\"t.first\"]\n" + unknown("one", "x", wall + "friction") +
                  "[stages.two]\nuse = [\"t.sum\"]\n" +
                  unknown("two", "z", wall + "rolling_friction"),
              closed_forms);
  const auto c = bench.solved({false, "one"});
  CHECK(std::isnan(c.derived.at(0).value));
  CHECK(c.derived.at(1).value == Approx(0.8).margin(0.01));
  calibrate::write_parameters(bench.lab, c, "v", bench.root / "contacts.toml");
  const std::string text = io::read_text(bench.root / "contacts.toml");
  CHECK_THAT(text, Contains("2 * x") && !Contains("x + z"));
}

TEST_CASE("A lab that is made by the program finds again what it was made with") {
  std::string lab = "predictions = 2\n[sampling]\npoints = 14\nmost = 20\nreplicated = 0\n" +
                    levels(0.9, 0.2, 0.01, 0.001) +
                    "[stages.s]\nuse = [\"t.sum\", \"t.product\"]\ndecide = [\"t.first\"]\n" +
                    two_unknowns("s") + "[stages.last]\nuse = [\"t.last\"]\n" +
                    unknown("last", "a", wall + "restitution") + response("t", "last", 0.8, 0.01);
  for (std::size_t at = 0; (at = lab.find("floor = 0\n", at)) != std::string::npos; at += 5)
    lab.replace(at, 9, "floor = 0.001");
  lab.insert(lab.find("case = "), "synthetic = 7\n");
  std::function<bool(const Case&)> is_slow = [](const Case&) { return false; };
  Bench bench(lab, [&](const Case& c) {
    Said said = closed_forms(c);
    if (!is_slow(c)) said.figures.push_back({"last", on_wall(c, "SrFeO3").restitution});
    return said;
  });
  std::ofstream(bench.root / "truth.toml") << "[\"SrFeO3|coated-wall\"]\nfriction = 0.35\n"
                                              "rolling_friction = {value = 0.15}\n"
                                              "restitution = 0.6\n";
  std::string made;
  {
    const study::Folder folder(bench.root / "made", "lab.toml");
    const auto lock = folder.prepare(bench.lab.text);
    calibrate::Runs runs(bench.lab, folder, "pmr", 1, [&](const std::vector<study::Job>& jobs) {
      return bench.carry_out_all(jobs);
    });
    made = calibrate::synthetic_lab(bench.lab, bench.root / "truth.toml", false, runs);
    std::ofstream(bench.root / "wrong.toml") << "x = 0.3\n";
    CHECK_THROWS_WITH(calibrate::synthetic_lab(bench.lab, bench.root / "wrong.toml", false, runs),
                      Contains("rolling_friction"));
    // One seed in seven ends beyond a limit: no mean is told of the others.
    auto& last = bench.lab.tests.at(0).targets.back();
    last.beyond = 0.9;
    is_slow = [](const Case& one) { return one.seed == 103; };
    std::filesystem::remove_all(bench.root / "made" / "runs");
    calibrate::Runs anew(bench.lab, folder, "pmr", 1, [&](const std::vector<study::Job>& jobs) {
      return bench.carry_out_all(jobs);
    });
    CHECK_THROWS_WITH(calibrate::synthetic_lab(bench.lab, bench.root / "truth.toml", false, anew),
                      Contains("ended beyond the limit of t.last"));
    last.beyond.reset();
    is_slow = [](const Case&) { return false; };
  }
  CHECK_THAT(made, Contains("made by pmr at the parameters of truth.toml") && Contains("runs = 7"));
  bench.rewrite_whole(made, "synthetic.toml");
  const auto c = bench.solved();
  CHECK(bench.lab.stages.at(0).name == "s");  // stages are carried out in the lab's order
  CHECK(c.found.values.at(0) == Approx(0.35).margin(0.01));
  CHECK(c.found.values.at(1) == Approx(0.15).margin(0.01));
  CHECK(c.found.values.at(2) == Approx(0.6).margin(0.01));
  REQUIRE(c.predicted.size() == 4);
  CHECK(c.predicted[0].values.size() == 2);  // the sum
  CHECK(c.predicted[0].values[0] == Approx(0.5).margin(0.01));
}
