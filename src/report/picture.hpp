// Pictures of a bed cut open, drawn with the radiation camera: which part of the world, in which
// colours, with the walls' section on top.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "io/run_file.hpp"
#include "pmr/state/case.hpp"
#include "report/colour_map.hpp"
#include "report/image.hpp"

namespace pmr::report {

// What the camera sees: a rectangle in the cutting plane. Looks along the plane's normal.
struct View {
  Vec3 middle;              // [m] on the cutting plane
  Vec3 forward, right, up;  // [1] orthonormal
  double width, height;     // [m]
};

// An orthographic view along the normal of the case's cut, on a square of 1 m.
View look_at_cut(const std::optional<Case>& setup);
// What the particles take up, seen along the view, snapshot by snapshot.
struct Extent {
  Eigen::Vector2d low{1e30, 1e30}, high{-1e30, -1e30};  // [m] right of and above the view's middle
  void add(const View& view, const io::Snapshot& snapshot);
};
// Widens the view until it holds the extent and a margin [1] more.
void frame(View& view, const Extent& extent, double margin);
void frame(View& view, const io::Snapshot& snapshot, double margin);

// Colour of a particle, by its index in the snapshot.
using Paint = std::function<Rgb(std::size_t)>;
Image draw(const io::Snapshot& snapshot, const std::optional<Case>& setup, const View& view,
           std::size_t pixels_x, const Paint& paint);

Paint paint_species(const io::Snapshot& snapshot);
Paint paint_temperature(const io::Snapshot& snapshot, Limits limits);  // [K]
// Inert particles grey; of one species alone where one is named, all others grey.
Paint paint_delta(const io::Snapshot& snapshot, Limits limits,
                  std::optional<std::size_t> species = std::nullopt);

// Smallest and largest over the particles; none without particles.
std::optional<Limits> temperature_limits(const io::Snapshot& snapshot);
// Of the reactive particles, or of one species.
std::optional<Limits> delta_limits(const io::Snapshot& snapshot,
                                   std::optional<std::size_t> species = std::nullopt);
std::optional<Limits> joined(std::optional<Limits> a, std::optional<Limits> b);  // what holds both

// Lines in which the walls present at time t [s] meet the cut, in pixels of a picture.
struct Line {
  double x0, y0, x1, y1;  // [pixels] from the top left
};
std::vector<Line> wall_section(const std::optional<Case>& setup, double t, const View& view,
                               double pixels_x);

}  // namespace pmr::report
