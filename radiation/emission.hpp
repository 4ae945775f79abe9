// Who emits how many rays, and from where.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "radiation/sampling.hpp"
#include "radiation/tracer.hpp"

namespace pmr::radiation {

// The primitives of each node, with running sums of their areas.
class Emitters {
 public:
  Emitters(const Scene& scene, std::uint32_t nodes);
  bool has_surface(std::uint32_t node) const { return start_[node + 1] > start_[node]; }
  // Nodes that have a surface, as their first primitives follow each other: neighbours in space, if
  // those are.
  std::vector<std::uint32_t> in_order() const;
  // The sphere that is all of the node's surface, if it is one.
  std::optional<std::uint32_t> only_sphere(const Scene& scene, std::uint32_t node) const;
  // The primitive at a fraction in [0, 1) of the node's area.
  std::uint32_t pick(std::uint32_t node, double fraction) const;

 private:
  std::vector<std::uint64_t> start_;      // [nodes + 1]
  std::vector<std::uint32_t> primitive_;  // by node, ascending within each
  std::vector<double> area_until_;        // [m2] running sum within the node
};

// Diffuse departure from a primitive's facing side, from four numbers in [0, 1).
Departure emit(const Scene& scene, std::uint32_t primitive, const std::array<double, 4>& u);

// One of eight departures from a sphere.
Departure departure_of(const Scene& scene, std::uint32_t sphere, const SphereDepartures& eight,
                       int lane);

}  // namespace pmr::radiation
