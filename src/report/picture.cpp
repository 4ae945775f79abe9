#include "report/picture.hpp"

#include <algorithm>
#include <cmath>

#include "physics/adhered.hpp"
#include "pmr/base/parallel.hpp"
#include "radiation/camera.hpp"
#include "report/wall_mesh.hpp"

namespace pmr::report {
namespace {

constexpr std::array<std::uint8_t, 3> sky{247, 248, 250};
constexpr Rgb inert_grey{0.80, 0.80, 0.79};
constexpr Rgb adhered_grey{0.55, 0.55, 0.57};  // grains that adhere to walls

// Spheres get soft light from the upper left; walls stay pale, so that the bed stands out.
Rgb shade(const Rgb& colour, const Vec3& normal, const View& view) {
  const Vec3 light = (0.6 * view.up - 0.4 * view.right - 0.8 * view.forward).normalized();
  const double bright = 0.42 + 0.58 * std::max(0.0, normal.dot(light));
  return {bright * colour[0], bright * colour[1], bright * colour[2]};
}

Rgb wall_colour(const Vec3& normal, const View& view) {
  const double facing = std::abs(normal.dot(view.forward));
  const double grey = 0.86 + 0.07 * facing;
  return {grey, grey, grey + 0.01};
}

radiation::Camera camera_of(const View& view, std::size_t pixels_x, std::size_t pixels_y) {
  radiation::Camera camera;
  const double away = 2.0 * (view.width + view.height);  // [m] before everything
  camera.eye = view.middle - away * view.forward;
  camera.target = view.middle;
  camera.up = view.up;
  camera.width = view.width;
  camera.pixels_x = static_cast<int>(pixels_x);
  camera.pixels_y = static_cast<int>(pixels_y);
  camera.cut_point = view.middle;
  camera.cut_normal = -view.forward;
  return camera;
}

// The particles, then the grains that adhere to walls.
std::vector<radiation::Sphere> spheres_of(const io::Snapshot& snapshot,
                                          const std::optional<Case>& setup) {
  const Particles& particles = snapshot.particles;
  std::vector<radiation::Sphere> spheres(particles.size());
  for (std::size_t i = 0; i < spheres.size(); ++i)
    spheres[i] = {particles.position[i], particles.radius[i], static_cast<std::uint32_t>(i)};
  if (!setup) return spheres;
  const auto adhered = physics::adhered_places(setup->walls, snapshot.time);
  for (std::size_t k = 0; k < adhered.size(); ++k)
    spheres.push_back(
        {adhered[k], setup->walls.grains[k].radius, static_cast<std::uint32_t>(spheres.size())});
  return spheres;
}

Rgb colour_of(const radiation::PixelHit& hit, std::size_t particles, std::size_t spheres,
              const View& view, const Paint& paint) {
  if (hit.is_empty()) return {sky[0] / 255.0, sky[1] / 255.0, sky[2] / 255.0};
  if (hit.primitive >= spheres) return wall_colour(hit.normal, view);
  if (hit.primitive >= particles) return shade(adhered_grey, hit.normal, view);
  return shade(paint(hit.primitive), hit.normal, view);
}

// Averages 2 x 2 samples into each pixel.
Image develop(const std::vector<Rgb>& samples, std::size_t width, std::size_t height) {
  Image image(width, height, sky);
  parallel_for(width * height, [&](std::size_t k) {
    const std::size_t x = k % width, y = k / width;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t top = 2 * y * 2 * width + 2 * x, low = top + 2 * width;
      const double sum =
          samples[top][c] + samples[top + 1][c] + samples[low][c] + samples[low + 1][c];
      image.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(255.0 * std::min(1.0, sum / 4)));
    }
  });
  return image;
}

bool shows_delta(const Particles& p, std::size_t i, std::optional<std::size_t> species) {
  return p.formula_units[i] > 0.0 && (!species || p.species[i] == *species);
}

}  // namespace

View look_at_cut(const std::optional<Case>& setup) {
  View view{Vec3::Zero(), Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ(), 1.0, 1.0};
  if (setup && setup->output.cut_normal.norm() > 0.0) {
    view.middle = setup->output.cut_point;
    view.forward = setup->output.cut_normal.normalized();
    // Both signs of the normal give the same picture: +x to the right for a cut along xz.
    Eigen::Index largest = 0;
    view.forward.cwiseAbs().maxCoeff(&largest);
    if (view.forward[largest] < 0.0) view.forward = -view.forward;
  }
  const Vec3 upwards = std::abs(view.forward.z()) > 0.9 ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitZ());
  view.right = view.forward.cross(upwards).normalized();
  view.up = view.right.cross(view.forward);
  return view;
}

