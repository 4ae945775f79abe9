// A regular grid over the box of some variables, and a response with its deviation on it.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "statistics/design.hpp"
#include "statistics/kriging.hpp"

namespace pmr::statistics {

// `steps` points along each variable, ends included, even in the fractions of its span; the last
// variable changes fastest.
class Grid {
 public:
  Grid(std::vector<Span> spans, std::size_t steps);

  std::size_t size() const { return size_; }
  std::size_t steps() const { return steps_; }
  const std::vector<Span>& spans() const { return spans_; }
  std::size_t dimension() const { return spans_.size(); }

  std::vector<std::size_t> places(std::size_t index) const;  // along each variable
  std::vector<double> fractions(std::size_t index) const;    // [1] of the spans
  std::vector<double> point(std::size_t index) const;        // in the variables' units
  bool is_on_edge(std::size_t index) const;
  // Share of the box that a point stands for, times the number of cells: half on a face [1].
  double measure(std::size_t index) const;
  // The points one step away at most along each variable, without the point itself.
  std::vector<std::size_t> neighbours(std::size_t index) const;
  // The corners of the cell above a point; none where the point is the last along a variable.
  std::vector<std::size_t> corners(std::size_t index) const;

 private:
  std::vector<std::size_t> around(std::size_t index, int first) const;

  std::vector<Span> spans_;
  std::size_t steps_, size_;
};

// A response at a point in the variables' units; may be asked from several threads.
using Response = std::function<Prediction(std::span<const double>)>;

struct Field {
  std::vector<double> mean, deviation;  // at each point of a grid [unit of the response]
};
Field field_of(const Grid& grid, const Response& response);

}  // namespace pmr::statistics
