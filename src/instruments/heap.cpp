#include "instruments/heap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pmr/base/constants.hpp"

namespace pmr::instruments {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double flank_low = 0.2, flank_high = 0.8;  // [1] of the profile's largest height
constexpr double near_line = 0.75;                   // [1] bins
constexpr int most_fits = 50;
constexpr double cell_arc = 2.0;  // [1] bins along the ring that a cell is wide
constexpr double filled = 0.5;    // [1] of the cells: a ring with fewer ends the profile

struct Top {
  double radius, height;  // [m] from the axis, over the base
  double turn;            // [1] of a whole turn, in [0, 1)
};

// Of a plane heap the way along it, and across it what a turn is round an axis.
Top top_of(const Vec3& from, double radius, const HeapInstrument& tool) {
  const double height = from.z() + radius;
  if (!tool.plane) {
    const double turn = std::atan2(from.y(), from.x()) / (2.0 * pi);
    return {from.head<2>().norm(), height, turn - std::floor(turn)};
  }
  const double across = Vec3::UnitZ().cross(tool.plane->along).dot(from) / tool.plane->width;
  return {from.dot(tool.plane->along), height, std::clamp(0.5 + across, 0.0, 1.0)};
}

std::vector<Top> tops_of(const Particles& p, const HeapInstrument& tool) {
  std::vector<Top> tops;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (const Top top = top_of(p.position[i] - tool.centre, p.radius[i], tool); top.radius >= 0.0)
      tops.push_back(top);
  return tops;
}

// Two highest of a cell.
struct Highest {
  std::optional<Top> first, second;
  void add(const Top& top) {
    if (!first || top.height > first->height) {
      second = first;
      first = top;
    } else if (!second || top.height > second->height) {
      second = top;
    }
  }
  Top kept(double bin) const {
    const bool is_stray = second && first->height - second->height > bin;
    return is_stray ? *second : *first;
  }
};

// A ring of one bin, cut into cells.
struct Ring {
  std::vector<Highest> cells;
  std::vector<Top> tops;  // one of each cell that holds a particle
};

std::vector<Ring> rings_of(const std::vector<Top>& tops, const HeapInstrument& tool) {
  const double bin = tool.bin;
  std::vector<Ring> rings;
  for (const Top& top : tops) {
    const auto k = static_cast<std::size_t>(top.radius / bin);
    while (rings.size() <= k) {
      const double round = tool.plane
                               ? tool.plane->width / bin
                               : 2.0 * pi * (static_cast<double>(rings.size()) + 0.5);  // [bins]
      rings.emplace_back().cells.resize(
          static_cast<std::size_t>(std::max(1L, std::lround(round / cell_arc))));
    }
    auto& cells = rings[k].cells;
    const auto cell = static_cast<std::size_t>(top.turn * static_cast<double>(cells.size()));
    cells[std::min(cell, cells.size() - 1)].add(top);
  }
  for (Ring& ring : rings)
    for (const Highest& cell : ring.cells)
      if (cell.first) ring.tops.push_back(cell.kept(bin));
  return rings;
}

HeapRing mean_ring(const Ring& ring) {
  double radius = 0.0, height = 0.0, squares = 0.0;
  for (const Top& top : ring.tops) {
    radius += top.radius;
    height += top.height;
    squares += top.height * top.height;
  }
  const auto n = static_cast<double>(ring.tops.size());
  const double mean = height / n;
  return {radius / n, mean, std::sqrt(std::max(0.0, squares / n - mean * mean)), ring.tops.size()};
}

struct Line {
  double level = nan, slope = nan;  // [m] at the axis, [1] dz/dr
  std::size_t points = 0;
  double at(double r) const { return level + slope * r; }
};

class Fit {
 public:
  void add(double r, double z) {
    ++n_;
    r_ += r;
    z_ += z;
    rr_ += r * r;
    rz_ += r * z;
  }
  Line line() const {
    const auto n = static_cast<double>(n_);
    const double spread = n * rr_ - r_ * r_;
    if (n_ < 3 || !(spread > 0.0)) return {nan, nan, n_};
    const double slope = (n * rz_ - r_ * z_) / spread;
    return {(z_ - slope * r_) / n, slope, n_};
  }

