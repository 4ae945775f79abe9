// Contacts, gaps and wall columns: symmetry, limits, conservation. Values are checked in
// src/verify.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "physics/conduction.hpp"
#include "physics/gap.hpp"
#include "physics/wall_column.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/random.hpp"
#include "verify/reference_materials.hpp"

using namespace pmr;
using namespace pmr::physics;

namespace {
constexpr double ideal = std::numeric_limits<double>::infinity();  // [W/m/K]

// The lens between solids that conduct perfectly, int 2 pi r dr k_f/h, by Simpson's rule over ln r,
// 4000 panels: error below 1e-10.
double ideal_lens(const GapPair& pair, double jump) {
  const auto [R1, R2] = std::minmax(pair.radius_1, pair.radius_2);
  const double large = R2, small = R1, d = pair.distance;
  const bool wall = std::isinf(large);
  const double D1 = wall ? d : (small * small - large * large + d * d) / (2.0 * d);
  const double r_ij = 0.560 * small * std::pow(pair.solid_fraction, -1.0 / 3.0);
  const double r_sf = small * r_ij / std::sqrt(r_ij * r_ij + D1 * D1);
  const auto integrand = [&](double log_r) {
    const double r = std::exp(log_r);
    const double other = wall ? 0.0 : std::sqrt(large * large - r * r);
    return 2.0 * pi * r * r / (d - std::sqrt(small * small - r * r) - other + jump);
  };
  constexpr int panels = 4000;
  const double low = std::log(std::max(pair.contact_radius, 1e-7 * r_sf)), high = std::log(r_sf);
  const double h = (high - low) / panels;
  double total = 0.0;
  for (int i = 0; i < panels; ++i)
    total += integrand(low + i * h) + 4.0 * integrand(low + (i + 0.5) * h) +
             integrand(low + (i + 1) * h);
  return total * h / 6.0;
}

// Coat, then board, with an outside film.
Materials lining_materials() {
  return {{verify::constant_solid(2000.0, 1000.0, 1.5), verify::reference_fibre_board()}, {}};
}
const Lining lining{{{0, 1e-3}, {1, 0.12}}, 650.0, 10.0, 300.0};

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}
}  // namespace

TEST_CASE("gas in the pores carries its share of a conductivity, and no more") {
  const Conductivity law = TabulatedConductivity{constant(0.18), 0.4, 2000.0};
  CHECK(conductivity(law, 800.0, 1e12) == Approx(0.18).epsilon(1e-8));
  CHECK(conductivity(law, 800.0, 0.0) == Approx(0.6 * 0.18).epsilon(1e-14));
  CHECK(conductivity(law, 800.0, 2000.0) == Approx(0.8 * 0.18).epsilon(1e-14));
}

TEST_CASE("contact conductance is 2 k a for equal solids and symmetric for others") {
  CHECK(contact_conductance(3.0, 3.0, 1e-5) == Approx(2.0 * 3.0 * 1e-5).epsilon(1e-15));
  CHECK(contact_conductance(3.0, 7.0, 1e-5) == contact_conductance(7.0, 3.0, 1e-5));
  CHECK(contact_conductance(3.0, 0.0, 1e-5) == 0.0);
  CHECK(contact_radius(1e-3, -1e-6, 0.03) == 0.0);
  CHECK(reduced_radius(2e-3, plane_wall) == Approx(2e-3).epsilon(1e-15));
  CHECK(reduced_radius(2e-3, 2e-3) == Approx(1e-3).epsilon(1e-15));
}

TEST_CASE("the lens' quadrature is within 1e-5 of the integral") {
  Random random(1, Purpose::test, 1);
  const double radii[] = {1.0, 2.03, 1.0 / 2.03, plane_wall};
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double R2 = radii[random.bits() % 4];
    const bool wall = std::isinf(R2), touching = random.uniform() < 0.5;
    const double h = touching ? 0.0 : 3.0 * std::min(1.0, R2) * std::pow(10, -4 * random.uniform());
    const double r_c = touching ? std::pow(10.0, -4.0 + 2.3 * random.uniform()) : 0.0;
    const GapPair pair{1.0, R2, (wall ? 1.0 : 1.0 + R2) + h, r_c, 0.6};
    const double jump = std::pow(10.0, -5.0 + 6.0 * random.uniform());
    const double lens = gap_conductance(pair, {ideal, ideal, 1.0, jump});
    worst = std::max(worst, std::abs(lens / ideal_lens(pair, jump) - 1.0));
  }
  CHECK(worst < 1e-5);
}

