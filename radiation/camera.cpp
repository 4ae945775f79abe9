#include "radiation/camera.hpp"

#include <algorithm>
#include <cmath>

#include "pmr/base/parallel.hpp"

namespace pmr::radiation {
namespace {

// Signed distance [m] from the cut, positive where things are taken away; negative without a cut.
double beyond_cut(const Camera& camera, const Vec3& point) {
  const double length = camera.cut_normal.norm();
  return length > 0.0 ? (point - camera.cut_point).dot(camera.cut_normal) / length : -1.0;
}

// Distance [m] along the ray at which it enters what the cut has left; infinite if it never does.
double entry(const Camera& camera, const Vec3& origin, const Vec3& direction) {
  const double beyond = beyond_cut(camera, origin);
  if (beyond <= 0.0) return 0.0;
  const double slope = direction.dot(camera.cut_normal) / camera.cut_normal.norm();
  return slope < 0.0 ? -beyond / slope : std::numeric_limits<double>::infinity();
}

struct Frame {
  Vec3 forward, right, up;  // [1] orthonormal
};

Frame frame_of(const Camera& camera) {
  const Vec3 forward = (camera.target - camera.eye).normalized();
  const Vec3 right = forward.cross(camera.up).normalized();
  return {forward, right, right.cross(forward)};
}

// Index of each kept sphere in the caller's list, which the hits are told in.
std::vector<std::uint32_t> kept_spheres(std::span<const Sphere> spheres, const Camera& camera) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < spheres.size(); ++i)
    if (beyond_cut(camera, spheres[i].centre) <= 0.0) kept.push_back(i);
  return kept;
}

}  // namespace

std::vector<PixelHit> photograph(std::span<const Sphere> spheres,
                                 std::span<const Triangle> triangles, const Camera& camera) {
  const std::vector<std::uint32_t> kept = kept_spheres(spheres, camera);
  std::vector<Sphere> shown;
  shown.reserve(kept.size());
  for (const std::uint32_t i : kept) shown.push_back(spheres[i]);
  const Scene bed(shown, {});
  const Scene walls({}, triangles);
  const Frame frame = frame_of(camera);
  const double pixel = camera.width / camera.pixels_x;  // [m]
  const auto columns = static_cast<std::size_t>(camera.pixels_x);
  const auto rows = static_cast<std::size_t>(camera.pixels_y);
  std::vector<PixelHit> picture(columns * rows);
  parallel_for(picture.size(), [&](std::size_t k) {
    const double x = (static_cast<double>(k % columns) + 0.5) * pixel - 0.5 * camera.width;
    const std::size_t row = k / columns;
    const double y = (0.5 * static_cast<double>(rows) - static_cast<double>(row) - 0.5) * pixel;
    const Vec3 origin = camera.eye + x * frame.right + y * frame.up;
    Hit hit = bed.nearest({origin, frame.forward});
    if (!hit.is_empty()) hit.primitive = kept[hit.primitive];
    const double from = entry(camera, origin, frame.forward);
    if (std::isfinite(from)) {
      const Hit wall = walls.nearest({origin, frame.forward, from});
      if (wall.distance < hit.distance) {
        hit = wall;
        hit.primitive += static_cast<std::uint32_t>(spheres.size());
      }
    }
    picture[k] = {hit.node, hit.primitive, hit.distance, hit.normal};
  });
  return picture;
}

}  // namespace pmr::radiation
