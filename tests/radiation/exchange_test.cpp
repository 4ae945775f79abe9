#include "radiation/exchange.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

#include "pmr/base/parallel.hpp"
#include "scenes.hpp"

using namespace pmr;
using namespace pmr::radiation;

namespace {

// A bed in a grey box: spheres of two emissivities, five grey walls, an adiabatic lid.
Exchange trace_bed(int threads) {
  const ThreadLimit limit(threads);
  const auto spheres = jittered_lattice(8);
  const auto walls = inward_box(Vec3::Constant(-1.05e-3), Vec3::Constant(15.36e-3), 512);
  std::vector<double> emissivity(519, 0.8), area(519, sphere_area(1e-3));
  for (std::uint32_t node = 0; node < 512; node += 3) emissivity[node] = 0.4;
  for (std::uint32_t node = 512; node < 518; ++node) area[node] = 16.41e-3 * 16.41e-3;
  emissivity[517] = 0.0;
  return trace({spheres, walls, emissivity, area, 519, 60.0, 5, 2});
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

}  // namespace

TEST_CASE("one and two threads give the same exchange, bit by bit") {
  const auto one = trace_bed(1), two = trace_bed(2);
  CHECK(same_bits(one.factor.start, two.factor.start));
  CHECK(same_bits(one.factor.column, two.factor.column));
  CHECK(same_bits(one.factor.value, two.factor.value));
  CHECK(same_bits(one.self, two.self));
  CHECK(one.relative_error == two.relative_error);
}

TEST_CASE("a closed bed loses nothing to the surroundings and an adiabatic wall has no entries") {
  const auto bed = trace_bed(2);
  CHECK(bed.factor.columns(517).empty());
  CHECK(bed.factor.columns(518).empty());
  CHECK(bed.self[517] == 0.0);
  CHECK(bed.unfinished == 0);
}

TEST_CASE("columns ascend, factors are positive and the diagonal is left out") {
  const auto bed = trace_bed(2);
  const Csr& factor = bed.factor;
  REQUIRE(factor.rows() == 519);
  for (std::uint32_t i = 0; i < factor.rows(); ++i) {
    const auto columns = factor.columns(i);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k] == i || factor.values(i)[k] <= 0.0) FAIL("row " << i);
      if (k > 0 && columns[k] <= columns[k - 1]) FAIL("row " << i);
    }
  }
}

TEST_CASE("an empty scene has an empty exchange") {
  const auto traced = trace({{}, {}, {0.8, 0.8, 1.0}, {1.0, 1.0, 0.0}, 3, 100.0, 1, 0});
  CHECK(traced.factor.rows() == 3);
  CHECK(traced.factor.entries() == 0);
  CHECK(traced.rays == 0.0);
}

TEST_CASE("a lone sphere sends everything to the surroundings") {
  const std::vector<Sphere> spheres{{Vec3(0.1, 0.2, 0.3), 1.5e-3, 0}};
  const double area = sphere_area(1.5e-3);
  const auto traced = trace({spheres, {}, {0.8, 1.0}, {area, 0.0}, 2, 1000.0, 1, 0});
  REQUIRE(traced.factor.entries() == 2);
  CHECK(traced.rays == 1000.0);
  // eps A by definition; 1000 equal parts add up to it within rounding.
  CHECK(traced.factor.value[0] == Approx(0.8 * area).epsilon(1e-12));
  CHECK(traced.factor.value[1] == traced.factor.value[0]);
}

TEST_CASE("a perfectly reflecting box gives a sphere all its light back") {
  const std::vector<Sphere> spheres{{Vec3(0.1, 0.0, -0.2), 1.0, 0}};
  const auto walls = inward_box(Vec3::Constant(-2.0), Vec3::Constant(2.0), 1);
  std::vector<double> emissivity(8, 0.0), area(8, 16.0);
  emissivity[0] = 0.3;
  area[0] = sphere_area(1.0);
  const auto traced = trace({spheres, walls, emissivity, area, 8, 20000.0, 1, 0});
  CHECK(traced.factor.entries() == 0);
  CHECK(traced.self[0] == Approx(0.3 * area[0]).epsilon(1e-12));
  CHECK(traced.unfinished == 0);
}

TEST_CASE("a black cube takes a sixth of its central sphere's light with each face") {
  const std::vector<Sphere> spheres{{Vec3::Zero(), 1.0, 0}};
  const auto walls = inward_box(Vec3::Constant(-2.0), Vec3::Constant(2.0), 1);
  const Tracer tracer(spheres, walls);
  const std::uint64_t rays = 600000;
  const auto counts = view_counts(tracer, 0, rays, 3, 8);
  CHECK(counts[0] == 0);
  CHECK(counts[7] == 0);
  // 4 binomial standard errors: 4 sqrt(n p (1 - p)) = 1155; each fails by chance in 6e-5.
  for (std::size_t face = 1; face <= 6; ++face)
    CHECK(static_cast<double>(counts[face]) == Approx(100000.0).margin(1155.0));
}

