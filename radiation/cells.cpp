#include "radiation/cells.hpp"

#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "radiation/geometry.hpp"

namespace pmr::radiation {
namespace {

constexpr double edge_in_units = 1.0;   // [1] of the scene's unit: a packet of spheres a cell
constexpr double most_a_sphere = 16.0;  // [1] cells: a few scattered spheres cost no millions
constexpr float nowhere = 1e15F;        // [edges] where unused lanes stand
constexpr int longest_walk = 64;        // [1] cells
constexpr int longest_void = 6;         // [1] empty cells in a row
constexpr float rounding = 1e-5F;       // [edges] of a place in single precision, with room
constexpr float infinity = std::numeric_limits<float>::infinity();

double squared_distance(const Vec3& point, const Vec3& middle, double half) {
  const Eigen::Array3d beyond = ((point - middle).array().abs() - half).max(0.0);
  return beyond.square().sum();
}

// Counts become places where each row begins.
void sum_up(std::vector<std::uint32_t>& start) {
  for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
}

}  // namespace

// A ray on its way through the cells.
struct Cells::Walk {
  Vec3 start, direction;
  Cell cell, step;
  Eigen::Array3d next, stride;  // [m] along the ray to the next border each way, and between them

  Walk(const Cells& cells, const Vec3& from, const Vec3& way)
      : start(from), direction(way), cell(cells.cell_of(from)) {
    for (int a = 0; a < 3; ++a) {
      step[a] = way[a] > 0.0 ? 1 : -1;
      const double border = cells.low_[a] + cells.edge_ * (cell[a] + (way[a] > 0.0 ? 1 : 0));
      const bool moves = way[a] != 0.0;
      const double per_way = moves ? 1.0 / way[a] : 0.0;
      next[a] = moves ? (border - from[a]) * per_way : std::numeric_limits<double>::infinity();
      stride[a] = cells.edge_ * std::abs(per_way);
    }
  }
  double leaves_at() const { return std::min(next[0], std::min(next[1], next[2])); }  // [m]
  void go_on() {
    const int a = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
    cell[a] += step[a];
    next[a] += stride[a];
  }
};

Cells::Cells(const Scene& scene) : scene_(&scene) {
  Eigen::AlignedBox3d box;
  for (const Sphere& s : scene.spheres()) {
    box.extend(Vec3(s.centre.array() - s.radius));
    box.extend(Vec3(s.centre.array() + s.radius));
  }
  edge_ = edge_in_units * scene.unit();
  if (!box.isEmpty()) {
    const double most = most_a_sphere * static_cast<double>(scene.spheres().size()) + 64.0;
    const auto cells = [&] { return (box.sizes().array() / edge_ + 1.0).floor().prod(); };
    while (cells() > most) edge_ *= 1.25;
    low_ = box.min();
    count_ = (box.sizes().array() / edge_ + 1.0).floor().cast<int>();
  }
  sort_spheres();
  sort_triangles();
  find_cut_spheres();
}

Cells::Cell Cells::cell_of(const Vec3& point) const {
  return ((point - low_) / edge_).array().floor().cast<int>();
}

std::size_t Cells::number(const Cell& cell) const {
  const auto wide = [](int k) { return static_cast<std::size_t>(k); };
  return (wide(cell.z()) * wide(count_.y()) + wide(cell.y())) * wide(count_.x()) + wide(cell.x());
}

template <class Visit>
void Cells::for_each_cell_of(const Sphere& sphere, const Visit& visit) const {
  const Vec3 reach = Vec3::Constant(sphere.radius);
  const Cell first = cell_of(sphere.centre - reach).max(0);
  const Cell last = cell_of(sphere.centre + reach).min(count_ - 1);
  const double within = sphere.radius + static_cast<double>(rounding) * edge_;
  for (int z = first.z(); z <= last.z(); ++z)
    for (int y = first.y(); y <= last.y(); ++y)
      for (int x = first.x(); x <= last.x(); ++x) {
        const Cell cell(x, y, z);
        if (squared_distance(sphere.centre, middle(cell), 0.5 * edge_) < within * within)
          visit(number(cell), middle(cell));
      }
}

template <class Visit>
void Cells::for_each_cell_of(const Triangle& triangle, const Visit& visit) const {
  Eigen::AlignedBox3d box;
  for (const Vec3& corner : triangle.corner) box.extend(corner);
  const double room = static_cast<double>(rounding) * edge_;
  const Cell first = cell_of(Vec3(box.min().array() - room)).max(0);
  const Cell last = cell_of(Vec3(box.max().array() + room)).min(count_ - 1);
  const Vec3 normal = normal_of(triangle);
  const double thick = 0.5 * edge_ * normal.cwiseAbs().sum() + room;  // [m] of a cell seen edge on
  for (int z = first.z(); z <= last.z(); ++z)
    for (int y = first.y(); y <= last.y(); ++y)
      for (int x = first.x(); x <= last.x(); ++x) {
        const Cell cell(x, y, z);
        if (std::abs(normal.dot(middle(cell) - triangle.corner[0])) < thick) visit(number(cell));
      }
}

// Counts, then fills: within a cell the spheres ascend.
void Cells::sort_spheres() {
  const auto cells = static_cast<std::size_t>(count_.prod());
  std::vector<std::uint32_t> found(cells, 0);
  for (const Sphere& s : scene_->spheres())
    for_each_cell_of(s, [&](std::size_t cell, const Vec3&) { ++found[cell]; });
  packet_start_.assign(cells + 1, 0);
  for (std::size_t k = 0; k < cells; ++k)
    packet_start_[k + 1] = (found[k] + static_cast<std::uint32_t>(lanes) - 1) / lanes;
  sum_up(packet_start_);
  Packet empty{};
  std::fill(std::begin(empty.x), std::end(empty.x), nowhere);
  std::fill(std::begin(empty.sphere), std::end(empty.sphere), none);
  packet_.assign(packet_start_.back(), empty);
  std::fill(found.begin(), found.end(), 0);
  for (std::uint32_t i = 0; i < scene_->spheres().size(); ++i) {
    const Sphere& s = scene_->spheres()[i];
    for_each_cell_of(s, [&](std::size_t cell, const Vec3& from) {
      const std::uint32_t k = found[cell]++;
      Packet& p = packet_[packet_start_[cell] + k / lanes];
      const Eigen::Vector3f at = ((s.centre - from) / edge_).cast<float>();
      p.x[k % lanes] = at.x();
      p.y[k % lanes] = at.y();
      p.z[k % lanes] = at.z();
      p.radius[k % lanes] = static_cast<float>(s.radius / edge_);
      p.sphere[k % lanes] = i;
    });
  }
}

void Cells::sort_triangles() {
  wall_start_.assign(static_cast<std::size_t>(count_.prod()) + 1, 0);
  for (const Triangle& t : scene_->triangles())
    for_each_cell_of(t, [&](std::size_t cell) { ++wall_start_[cell + 1]; });
  sum_up(wall_start_);
  wall_.resize(wall_start_.back());
  std::vector<std::uint32_t> next(wall_start_.begin(), wall_start_.end() - 1);
  auto primitive = static_cast<std::uint32_t>(scene_->spheres().size());
  for (const Triangle& t : scene_->triangles()) {
    for_each_cell_of(t, [&](std::size_t cell) { wall_[next[cell]++] = primitive; });
    ++primitive;
  }
}

void Cells::find_cut_spheres() {
  cut_start_.assign(1, 0);
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 0; i < scene_->spheres().size(); ++i) {
    const Sphere& s = scene_->spheres()[i];
    near.clear();
    for_each_cell_of(s, [&](std::size_t cell, const Vec3&) {
      near.insert(near.end(), wall_.begin() + wall_start_[cell],
                  wall_.begin() + wall_start_[cell + 1]);
    });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::erase_if(near, [&](std::uint32_t w) {
      return distance_to(scene_->triangle(w), s.centre) > 1.001 * s.radius;
    });
    if (near.empty()) continue;
    cut_sphere_.push_back(i);
    cut_wall_.insert(cut_wall_.end(), near.begin(), near.end());
    cut_start_.push_back(static_cast<std::uint32_t>(cut_wall_.size()));
  }
}

