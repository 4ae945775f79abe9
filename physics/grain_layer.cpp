#include "physics/grain_layer.hpp"

#include <algorithm>
#include <cmath>

#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"

namespace pmr::physics {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr int most_sweeps = 5000;
constexpr double allowed_overlap = 0.02;  // [1] of the diameter
constexpr double overshoot = 1.02;        // [1] diameters that a push aims at

Vec2 clamped(const Face& face, double margin, const Vec2& x) {
  if (face.radius == 0.0)
    return x.cwiseMax(Vec2::Constant(margin)).cwiseMin(face.size - Vec2::Constant(margin));
  const double r = x.norm();
  const double low = face.inner > 0.0 ? face.inner + margin : 0.0;
  const double wanted = std::clamp(r, low, std::max(low, face.radius - margin));
  return r > 0.0 ? Vec2(wanted / r * x) : Vec2(wanted, 0.0);
}

Vec2 anywhere(const Face& face, Random& random) {
  const double u = random.uniform(), v = random.uniform();
  if (face.radius == 0.0) return {u * face.size[0], v * face.size[1]};
  const double inner = face.inner * face.inner;
  const double r = std::sqrt(inner + u * (face.radius * face.radius - inner));
  return {r * std::cos(2.0 * pi * v), r * std::sin(2.0 * pi * v)};
}

// Squares of a side, each with a chain of those whose centres lie in it.
class Squares {
 public:
  Squares(const std::vector<Vec2>& places, double side) : side_(side), next_(places.size(), none) {
    low_ = places.front();
    Vec2 high = low_;
    for (const Vec2& x : places) {
      low_ = low_.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    columns_ = static_cast<int>((high[0] - low_[0]) / side) + 1;
    rows_ = static_cast<int>((high[1] - low_[1]) / side) + 1;
    first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), none);
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      std::uint32_t& first = first_[number(column(places[i]), row(places[i]))];
      next_[i] = first;
      first = i;
    }
  }
  template <class Visit>
  void around(const Vec2& x, const Visit& visit) const {
    for (int r = std::max(0, row(x) - 1); r <= std::min(rows_ - 1, row(x) + 1); ++r)
      for (int c = std::max(0, column(x) - 1); c <= std::min(columns_ - 1, column(x) + 1); ++c)
        for (std::uint32_t j = first_[number(c, r)]; j != none; j = next_[j]) visit(j);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  int column(const Vec2& x) const {
    return std::clamp(static_cast<int>((x[0] - low_[0]) / side_), 0, columns_ - 1);
  }
  int row(const Vec2& x) const {
    return std::clamp(static_cast<int>((x[1] - low_[1]) / side_), 0, rows_ - 1);
  }
  std::size_t number(int c, int r) const {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(c);
  }
  double side_;
  Vec2 low_;
  int columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_, next_;  // [squares], [places]
};

// Pushes those apart that are too close, one after the other; the deepest overlap that it met [m].
// Squares are a half diameter wider than a push reaches, so that they hold while it goes on.
double push_apart(const Face& face, double diameter, std::vector<Vec2>& places) {
  const Squares squares(places, 1.5 * diameter);
  double deepest = 0.0;
  for (std::uint32_t i = 0; i < places.size(); ++i)
    squares.around(places[i], [&](std::uint32_t j) {
      if (j <= i) return;
      const Vec2 apart = places[i] - places[j];
      const double distance = apart.norm();
      if (distance >= diameter) return;
      deepest = std::max(deepest, diameter - distance);
      const Vec2 n = distance > 0.0 ? Vec2(apart / distance) : Vec2(1.0, 0.0);
      const Vec2 push = 0.5 * (overshoot * diameter - distance) * n;
      places[i] = clamped(face, 0.5 * diameter, places[i] + push);
      places[j] = clamped(face, 0.5 * diameter, places[j] - push);
    });
  return deepest;
}

}  // namespace

double Face::area() const {
  return radius == 0.0 ? size[0] * size[1] : pi * (radius * radius - inner * inner);
}

std::vector<Vec2> grain_layer(const Face& face, double diameter, double area_fraction,
                              std::uint64_t seed, std::uint64_t key) {
  const double count = area_fraction * face.area() / (pi / 4.0 * diameter * diameter);
  Random random(seed, Purpose::adhesion, key);
  std::vector<Vec2> places;
  for (long k = 0; k < std::lround(count); ++k)
    places.push_back(clamped(face, 0.5 * diameter, anywhere(face, random)));
  if (places.size() < 2) return places;
  for (int sweep = 0; sweep < most_sweeps; ++sweep)
    if (push_apart(face, diameter, places) <= allowed_overlap * diameter) break;
  return places;
}

}  // namespace pmr::physics