TEST_CASE("spot and lens carry less than both alone, for they heat the same solids") {
  Random random(2, Purpose::test, 1);
  for (int i = 0; i < 2000; ++i) {
    const double R2 = i % 3 == 0 ? plane_wall : i % 3 == 1 ? 1.0 : 2.03;
    const double spot = std::pow(10.0, -4.0 + 2.5 * random.uniform());
    const GapPair pair{1.0, R2, std::isinf(R2) ? 1.0 : 1.0 + R2, spot, 0.6};
    const GapMedium medium{std::pow(10.0, 0.7 + 2.5 * random.uniform()),
                           std::pow(10.0, 0.7 + 2.5 * random.uniform()), 1.0,
                           std::pow(10.0, -5.0 + 6.0 * random.uniform())};
    const auto both = pair_conductance(pair, medium);
    const double lens = gap_conductance(pair, medium), touch = spot_conductance(pair, medium);
    REQUIRE(both.contact > 0.0);
    REQUIRE(both.gas > 0.0);
    REQUIRE(both.contact + both.gas < lens + touch);
    REQUIRE(both.contact + both.gas > std::max(lens, touch));
  }
  // Without gas the spot alone is left, without a spot the lens.
  const GapPair pair{1.0, 1.0, 2.0, 0.004, 0.6}, bare{1.0, 1.0, 2.0, 0.0, 0.6};
  const GapMedium medium{90.0, 20.0, 1e-9, 1e-4};
  CHECK(pair_conductance(pair, medium).contact ==
        Approx(spot_conductance(pair, medium)).epsilon(1e-6));
  CHECK(pair_conductance(bare, medium).gas == gap_conductance(bare, medium));
  CHECK(spot_conductance(pair, medium) ==
        Approx(contact_conductance(90.0, 20.0, 0.004)).epsilon(0.01));
}

TEST_CASE("a gap's conductance fades smoothly to nothing") {
  CHECK(gap_fade(0.25, 0.25, 0.75) == 1.0);
  CHECK(gap_fade(0.5, 0.25, 0.75) == 0.5);
  CHECK(gap_fade(0.75, 0.25, 0.75) == 0.0);
  CHECK(gap_fade(0.1, 0.0, 0.0) == 0.0);
  double before = 1.0;
  for (double gap = 0.0; gap < 1.0; gap += 1e-3) {
    const double now = gap_fade(gap, 0.25, 0.75);
    REQUIRE((now <= before && before - now < 4e-3));
    before = now;
  }
  // To walls only where the law has come down to half a hundredth of its value at touch anyway.
  const GapMedium alumina{100.0, 1.0, 1.0, 1e-3};
  const GapPair at{1.0, plane_wall, 1.0, 0.0, 0.6}, far{1.0, plane_wall, 3.0, 0.0, 0.6};
  CHECK(gap_conductance(far, alumina) < 5e-3 * gap_conductance(at, alumina));
}

TEST_CASE("a gap conducts alike from either side") {
  const double one = gap_conductance({1.5e-3, 0.7e-3, 2.3e-3, 1e-5, 0.6}, {6.0, 1.1, 0.06, 5e-5});
  const double two = gap_conductance({0.7e-3, 1.5e-3, 2.3e-3, 1e-5, 0.6}, {1.1, 6.0, 0.06, 5e-5});
  CHECK(one == two);
}

TEST_CASE("a wall is the mirror plane of two equal spheres and the limit of a huge one") {
  // Half of a mirrored pair: half the resistance, half the jumps.
  const double wall = gap_conductance({1.0, plane_wall, 1.05, 0.0, 0.6}, {90.0, 1.0, 1.0, 0.01});
  const double pair = gap_conductance({1.0, 1.0, 2.1, 0.0, 0.6}, {90.0, 90.0, 1.0, 0.02});
  CHECK(wall == Approx(2.0 * pair).epsilon(2e-5));  // both by quadrature, 1e-5 each
  const double huge = gap_conductance({1.0, 1e5, 1e5 + 1.0, 0.0, 0.6}, {90.0, ideal, 1.0, 0.01});
  const double plane = gap_conductance({1.0, plane_wall, 1.0, 0.0, 0.6}, {90.0, 1.0, 1.0, 0.01});
  CHECK(huge == Approx(plane).epsilon(1e-4));  // curvature 1e-5 of the sphere's
}

