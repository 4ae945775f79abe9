// What two measured levels say of two variables, against closed forms. The responses of most tests
// are y1 = x + y and y2 = x y: measured at 0.5 and 0.04 they cross at (0.1, 0.4) and (0.4, 0.1).
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"
#include "statistics/crossing.hpp"
#include "statistics/surrogate.hpp"

using namespace pmr;
using namespace pmr::statistics;

namespace {

const std::vector<Span> box = {{0.0, 0.8}, {0.0, 0.8}};
constexpr std::size_t steps = 201;

double sum_of(std::span<const double> p) { return p[0] + p[1]; }
double product_of(std::span<const double> p) { return p[0] * p[1]; }
double first_of(std::span<const double> p) { return p[0]; }
using Function = double (*)(std::span<const double>);

Response exact(Function f) {
  return [f](std::span<const double> p) { return Prediction{f(p), 0.0}; };
}

// Of `count` runs without noise, in a Latin hypercube.
Response of_runs(Function f, std::size_t count) {
  const Points runs = sample(Sequence::latin_hypercube, box, count, 1);
  std::vector<double> values;
  for (const auto& run : runs) values.push_back(f(run));
  return [surrogate = Surrogate(box, runs, values)](std::span<const double> p) {
    return surrogate.predict(p);
  };
}

Problem two_levels(const std::array<Response, 2>& responses, Measured first, Measured second) {
  return {{responses[0], responses[1]}, {first, second}, Priors(2)};
}

bool is_at(const std::vector<double>& p, double x, double y, double within) {
  return std::abs(p[0] - x) < within && std::abs(p[1] - y) < within;
}

double normal(Random& random) {  // Box and Muller
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  return radius * std::cos(2.0 * pi * random.uniform());
}

}  // namespace

TEST_CASE("Two levels over twenty runs cross at both roots, each a mode, and a third picks one") {
  const auto problem =
      two_levels({of_runs(sum_of, 20), of_runs(product_of, 20)}, {0.5, 0.01}, {0.04, 0.001});
  const Points roots = crossings(problem, Grid(box, steps));
  REQUIRE(roots.size() == 2);
  CHECK(is_at(roots[0], 0.1, 0.4, 0.005));
  CHECK(is_at(roots[1], 0.4, 0.1, 0.005));

  const auto modes = find_modes(problem, box, steps);
  REQUIRE(modes.size() == 2);
  CHECK(modes[0].mass + modes[1].mass == Approx(1.0));
  CHECK(modes[0].mass == Approx(0.5).margin(0.02));  // the functions are symmetric

  auto three = problem;
  three.responses.push_back(exact(first_of));
  three.measured.push_back({0.4, 0.03});
  const auto decided = find_modes(three, box, steps);
  REQUIRE(decided.size() == 1);
  CHECK(is_at(decided[0].best, 0.4, 0.1, 0.02));
}

TEST_CASE("Levels that do not cross leave the point that comes closest") {
  // Least (2 x - 0.5)^2 + (x^2 - 0.07)^2 on the diagonal: x^3 + 1.93 x - 0.5 = 0, x = 0.250885.
  const auto problem =
      two_levels({of_runs(sum_of, 20), of_runs(product_of, 20)}, {0.5, 0.01}, {0.07, 0.01});
  const Grid grid(box, steps);
  CHECK(crossings(problem, grid).empty());
  CHECK(is_at(closest(problem, grid), 0.2509, 0.2509, 0.005));
  const auto sharp = two_levels({exact(sum_of), exact(product_of)}, {0.5, 0.01}, {0.07, 0.01});
  CHECK(is_at(closest(sharp, grid), 0.250885, 0.250885, 5e-6));
}

TEST_CASE("Deviations and correlation of a mode are those of the linearised levels") {
  // J = (1 1; y x) at (0.4, 0.1): deviations 0.01374 and 0.00471, covariance -(0.4 0.1 1e-4 + 1e-6)
  // / 0.3^2. The thin way across the mode, 0.0023, is less than a step of the grid.
  const auto problem =
      two_levels({of_runs(sum_of, 20), of_runs(product_of, 20)}, {0.5, 0.01}, {0.04, 0.001});
  for (const Mode& mode : find_modes(problem, box, steps)) {
    const std::size_t high = mode.mean[0] > mode.mean[1] ? 0 : 1;
    CHECK(mode.deviation(high) == Approx(0.01374).epsilon(0.1));
    CHECK(mode.deviation(1 - high) == Approx(0.00471).epsilon(0.1));
    CHECK(mode.covariance[0][1] == Approx(-5.0e-6 / 0.09).epsilon(0.15));
  }
}

