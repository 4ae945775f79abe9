// What a ray that leaves a sphere may meet first: in a dense bed nearly always one of the spheres
// around, found in a list of them, eight at a time, without a walk through a search tree.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "radiation/scene.hpp"
#include "radiation/sphere_grid.hpp"

namespace pmr::radiation {

// Lists every sphere and triangle that comes within a reach of each sphere's surface. A ray that
// starts on the sphere has come no farther from its surface than it has flown, so that the nearest
// hit within the list is the nearest of all if it is not farther than the reach. In single
// precision, relative to the sphere's centre: finer than the search tree, whose origin is far away.
class NearField {
 public:
  NearField(const Scene& scene, const SphereGrid& grid);

  // The first primitive that a ray meets which starts at `start` [m], on the surface of `sphere` or
  // just above it, in this direction [1], and its distance [m]; 0 where the start lies within that
  // primitive (the deepest, if there are several) or behind a wall that cuts the sphere. Nothing if
  // that cannot be told from the list.
  struct Meeting {
    std::uint32_t primitive;
    double distance;
  };
  std::optional<Meeting> first(std::uint32_t sphere, const Vec3& start,
                               const Vec3& direction) const;

 private:
  static constexpr std::size_t lanes = 8;
  // Spheres seen from the centre of the list's owner, in units of the scene.
  struct alignas(32) Packet {
    float x[lanes], y[lanes], z[lanes], radius[lanes];
    std::uint32_t sphere[lanes];
    float gap;  // of the nearest: packets stand in order of it
  };
  std::vector<Packet> packets_around(std::uint32_t sphere, const SphereGrid& grid) const;
  std::span<const Packet> packets(std::uint32_t sphere) const {
    return {packet_.data() + first_packet_[sphere], packet_.data() + first_packet_[sphere + 1]};
  }
  std::span<const std::uint32_t> walls(std::uint32_t sphere) const {
    return {wall_.data() + first_wall_[sphere], wall_.data() + first_wall_[sphere + 1]};
  }
  std::optional<Meeting> wall_within(std::uint32_t sphere, const Vec3& from, const Vec3& to) const;

  const Scene* scene_;
  double reach_;                                          // [m]
  std::vector<std::uint64_t> first_packet_, first_wall_;  // [spheres + 1]
  std::vector<Packet> packet_;
  std::vector<std::uint32_t> wall_;  // primitives, ascending
};

}  // namespace pmr::radiation