TEST_CASE("rays are dealt in proportion to what is emitted, one at least") {
  const std::vector<Sphere> spheres{{Vec3::Zero(), 1.0, 0}, {Vec3(5.0, 0.0, 0.0), 2.0, 1}};
  const std::vector<Triangle> plate{
      {{Vec3(0.0, 0.0, 9.0), Vec3(0.0, 1e-3, 9.0), Vec3(1e-3, 0.0, 9.0)}, 2}};
  const std::vector<double> area{sphere_area(1.0), sphere_area(2.0), 5e-7, 0.0};
  const auto traced = trace({spheres, plate, {0.8, 0.4, 0.8, 1.0}, area, 4, 100.0, 1, 0});
  CHECK(traced.rays == 100.0 + 200.0 + 1.0);
}

TEST_CASE("each step draws fresh rays") {
  const auto spheres = jittered_lattice(3);
  const std::vector<double> emissivity(28, 0.5), area(28, sphere_area(1e-3));
  const auto first = trace({spheres, {}, emissivity, area, 28, 200.0, 1, 0});
  const auto second = trace({spheres, {}, emissivity, area, 28, 200.0, 1, 1});
  CHECK_FALSE(same_bits(first.factor.value, second.factor.value));
}

TEST_CASE("an emissivity above one is refused") {
  const std::vector<Sphere> spheres{{Vec3::Zero(), 1.0, 0}};
  CHECK_THROWS_AS(trace({spheres, {}, {1.1, 1.0}, {1.0, 0.0}, 2, 1.0, 1, 0}), std::logic_error);
}

namespace {

// All of the bed and its box of one emissivity.
Exchange trace_grey(double emissivity) {
  const auto spheres = jittered_lattice(8);
  const auto walls = inward_box(Vec3::Constant(-1.05e-3), Vec3::Constant(15.36e-3), 512);
  std::vector<double> area(519, sphere_area(1e-3));
  for (std::uint32_t node = 512; node < 518; ++node) area[node] = 16.41e-3 * 16.41e-3;
  return trace({spheres, walls, std::vector<double>(519, emissivity), area, 519, 1000.0, 5, 2});
}

// What a bed's conductivity grows with: sum over pairs of spheres of G_ij |x_i - x_j|^2 [m4].
double spread(const Exchange& exchange) {
  const auto spheres = jittered_lattice(8);
  double sum = 0.0;
  for (std::uint32_t i = 0; i < 512; ++i)
    for (std::size_t k = 0; k < exchange.factor.columns(i).size(); ++k) {
      const std::uint32_t j = exchange.factor.columns(i)[k];
      if (j < 512)
        sum += exchange.factor.values(i)[k] * (spheres[i].centre - spheres[j].centre).squaredNorm();
    }
  return sum;
}

}  // namespace

TEST_CASE("factors scaled to other emissivities keep symmetry and sums, and nearly the paths") {
  Exchange scaled = trace_grey(0.5);
  const Exchange traced = trace_grey(0.55);
  const double before = spread(scaled);
  std::vector<double> emission(519, 0.55 * sphere_area(1e-3));
  for (std::uint32_t node = 512; node < 518; ++node) emission[node] = 0.55 * 16.41e-3 * 16.41e-3;
  emission[518] = 0.0;
  rescale(std::vector<double>(519, 0.55), emission, scaled);
  const auto sums = row_sums(scaled.factor);
  for (std::uint32_t i = 0; i < 518; ++i)
    CHECK(sums[i] + scaled.self[i] == Approx(emission[i]).epsilon(1e-9));
  for (std::uint32_t i = 0; i < 512; ++i)
    for (std::size_t k = 0; k < scaled.factor.columns(i).size(); ++k) {
      const auto mirror = scaled.factor.columns(scaled.factor.columns(i)[k]);
      const auto at = std::lower_bound(mirror.begin(), mirror.end(), i) - mirror.begin();
      const auto row = scaled.factor.values(scaled.factor.columns(i)[k]);
      if (row[static_cast<std::size_t>(at)] != scaled.factor.values(i)[k]) FAIL("row " << i);
    }
  CHECK(scaled.emissivity[3] == 0.55);
  CHECK(scaled.traced_emissivity[3] == 0.5);
  // 2 % too wide: the paths are those of more reflections. Without the scaling 8 % too little.
  CHECK(spread(scaled) == Approx(spread(traced)).epsilon(0.025));
  CHECK(before < 0.95 * spread(traced));
}