TEST_CASE("a gap conducts less when it is wider, rarer or taken up by contact") {
  const GapPair near{1.0, 1.0, 2.0, 0.0, 0.6}, far{1.0, 1.0, 2.2, 0.0, 0.6};
  const GapPair pressed{1.0, 1.0, 2.0, 0.05, 0.6}, closed{1.0, 1.0, 2.0, 0.6, 0.6};
  const GapMedium dense{90.0, 20.0, 1.0, 1e-4}, rare{90.0, 20.0, 1.0, 1.0};
  const double most = gap_conductance(near, dense);
  CHECK(gap_conductance(far, dense) < most);
  CHECK(gap_conductance(near, rare) < most);
  CHECK(gap_conductance(pressed, dense) < most);
  CHECK(gap_conductance(closed, dense) == 0.0);
  // Vacuum: k_f times the lens' area over g; the lens has r_sf = 0.5531 R at phi = 0.6.
  const double thin = gap_conductance(near, {90.0, 20.0, 1.0, 1e6});
  CHECK(thin == Approx(pi * 0.553134 * 0.553134 / 1e6).epsilon(1e-5));
}

TEST_CASE("spheres that overlap softly count as just touching") {
  CHECK(true_distance(1.0, 2.0, 2.9) == 3.0);
  CHECK(true_distance(1.0, 2.0, 3.2) == 3.2);
  CHECK(true_distance(1.0, plane_wall, 0.98) == 1.0);
}

TEST_CASE("a column fills its layers with graded cells and their heat capacity") {
  const Materials materials = lining_materials();
  const WallColumn column = make_column(lining, materials);
  double coat = 0.0, board = 0.0;
  for (std::size_t j = 0; j < column.size(); ++j)
    (column.material[j] == 0 ? coat : board) += column.thickness[j];
  CHECK(coat == Approx(1e-3).epsilon(1e-14));
  CHECK(board == Approx(0.12).epsilon(1e-14));
  CHECK(column.thickness[0] <= face_cell);
  CHECK(column.size() < 60);
  CHECK(sum_of(column.capacity) == Approx(2e6 * 1e-3 + 300.0 * 1100.0 * 0.12).epsilon(1e-14));
  for (std::size_t j = 2; j < column.size(); ++j)
    CHECK(column.thickness[j] <= cell_growth * column.thickness[j - 1] * (1.0 + 1e-12));
}

TEST_CASE("a column's energies change by what crosses its ends, to rounding") {
  const Materials materials = lining_materials();
  const WallColumn column = make_column(lining, materials);
  std::vector<double> T(column.size()), conductance(column.size()), rate(column.size());
  Random random(1, Purpose::test, 2);
  for (double& each : T) each = 400.0 + 600.0 * random.uniform();
  column_conductances(column, materials, 1000.0, T, conductance);
  const double out = column_rates(column, {2.5e-3, 7.0}, T, conductance, rate);
  double moved = 0.0;
  for (const double each : rate) moved += std::abs(each);
  CHECK(std::abs(sum_of(rate) - (7.0 - out)) < 1e-15 * static_cast<double>(T.size()) * moved);
}

TEST_CASE("an isothermal column stays as it is") {
  const Materials materials = lining_materials();
  Lining even = lining;
  even.initial_temperature = even.outside_temperature = 873.15;
  const WallColumn column = make_column(even, materials);
  std::vector<double> energy(column.size()), T(column.size()), conductance(column.size());
  std::vector<double> rate(column.size());
  initial_energies(column, 3e-3, energy);
  column_temperatures(column, 3e-3, energy, T);
  for (const double each : T) CHECK(std::abs(each - 873.15) < 1e-12);  // a few ulps
  std::fill(T.begin(), T.end(), 873.15);
  column_conductances(column, materials, 1000.0, T, conductance);
  CHECK(column_rates(column, {3e-3, 0.0}, T, conductance, rate) == 0.0);
  for (const double each : rate) CHECK(each == 0.0);
}

TEST_CASE("a column's resistances add up to its layers and the film") {
  const Materials materials{
      {verify::constant_solid(2000.0, 1000.0, 1.5), verify::constant_solid(300.0, 1100.0, 0.18)},
      {}};
  const WallColumn column = make_column(lining, materials);
  std::vector<double> T(column.size(), 500.0), conductance(column.size());
  column_conductances(column, materials, 1e5, T, conductance);
  double resistance = 0.0;
  for (const double each : conductance) resistance += 1.0 / each;
  // The constant solids have no gas share, so pressure does not enter.
  CHECK(resistance == Approx(1e-3 / 1.5 + 0.12 / 0.18 + 1.0 / 10.0).epsilon(1e-13));
}

TEST_CASE("linings that this layer cannot carry are refused together") {
  const Materials materials{{verify::reference_alumina()}, {}};
  const Lining bad{{{0, 0.0}}, 300.0, 10.0, 300.0};
  try {
    make_column(bad, materials);
    FAIL("no error");
  } catch (const CaseError& error) {
    CHECK(error.faults().size() == 2);
  }
  CHECK_THROWS_AS(make_column({{}, 300.0, 10.0, 300.0}, materials), CaseError);
}
