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