void Cells::meet_spheres(std::size_t cell, const Eigen::Vector3f& from,
                         const Eigen::Vector3f& direction, Nearest& nearest) const {
  const auto all = [](float a) { return _mm256_set1_ps(a); };
  const __m256 ox = all(from.x()), oy = all(from.y()), oz = all(from.z());
  const __m256 dx = all(direction.x()), dy = all(direction.y()), dz = all(direction.z());
  const __m256 zero = _mm256_setzero_ps();
  for (std::uint32_t k = packet_start_[cell]; k < packet_start_[cell + 1]; ++k) {
    const Packet& p = packet_[k];
    const __m256 x = _mm256_load_ps(p.x) - ox, y = _mm256_load_ps(p.y) - oy,
                 z = _mm256_load_ps(p.z) - oz, r = _mm256_load_ps(p.radius);
    const __m256 along = x * dx + y * dy + z * dz;
    const __m256 squared = x * x + y * y + z * z;
    const __m256 outside = squared - r * r;  // positive if the start lies outside
    // square of half the chord, from the ray's nearest point to the centre: grazing hits keep
    // digits
    const __m256 px = x - along * dx, py = y - along * dy, pz = z - along * dz;
    const __m256 inner = r * r - (px * px + py * py + pz * pz);
    const __m256 is_in = _mm256_cmp_ps(outside, zero, _CMP_LT_OQ);
    const __m256 is_ahead = _mm256_and_ps(_mm256_cmp_ps(inner, zero, _CMP_GE_OQ),
                                          _mm256_cmp_ps(along, zero, _CMP_GT_OQ));
    if (_mm256_movemask_ps(_mm256_or_ps(is_in, is_ahead)) == 0) continue;
    // distance, or minus the depth of a start within a sphere
    const __m256 ahead = along - _mm256_sqrt_ps(_mm256_max_ps(inner, zero));
    const __m256 distance = _mm256_blendv_ps(ahead, _mm256_sqrt_ps(squared) - r, is_in);
    const __m256 is_nearer = _mm256_and_ps(
        _mm256_or_ps(is_in, is_ahead), _mm256_cmp_ps(distance, all(nearest.distance), _CMP_LT_OQ));
    alignas(32) float of_lane[lanes];
    _mm256_store_ps(of_lane, distance);
    for (auto left = static_cast<unsigned>(_mm256_movemask_ps(is_nearer)); left != 0;
         left &= left - 1) {
      const auto l = static_cast<std::size_t>(__builtin_ctz(left));
      if (of_lane[l] < nearest.distance) nearest = {of_lane[l], p.sphere[l]};
    }
  }
}

