#include "radiation/camera.hpp"

#include <catch2/catch.hpp>

using namespace pmr;
using namespace pmr::radiation;

namespace {

// Looks along +y at the x-z plane; pixel (column, row) is at x = column - 4.5, z = 4.5 - row.
Camera front_view() {
  return {Vec3(0.0, -10.0, 0.0), Vec3::Zero(), Vec3::UnitZ(), 10.0, 10, 10,
          Vec3::Zero(),          Vec3::Zero()};
}

const PixelHit& at(const std::vector<PixelHit>& picture, std::size_t column, std::size_t row) {
  return picture[row * 10 + column];
}

}  // namespace

TEST_CASE("the camera shows a sphere at its pixel with its normal") {
  const std::vector<Sphere> spheres{{Vec3(2.5, 0.0, 3.5), 1.2, 7}};
  const auto picture = photograph(spheres, {}, front_view());
  REQUIRE(picture.size() == 100);
  const PixelHit& centre = at(picture, 7, 1);
  CHECK(centre.node == 7);
  CHECK(centre.primitive == 0);
  CHECK(centre.distance == Approx(10.0 - 1.2).epsilon(1e-6));  // single precision
  CHECK(centre.normal.y() == Approx(-1.0).epsilon(1e-6));
  const PixelHit& right = at(picture, 8, 1);  // 1.0 to the right of the centre: n_x = 1/1.2
  CHECK(right.normal.x() == Approx(1.0 / 1.2).epsilon(1e-5));
  CHECK(right.normal.y() == Approx(-std::sqrt(1.0 - 1.0 / 1.44)).epsilon(1e-5));
  CHECK(at(picture, 7, 8).is_empty());
  CHECK(at(picture, 2, 1).is_empty());
}

TEST_CASE("the cut takes away walls in front of it and spheres whose centre is in front of it") {
  const std::vector<Sphere> spheres{{Vec3(0.5, -3.0, 0.5), 2.0, 0}, {Vec3(0.5, 1.0, 0.5), 2.0, 1}};
  const auto plate = [](double y, std::uint32_t node) -> Triangle {
    return {{Vec3(-20.0, y, -20.0), Vec3(20.0, y, -20.0), Vec3(0.0, y, 40.0)}, node};
  };
  const std::vector<Triangle> walls{plate(-5.0, 2), plate(4.0, 3)};
  Camera camera = front_view();
  CHECK(at(photograph(spheres, walls, camera), 5, 4).node == 2);
  camera.cut_normal = -Vec3::UnitY();
  const auto picture = photograph(spheres, walls, camera);
  CHECK(at(picture, 5, 4).node == 1);  // whole, though it reaches through the cut
  CHECK(at(picture, 5, 4).primitive == 1);
  CHECK(at(picture, 5, 4).distance == Approx(9.0).epsilon(1e-6));
  CHECK(at(picture, 0, 0).node == 3);
  CHECK(at(picture, 0, 0).primitive == 3);
  CHECK(at(picture, 0, 0).normal.y() == -1.0);
}
