#include "physics/grain_layer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pmr/base/constants.hpp"
#include "pmr/base/random.hpp"

namespace pmr::physics {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr int patience = 300;  // sweeps until a grain that is shut in is strewn again
constexpr int most_sweeps = 100 * patience;
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

// Grains that are pushed apart, sweep by sweep. Only pairs of which one has just moved can have
// come too close.
class Crowd {
 public:
  Crowd(const Face& face, double diameter, std::vector<Vec2> strewn)
      : places(std::move(strewn)), face_(face), diameter_(diameter), moved_(places.size(), true) {}

  // Pushes those apart that overlap by more than is allowed, one after the other. Squares are a
  // half diameter wider than a push reaches, so that they hold while it goes on.
  void sweep() {
    deepest = 0.0;
    const Squares squares(places, 1.5 * diameter_);
    const std::vector<bool> were_moved = std::exchange(moved_, std::vector<bool>(places.size()));
    for (std::uint32_t i = 0; i < places.size(); ++i)
      if (were_moved[i])
        squares.around(places[i], [&](std::uint32_t j) {
          if (j != i && (j > i || !were_moved[j])) push(i, j);
        });
  }
  void move(std::uint32_t i, const Vec2& to) {
    places[i] = clamped(face_, 0.5 * diameter_, to);
    moved_[i] = true;
  }

  std::vector<Vec2> places;         // [m]
  double deepest = 0.0;             // [m] overlap that the last sweep pushed apart ...
  std::uint32_t deepest_grain = 0;  // ... and a grain that had it

 private:
  void push(std::uint32_t i, std::uint32_t j) {
    const Vec2 apart = places[i] - places[j];
    const double distance = apart.norm();
    if (distance >= (1.0 - allowed_overlap) * diameter_) return;
    if (diameter_ - distance > deepest) {
      deepest = diameter_ - distance;
      deepest_grain = i;
    }
    const Vec2 n = distance > 0.0 ? Vec2(apart / distance) : Vec2(1.0, 0.0);
    const Vec2 push = 0.5 * (overshoot * diameter_ - distance) * n;
    move(i, places[i] + push);
    move(j, places[j] - push);
  }

  Face face_;
  double diameter_;          // [m]
  std::vector<bool> moved_;  // in this sweep, or since
};

}  // namespace

double Face::area() const {
  return radius == 0.0 ? size[0] * size[1] : pi * (radius * radius - inner * inner);
}

std::optional<std::vector<Vec2>> grain_layer(const Face& face, double diameter,
                                             double area_fraction, std::uint64_t seed,
                                             std::uint64_t key) {
  const double count = area_fraction * face.area() / (pi / 4.0 * diameter * diameter);
  Random random(seed, Purpose::adhesion, key);
  std::vector<Vec2> strewn;
  for (long k = 0; k < std::lround(count); ++k)
    strewn.push_back(clamped(face, 0.5 * diameter, anywhere(face, random)));
  if (strewn.size() < 2) return strewn;
  Crowd crowd(face, diameter, std::move(strewn));
  for (int sweep = 1; sweep <= most_sweeps; ++sweep) {
    crowd.sweep();
    if (crowd.deepest == 0.0) return std::move(crowd.places);
    if (sweep % patience == 0) crowd.move(crowd.deepest_grain, anywhere(face, random));
  }
  return std::nullopt;
}

}  // namespace pmr::physics