void Cells::meet_walls(std::size_t cell, const Walk& walk, std::uint32_t left,
                       Nearest& nearest) const {
  for (std::uint32_t k = wall_start_[cell]; k < wall_start_[cell + 1]; ++k) {
    if (wall_[k] == left) continue;
    // as far as the cell goes: beyond, the next cell has it
    const double way = walk.leaves_at() + static_cast<double>(rounding) * edge_;
    const auto part =
        crossing(scene_->triangle(wall_[k]), walk.start, walk.start + way * walk.direction);
    if (!part) continue;
    const auto distance = static_cast<float>(*part * way / edge_);
    if (distance < nearest.distance) nearest = {distance, wall_[k]};
  }
}

std::optional<Cells::Meeting> Cells::first(const Vec3& start, const Vec3& direction,
                                           std::uint32_t left_triangle) const {
  Walk walk(*this, start, direction);
  const Eigen::Vector3f way = direction.cast<float>();
  const double per_edge = 1.0 / edge_;
  Nearest nearest{infinity, none};
  int empty = 0;
  for (int k = 0; k < longest_walk && empty < longest_void && holds(walk.cell); ++k) {
    const std::size_t cell = number(walk.cell);
    const Eigen::Vector3f from = (per_edge * (start - middle(walk.cell))).cast<float>();
    meet_spheres(cell, from, way, nearest);
    if (nearest.distance > 0.0F) meet_walls(cell, walk, left_triangle, nearest);
    if (nearest.distance <= static_cast<float>(walk.leaves_at() * per_edge) + rounding)
      return Meeting{nearest.primitive,
                     std::max(0.0, static_cast<double>(nearest.distance)) * edge_};
    empty = packet_start_[cell] == packet_start_[cell + 1] ? empty + 1 : 0;
    walk.go_on();
  }
  return std::nullopt;
}

std::uint32_t Cells::covering(const Vec3& point) const {
  const Cell at = cell_of(point);
  if (!holds(at)) return none;
  const std::size_t cell = number(at);
  std::uint32_t covers = none;
  double deepest = 0.0;  // [m]
  for (std::uint32_t k = packet_start_[cell]; k < packet_start_[cell + 1]; ++k)
    for (const std::uint32_t i : packet_[k].sphere) {
      if (i == none) break;
      const Sphere& sphere = scene_->spheres()[i];
      const double depth = sphere.radius - (point - sphere.centre).norm();
      if (depth <= deepest) continue;
      deepest = depth;
      covers = i;
    }
  return covers;
}

std::uint32_t Cells::wall_within(std::uint32_t sphere, const Vec3& point) const {
  const auto at = std::lower_bound(cut_sphere_.begin(), cut_sphere_.end(), sphere);
  if (at == cut_sphere_.end() || *at != sphere) return none;
  const auto row = static_cast<std::size_t>(at - cut_sphere_.begin());
  std::uint32_t first = none;
  double nearest = std::numeric_limits<double>::infinity();  // [1] of the way
  for (std::uint32_t k = cut_start_[row]; k < cut_start_[row + 1]; ++k) {
    const auto part =
        crossing(scene_->triangle(cut_wall_[k]), scene_->spheres()[sphere].centre, point);
    if (!part || *part >= nearest) continue;
    nearest = *part;
    first = cut_wall_[k];
  }
  return first;
}

}  // namespace pmr::radiation