TEST_CASE("A mode far thinner than the grid keeps its deviation and its mass") {
  // Two peaks of an even and an uneven width, each a hundredth of a step or so of the grid.
  const auto problem = two_levels({exact(sum_of), exact(product_of)}, {0.5, 1e-4}, {0.04, 1e-5});
  const auto modes = find_modes(problem, box, 101);
  REQUIRE(modes.size() == 2);
  for (const Mode& mode : modes) {
    CHECK(mode.deviation(mode.mean[0] > mode.mean[1] ? 0 : 1) == Approx(1.374e-4).epsilon(0.05));
    CHECK(mode.mass == Approx(0.5).margin(0.02));
  }
}

TEST_CASE("The 68 % region of two hundred noisy labs holds the truth in 61 to 75 % of them") {
  const std::array<double, 2> truth{0.42, 0.23};
  const std::array<double, 2> noise{0.02, 0.006};  // of one experiment
  // Without the other root, (0.23, 0.42); the truth is the point (80, 100) of the grid.
  const Grid grid({{0.3, 0.6}, {0.1, 0.36}}, steps);
  const std::size_t at = 80 * steps + 100;
  const std::array<Function, 2> functions{sum_of, product_of};
  std::vector<Field> fields;
  for (const Function f : functions) fields.push_back(field_of(grid, of_runs(f, 20)));
  Random random(5, Purpose::test, 1);
  int held = 0;
  for (int lab = 0; lab < 200; ++lab) {
    std::vector<Measured> measured;
    for (std::size_t r = 0; r < 2; ++r) {
      double mean = 0.0;
      for (int k = 0; k < 5; ++k) mean += (functions[r](truth) + noise[r] * normal(random)) / 5.0;
      measured.push_back({mean, noise[r] / std::sqrt(5.0)});
    }
    const auto posterior = normalised(grid, log_density(grid, fields, measured, Priors(2)));
    held += posterior.log_density[at] >= posterior.region_level(0.68);
  }
  CHECK(held >= 122);
  CHECK(held <= 150);
}

TEST_CASE("A prior moves a mode by its weight, and alone is what comes out") {
  // Level 0.5 +- 0.01 of x, prior 0.52 +- 0.02: precisions 10000 and 2500.
  const std::vector<Span> line = {{0.0, 1.0}};
  Problem problem{{exact(first_of)}, {{0.5, 0.01}}, {Normal{0.52, 0.02}}};
  const auto modes = find_modes(problem, line, 2001);
  REQUIRE(modes.size() == 1);
  CHECK(modes[0].mean[0] == Approx(0.504).epsilon(1e-5));
  CHECK(modes[0].deviation(0) == Approx(0.01 * std::sqrt(0.8)).epsilon(1e-3));
}

TEST_CASE("The deviation of a response widens the density and draws the next run") {
  // s^2 = 0.03^2 + 0.04^2 left of the middle, 0.03^2 right of it.
  const std::vector<Span> line = {{0.0, 1.0}};
  const Response unsure = [](std::span<const double> p) {
    return Prediction{std::abs(p[0] - 0.5), p[0] < 0.5 ? 0.04 : 0.0};
  };
  const Problem problem{{unsure}, {{0.25, 0.03}}, Priors(1)};
  const auto modes = find_modes(problem, line, 1001);
  REQUIRE(modes.size() == 2);
  for (const Mode& mode : modes)
    CHECK(mode.deviation(0) == Approx(mode.best[0] < 0.5 ? 0.05 : 0.03).epsilon(0.02));
  const Grid grid(line, 1001);
  const std::vector<Field> fields{field_of(grid, unsure)};
  const auto posterior =
      normalised(grid, log_density(grid, fields, problem.measured, problem.priors));
  CHECK(grid.point(most_telling(posterior, fields, problem.measured))[0] ==
        Approx(0.25).margin(0.002));
  CHECK(posterior.mass_on_edge(grid) < 1e-4);
}

TEST_CASE("Two peaks are two modes once the density between them falls below exp(-2)") {
  const std::vector<Span> line = {{0.0, 1.0}};
  const Response distance = [](std::span<const double> p) {
    return Prediction{std::abs(p[0] - 0.5), 0.0};
  };
  // In the middle (level / s)^2 / 2 = 1.62 or 2.42 below the peaks.
  const auto count = [&](double level) {
    return find_modes({{distance}, {{level, 0.1}}, Priors(1)}, line, 1001).size();
  };
  CHECK(count(0.18) == 1);
  CHECK(count(0.22) == 2);
}

