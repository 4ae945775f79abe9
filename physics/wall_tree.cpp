#include "physics/wall_tree.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace pmr::physics {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Bounds = bg::model::box<Point>;
struct Entry {
  Bounds bounds;
  WallPart part;
  const Shape* shape;  // slanting triangles have boxes that say little
};
struct BoundsOf {
  using result_type = const Bounds&;
  const Bounds& operator()(const Entry& e) const { return e.bounds; }
};
using Tree = bg::index::rtree<Entry, bg::index::rstar<16>, BoundsOf>;

Bounds bounds(const Box& box) {
  return {Point(box.low[0], box.low[1], box.low[2]), Point(box.high[0], box.high[1], box.high[2])};
}

struct Endless {
  Plane plane;
  WallPart part;
  std::uint32_t body;
};

// Puts a surface where it is found again: endless shapes into a list, others into its body's tree,
// facets triangle by triangle.
struct Sorter {
  const Surface& surface;
  std::uint32_t index;
  std::vector<Endless>& endless;
  std::vector<Entry>& parts;

  void operator()(const Plane& plane) const {
    endless.push_back({plane, {index, WallPart::whole}, surface.body});
  }
  void operator()(const Revolved&) const {
    parts.push_back(
        {bounds(bounding_box(surface.shape)), {index, WallPart::whole}, &surface.shape});
  }
  void operator()(const Facet& facet) const {
    for (std::uint32_t t = 0; t < facet.triangles.size(); ++t) {
      const auto& [a, b, c] = facet.triangles[t];
      const Box box{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
      parts.push_back({bounds(box), {index, t}, &surface.shape});
    }
  }
};

}  // namespace

struct WallTree::Trees {
  std::vector<Tree> of_body;
  std::vector<Endless> endless;
};

WallTree::WallTree(const Walls& walls) : trees_(std::make_unique<Trees>()) {
  std::vector<std::vector<Entry>> parts(walls.bodies.size());
  for (std::uint32_t s = 0; s < walls.surfaces.size(); ++s) {
    const Surface& surface = walls.surfaces[s];
    if (!surface.holds_particles) continue;
    std::visit(Sorter{surface, s, trees_->endless, parts[surface.body]}, surface.shape);
  }
  for (const auto& list : parts) trees_->of_body.emplace_back(list.begin(), list.end());
}

WallTree::~WallTree() = default;

std::vector<WallPart> WallTree::near(const Vec3& x, double reach,
                                     const std::vector<Pose>& poses) const {
  std::vector<WallPart> found;
  for (const auto& [plane, part, body] : trees_->endless)
    if (!is_surely_beyond(plane, poses[body].to_body(x), reach)) found.push_back(part);
  for (std::size_t b = 0; b < poses.size(); ++b) {
    const Tree& tree = trees_->of_body[b];
    if (tree.empty()) continue;
    const Vec3 at = poses[b].to_body(x), half = Vec3::Constant(reach);
    const auto hits = bg::index::intersects(bounds({at - half, at + half}));
    for (auto hit = tree.qbegin(hits); hit != tree.qend(); ++hit)
      if (!is_surely_beyond(*hit->shape, at, reach)) found.push_back(hit->part);
  }
  std::sort(found.begin(), found.end(), [](const WallPart& p, const WallPart& q) {
    return p.surface != q.surface ? p.surface < q.surface : p.triangle < q.triangle;
  });
  return found;
}

}  // namespace pmr::physics
