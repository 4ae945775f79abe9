#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/hash.hpp"
#include "pmr/base/parallel.hpp"
#include "pmr/base/random.hpp"
#include "pmr/base/table.hpp"
#include "pmr/state/particles.hpp"

using namespace pmr;

TEST_CASE("Constants agree with CODATA 2018") {
  CHECK(gas_constant == Approx(8.314462618).epsilon(1e-10));
  CHECK(stefan_boltzmann == Approx(5.670374419e-8).epsilon(1e-10));
}

TEST_CASE("A parallel sum has the same bits on one and on two threads") {
  const auto term = [](std::size_t i) { return std::sin(static_cast<double>(i)) * 1e3; };
  double one = 0.0, two = 0.0;
  {
    const ThreadLimit limit(1);
    one = parallel_sum(100'003, term);
  }
  {
    const ThreadLimit limit(2);
    two = parallel_sum(100'003, term);
  }
  CHECK(one == two);
}

TEST_CASE("A parallel loop visits every index once, and none of an empty range") {
  std::vector<std::atomic<int>> visits(5000);
  parallel_for(visits.size(), [&](std::size_t i) { ++visits[i]; });
  for (const auto& v : visits) REQUIRE(v == 1);
  parallel_for(0, [&](std::size_t) { FAIL(); });
  CHECK(parallel_sum(0, [](std::size_t) { return 1.0; }) == 0.0);
  CHECK(parallel_max(0, -3.0, [](std::size_t) { return 1.0; }) == -3.0);
}

TEST_CASE("Random numbers depend on their key alone and fill [0, 1) evenly") {
  Random a(1, Purpose::test, 7), b(1, Purpose::test, 7), c(1, Purpose::test, 8);
  double sum = 0.0, square = 0.0;
  const int n = 100'000;
  std::set<double> seen;
  for (int i = 0; i < n; ++i) {
    const double u = a.uniform();
    REQUIRE(u == b.uniform());
    REQUIRE((u >= 0.0 && u < 1.0));
    if (u == c.uniform()) FAIL("streams coincide");
    sum += u;
    square += u * u;
  }
  // Mean 1/2 +- 4/sqrt(12 n); mean square 1/3 +- 4 sqrt(4/45/n): four standard errors.
  CHECK(std::abs(sum / n - 0.5) < 4.0 / std::sqrt(12.0 * n));
  CHECK(std::abs(square / n - 1.0 / 3.0) < 4.0 * std::sqrt(4.0 / 45.0 / n));
}

TEST_CASE("A table is linear between its points and constant beyond") {
  const Table t{{0.0, 1.0, 3.0}, {1.0, 2.0, 0.0}};
  CHECK(t(-1.0) == 1.0);
  CHECK(t(0.5) == 1.5);
  CHECK(t(2.0) == 1.0);
  CHECK(t(9.0) == 0.0);
}

TEST_CASE("A hash changes with one ulp") {
  Hash a, b;
  a.add(1.0);
  b.add(std::nextafter(1.0, 2.0));
  CHECK(a.value() != b.value());
}

TEST_CASE("All faults of a case are told together") {
  const CaseError error({{"a.toml:1:2", "mass", "must be positive"}, {"b", "", "is empty"}});
  CHECK(std::string(error.what()) == "a.toml:1:2: mass: must be positive\nb: is empty");
}

TEST_CASE("Resizing fills every field with zeros") {
  Particles particles;
  resize(particles, 3);
  CHECK(particles.position[2].norm() == 0.0);
  CHECK(particles.temperature.size() == 3);
}
