// A layer of grains as it is glued to a flat face.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace pmr::physics {

// A flat face that is strewn: a rectangle of sides `size` from its corner, or a disc or ring about
// its centre.
struct Face {
  Eigen::Vector2d size{0, 0};        // [m] of a rectangle, else 0
  double radius = 0.0, inner = 0.0;  // [m] of a disc or ring
  double area() const;               // [m2]
};

// Densest layer that is made [1] of the face: discs of one size jam at random at 0.84; denser, and
// crystals grow.
inline constexpr double densest_layer = 0.78;

// Places [m] of grains of one diameter [m] that cover the area fraction [1] of the face, whole
// within it: strewn at random and pushed apart until none overlap by more than a fiftieth of the
// diameter; those that stay shut in between others are strewn again. None where that does not end.
// A function of (seed, key).
std::optional<std::vector<Eigen::Vector2d>> grain_layer(const Face& face, double diameter,
                                                        double area_fraction, std::uint64_t seed,
                                                        std::uint64_t key);

}  // namespace pmr::physics