TEST_CASE("Regions of a normal density end where theirs do") {
  // One variable: 68 % within 0.99446 deviations, z^2 / 2 = 0.4945; two: -ln(1 - 0.68) = 1.1394.
  const auto depth = [](const Problem& problem, const Grid& grid) {
    std::vector<Field> fields;
    for (const Response& response : problem.responses) fields.push_back(field_of(grid, response));
    const auto posterior =
        normalised(grid, log_density(grid, fields, problem.measured, problem.priors));
    return *std::max_element(posterior.log_density.begin(), posterior.log_density.end()) -
           posterior.region_level(0.68);
  };
  const Response second = exact([](std::span<const double> p) { return p[1]; });
  CHECK(depth({{exact(first_of)}, {{0.5, 0.05}}, Priors(1)}, Grid({{0.0, 1.0}}, 2001)) ==
        Approx(0.4945).epsilon(0.02));
  CHECK(depth({{exact(first_of), second}, {{0.5, 0.05}, {0.5, 0.08}}, Priors(2)},
              Grid({{0.0, 1.0}, {0.0, 1.0}}, steps)) == Approx(1.1394).epsilon(0.02));
}

TEST_CASE("A mode at the edge of the box has its mass on the edge") {
  const std::vector<Span> line = {{0.0, 1.0}};
  const Grid grid(line, 101);
  const std::vector<Field> fields{field_of(grid, exact(first_of))};
  const std::vector<Measured> measured{{1.2, 0.05}};
  const auto posterior = normalised(grid, log_density(grid, fields, measured, Priors(1)));
  CHECK(posterior.mass_on_edge(grid) > 0.3);
}

TEST_CASE("A level line of a circle has its length, and none of a plain field") {
  const std::vector<Span> square = {{-1.0, 1.0}, {-1.0, 1.0}};
  const Grid grid(square, 101);
  const Field field = field_of(grid, [](std::span<const double> p) {
    return Prediction{p[0] * p[0] + p[1] * p[1], 0.0};
  });
  double length = 0.0;
  for (const Segment& s : level_line(grid, field.mean, 0.64)) {
    length += std::hypot(s.to[0] - s.from[0], s.to[1] - s.from[1]);
    CHECK(std::hypot(s.from[0], s.from[1]) == Approx(0.8).epsilon(1e-3));
  }
  CHECK(length == Approx(2.0 * pi * 0.8).epsilon(1e-3));
  CHECK(level_line(grid, field.mean, 3.0).empty());
}

TEST_CASE(
    "A level line in a saddle's cell keeps apart what the mean of its corners does not join") {
  // Corners 1 and 0 crosswise, mean 0.5: above it the ones are islands, below it the zeros.
  const Grid cell({{0.0, 1.0}, {0.0, 1.0}}, 2);
  const std::vector<double> values{1.0, 0.0, 0.0, 1.0};
  for (const double level : {0.6, 0.4}) {
    const auto line = level_line(cell, values, level);
    REQUIRE(line.size() == 2);
    for (const Segment& s : line) {
      // Each segment cuts off one corner: an island at (0, 0) is left of x + y = 1.
      const double from = s.from[0] + s.from[1], to = s.to[0] + s.to[1];
      const bool cuts_off_a_one = (from < 1.0) == (to < 1.0);
      CHECK(cuts_off_a_one == (level > 0.5));
    }
  }
}

TEST_CASE("Levels cross in as many variables as there are, on logarithmic axes too") {
  // x = 0.01, x y = 1e-3, x y z = 5e-4: (0.01, 0.1, 0.5).
  const std::vector<Span> spans = {{1e-3, 1.0, true}, {1e-2, 1.0, true}, {0.0, 1.0}};
  const Problem problem{{exact(first_of), exact(product_of),
                         exact([](std::span<const double> p) { return p[0] * p[1] * p[2]; })},
                        {{0.01, 1e-4}, {1e-3, 1e-5}, {5e-4, 1e-5}},
                        Priors(3)};
  const Points roots = crossings(problem, Grid(spans, 21));
  REQUIRE(roots.size() == 1);
  CHECK(roots[0][0] == Approx(0.01).epsilon(1e-6));
  CHECK(roots[0][1] == Approx(0.1).epsilon(1e-6));
  CHECK(roots[0][2] == Approx(0.5).epsilon(1e-6));
}
