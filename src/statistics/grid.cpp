#include "statistics/grid.hpp"

#include "pmr/base/errors.hpp"
#include "pmr/base/parallel.hpp"

namespace pmr::statistics {

Grid::Grid(std::vector<Span> spans, std::size_t steps)
    : spans_(std::move(spans)), steps_(steps), size_(1) {
  ensure(steps >= 2 && !spans_.empty(), "a grid has variables and two points along each");
  for (std::size_t k = 0; k < spans_.size(); ++k) size_ *= steps_;
}

std::vector<std::size_t> Grid::places(std::size_t index) const {
  std::vector<std::size_t> places(spans_.size());
  for (std::size_t k = spans_.size(); k-- > 0; index /= steps_) places[k] = index % steps_;
  return places;
}

std::vector<double> Grid::fractions(std::size_t index) const {
  std::vector<double> fractions;
  for (const std::size_t place : places(index))
    fractions.push_back(static_cast<double>(place) / static_cast<double>(steps_ - 1));
  return fractions;
}

std::vector<double> Grid::point(std::size_t index) const {
  std::vector<double> point = fractions(index);
  for (std::size_t k = 0; k < point.size(); ++k) point[k] = value_at(spans_[k], point[k]);
  return point;
}

bool Grid::is_on_edge(std::size_t index) const { return measure(index) < 1.0; }

double Grid::measure(std::size_t index) const {
  double measure = 1.0;
  for (const std::size_t place : places(index))
    if (place == 0 || place == steps_ - 1) measure *= 0.5;
  return measure;
}

// Points shifted by first .. 1 along each variable, the point itself among them.
std::vector<std::size_t> Grid::around(std::size_t index, int first) const {
  std::vector<std::size_t> found{0};
  for (const std::size_t place : places(index)) {
    std::vector<std::size_t> longer;
    for (const std::size_t start : found)
      for (int shift = first; shift <= 1; ++shift) {
        const auto moved = static_cast<std::ptrdiff_t>(place) + shift;
        if (moved >= 0 && moved < static_cast<std::ptrdiff_t>(steps_))
          longer.push_back(start * steps_ + static_cast<std::size_t>(moved));
      }
    found = std::move(longer);
  }
  return found;
}

std::vector<std::size_t> Grid::neighbours(std::size_t index) const {
  std::vector<std::size_t> found = around(index, -1);
  std::erase(found, index);
  return found;
}

std::vector<std::size_t> Grid::corners(std::size_t index) const {
  std::vector<std::size_t> found = around(index, 0);
  if (found.size() < std::size_t{1} << spans_.size()) found.clear();
  return found;
}

Field field_of(const Grid& grid, const Response& response) {
  Field field{std::vector<double>(grid.size()), std::vector<double>(grid.size())};
  parallel_for(
      grid.size(),
      [&](std::size_t i) {
        const Prediction there = response(grid.point(i));
        field.mean[i] = there.mean;
        field.deviation[i] = there.deviation;
      },
      256);
  return field;
}

}  // namespace pmr::statistics