 private:
  std::size_t n_ = 0;
  double r_ = 0.0, z_ = 0.0, rr_ = 0.0, rz_ = 0.0;
};

struct Window {
  double low, high;  // [m] of the radius
  bool holds(double r) const { return r >= low && r <= high; }
};

// To the tops within the window that lie near a line, again and again until they stay the same.
Line refit(Line line, const Window& window, const std::vector<Top>& tops, double bin) {
  for (int k = 0; k < most_fits && std::isfinite(line.slope); ++k) {
    Fit fit;
    for (const Top& top : tops)
      if (window.holds(top.radius) && std::abs(top.height - line.at(top.radius)) <= near_line * bin)
        fit.add(top.radius, top.height);
    const Line next = fit.line();
    if (next.slope == line.slope && next.level == line.level) break;
    line = next;
  }
  return line;
}

// Rings of the profile outside of its summit, from 0.8 down to 0.2 of its height.
std::vector<HeapRing> flank_of(const std::vector<HeapRing>& rings, double height) {
  std::size_t first = 0;
  while (first < rings.size() && rings[first].top < height) ++first;
  std::vector<HeapRing> flank;
  for (std::size_t k = first; k < rings.size() && rings[k].top >= flank_low * height; ++k)
    if (rings[k].top <= flank_high * height) flank.push_back(rings[k]);
  return flank;
}

// Standard deviation [rad] of the sectors' own angles, and how many have one.
struct Sectors {
  double deviation = nan, count = 0.0;
};
Sectors fit_sectors(const Line& line, const Window& window, const std::vector<Top>& tops,
                    const HeapInstrument& tool) {
  std::vector<std::vector<Top>> sectors(tool.sectors);
  for (const Top& top : tops) {
    const auto s = static_cast<std::size_t>(top.turn * static_cast<double>(tool.sectors));
    sectors[std::min<std::size_t>(s, tool.sectors - 1)].push_back(top);
  }
  double count = 0.0, sum = 0.0, squares = 0.0;
  for (const auto& own : sectors) {
    const double angle = std::atan(-refit(line, window, own, tool.bin).slope);
    if (!std::isfinite(angle)) continue;
    count += 1.0;
    sum += angle;
    squares += angle * angle;
  }
  if (count < 2.0) return {};
  return {std::sqrt(std::max(0.0, squares - sum * sum / count) / (count - 1.0)), count};
}

}  // namespace

std::optional<Heap> measure_heap(const Particles& particles, const HeapInstrument& tool) {
  std::vector<HeapRing> profile;
  std::vector<Top> tops;
  double height = 0.0;
  for (const Ring& ring : rings_of(tops_of(particles, tool), tool)) {
    if (static_cast<double>(ring.tops.size()) < filled * static_cast<double>(ring.cells.size()))
      break;
    profile.push_back(mean_ring(ring));
    tops.insert(tops.end(), ring.tops.begin(), ring.tops.end());
    height = std::max(height, profile.back().top);
  }
  Fit fit;
  for (const HeapRing& ring : flank_of(profile, height)) fit.add(ring.radius, ring.top);
  const Line first = fit.line();
  if (!(first.slope < 0.0)) return std::nullopt;
  const Window window{(flank_high * height - first.level) / first.slope,
                      (flank_low * height - first.level) / first.slope};
  const Line line = refit(first, window, tops, tool.bin);
  if (!(line.slope < 0.0)) return std::nullopt;
  const Sectors sectors = fit_sectors(line, window, tops, tool);
  return Heap{std::atan(-line.slope),
              sectors.deviation / std::sqrt(sectors.count),
              sectors.deviation,
              height,
              -line.level / line.slope,
              static_cast<double>(profile.size()) * tool.bin,
              profile.back().radius > tool.radius - tool.bin,
              profile};
}

}  // namespace pmr::instruments