void Extent::add(const View& view, const io::Snapshot& snapshot) {
  for (std::size_t i = 0; i < snapshot.particles.size(); ++i) {
    const Vec3 from = snapshot.particles.position[i] - view.middle;
    const Eigen::Vector2d at(from.dot(view.right), from.dot(view.up));
    const double r = snapshot.particles.radius[i];
    low = low.cwiseMin(at - Eigen::Vector2d(r, r));
    high = high.cwiseMax(at + Eigen::Vector2d(r, r));
  }
}

void frame(View& view, const Extent& extent, double margin) {
  const Eigen::Vector2d &low = extent.low, &high = extent.high;
  if (low.x() > high.x()) return;
  const double rim = margin * (high - low).maxCoeff();
  const Eigen::Vector2d middle = 0.5 * (low + high);
  view.middle += middle.x() * view.right + middle.y() * view.up;
  view.width = high.x() - low.x() + 2.0 * rim;
  view.height = high.y() - low.y() + 2.0 * rim;
}

void frame(View& view, const io::Snapshot& snapshot, double margin) {
  Extent extent;
  extent.add(view, snapshot);
  frame(view, extent, margin);
}

Image draw(const io::Snapshot& snapshot, const std::optional<Case>& setup, const View& view,
           std::size_t pixels_x, const Paint& paint) {
  const auto pixels_y =
      std::max<std::size_t>(8, static_cast<std::size_t>(std::lround(static_cast<double>(pixels_x) *
                                                                    view.height / view.width)));
  const auto spheres = spheres_of(snapshot, setup);
  const auto walls = wall_mesh(setup, snapshot.time);
  const auto hits =
      radiation::photograph(spheres, walls, camera_of(view, 2 * pixels_x, 2 * pixels_y));
  std::vector<Rgb> samples(hits.size());
  parallel_for(hits.size(), [&](std::size_t k) {
    samples[k] = colour_of(hits[k], snapshot.particles.size(), spheres.size(), view, paint);
  });
  return develop(samples, pixels_x, pixels_y);
}

Paint paint_species(const io::Snapshot& snapshot) {
  return [&snapshot](std::size_t i) { return species_colour(snapshot.particles.species[i]); };
}

Paint paint_temperature(const io::Snapshot& snapshot, Limits limits) {
  return [&snapshot, limits](std::size_t i) {
    return colour_at(ColourMap::inferno, limits.fraction(snapshot.particles.temperature[i]));
  };
}

Paint paint_delta(const io::Snapshot& snapshot, Limits limits, std::optional<std::size_t> species) {
  return [&snapshot, limits, species](std::size_t i) {
    if (!shows_delta(snapshot.particles, i, species)) return inert_grey;
    return colour_at(ColourMap::viridis, limits.fraction(snapshot.particles.delta[i]));
  };
}

std::optional<Limits> joined(std::optional<Limits> a, std::optional<Limits> b) {
  if (!a || !b) return a ? a : b;
  return Limits{std::min(a->low, b->low), std::max(a->high, b->high)};
}

std::optional<Limits> temperature_limits(const io::Snapshot& snapshot) {
  const auto& temperature = snapshot.particles.temperature;
  if (temperature.empty()) return std::nullopt;
  const auto [low, high] = std::minmax_element(temperature.begin(), temperature.end());
  return Limits{*low, *high};
}

std::optional<Limits> delta_limits(const io::Snapshot& snapshot,
                                   std::optional<std::size_t> species) {
  Limits limits{1e30, -1e30};
  for (std::size_t i = 0; i < snapshot.particles.size(); ++i) {
    if (!shows_delta(snapshot.particles, i, species)) continue;
    limits.low = std::min(limits.low, snapshot.particles.delta[i]);
    limits.high = std::max(limits.high, snapshot.particles.delta[i]);
  }
  return limits.low > limits.high ? std::nullopt : std::optional(limits);
}

std::vector<Line> wall_section(const std::optional<Case>& setup, double t, const View& view,
                               double pixels_x) {
  const double scale = pixels_x / view.width;  // [pixels/m]
  std::vector<Line> lines;
  for (const radiation::Triangle& triangle : wall_mesh(setup, t)) {
    std::vector<Eigen::Vector2d> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = triangle.corner[k] - view.middle,
                 b = triangle.corner[(k + 1) % 3] - view.middle;
      const double da = a.dot(view.forward), db = b.dot(view.forward);
      if ((da >= 0.0) == (db >= 0.0)) continue;
      const Vec3 at = a + da / (da - db) * (b - a);
      ends.emplace_back((at.dot(view.right) + 0.5 * view.width) * scale,
                        (0.5 * view.height - at.dot(view.up)) * scale);
    }
    if (ends.size() == 2 && (ends[0] - ends[1]).norm() > 0.05)
      lines.push_back({ends[0].x(), ends[0].y(), ends[1].x(), ends[1].y()});
  }
  return lines;
}

}  // namespace pmr::report
