#include <catch2/catch.hpp>
#include <cmath>

#include "beds.hpp"
#include "instruments/thermocouple.hpp"

using namespace pmr;
using namespace pmr::instruments;

TEST_CASE("A thermocouple reads the mean of the particles round its tip") {
  Particles bed;
  for (int i = 0; i < 4; ++i) test::add_sphere(bed, 0, Vec3(0.001 * i, 0.0, 0.0), 0.0005, 1.0);
  bed.temperature = {300.0, 320.0, 360.0, 900.0};
  const Thermocouple probe{"centre", Vec3(0.0009, 0.0, 0.0), 0.0015};
  const ThermocoupleReading reading = read_thermocouple(probe, bed);
  CHECK(reading.particles == 3);
  CHECK(reading.temperature == Approx((300.0 + 320.0 + 360.0) / 3.0).epsilon(1e-14));
  CHECK(reading.nearest == Approx(0.0001).epsilon(1e-9));
}

TEST_CASE("A thermocouple that reaches nobody reads the nearest particle and says so") {
  Particles bed;
  test::add_sphere(bed, 0, Vec3(1.0, 0.0, 0.0), 0.001, 1.0);
  test::add_sphere(bed, 0, Vec3(3.0, 0.0, 0.0), 0.001, 1.0);
  bed.temperature = {500.0, 600.0};
  const ThermocoupleReading reading = read_thermocouple({"far", Vec3(2.5, 0.0, 0.0), 0.01}, bed);
  CHECK(reading.particles == 0);
  CHECK(reading.temperature == 600.0);
  CHECK(std::isnan(read_thermocouple({"none", Vec3::Zero(), 1.0}, Particles{}).temperature));
}

TEST_CASE("A thermocouple that reads a plane does not mind where its particles lie") {
  Particles bed;  // T = 400 K + 1000 K/m x, more particles on the hot side
  for (const double x : {-0.002, 0.0005, 0.001, 0.0015, 0.002})
    for (const double y : {-0.001, 0.001})
      test::add_sphere(bed, 0, Vec3(x, y, 0.3 * y + 0.1 * x), 0.0005, 1.0);
  bed.temperature.resize(bed.size());
  for (std::size_t i = 0; i < bed.size(); ++i)
    bed.temperature[i] = 400.0 + 1000.0 * bed.position[i].x();
  Thermocouple probe{"steep", Vec3::Zero(), 0.004};
  CHECK(read_thermocouple(probe, bed).temperature == Approx(400.6).epsilon(1e-9));
  probe.is_plane = true;
  CHECK(read_thermocouple(probe, bed).temperature == Approx(400.0).epsilon(1e-12));
}

TEST_CASE("A plane wants eight particles: of fewer their mean is read") {
  Particles bed;
  for (int i = 0; i < 7; ++i) test::add_sphere(bed, 0, Vec3(0.001 * i, 0.0, 0.0), 0.0005, 1.0);
  bed.temperature = {300.0, 300.0, 300.0, 300.0, 300.0, 300.0, 370.0};
  const Thermocouple probe{"few", Vec3::Zero(), 0.01, true};
  CHECK(read_thermocouple(probe, bed).temperature == Approx(310.0).epsilon(1e-12));
}

TEST_CASE("A plane through one layer of particles reads what lies over and under it") {
  Particles bed;  // T = 500 K + 1000 K/m x, all 2 mm above the tip
  for (int i = -2; i <= 2; ++i)
    for (int j = -1; j <= 1; ++j)
      test::add_sphere(bed, 0, Vec3(0.001 * i, 0.001 * j, 0.002), 0.0005, 1.0);
  bed.temperature.resize(bed.size());
  for (std::size_t i = 0; i < bed.size(); ++i)
    bed.temperature[i] = 500.0 + 1000.0 * bed.position[i].x();
  const Thermocouple probe{"under", Vec3(0.0005, 0.0, 0.0), 0.01, true};
  CHECK(read_thermocouple(probe, bed).temperature == Approx(500.5).epsilon(1e-12));
}
