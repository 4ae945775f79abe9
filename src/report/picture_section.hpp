// Which snapshots are shown, and on which scale: the same for one run and for a comparison.
#pragma once
#include <cstddef>
#include <vector>

#include "report/picture.hpp"
#include "report/run_data.hpp"

namespace pmr::report {

struct BedPictures {
  std::size_t settled = 0;                     // index of the snapshot of the bed come to rest
  std::vector<std::size_t> temperature_times;  // at most four, evenly over the log of time
  View view{};
};
BedPictures bed_pictures(const RunData& run);  // needs at least one snapshot

std::size_t nearest(const std::vector<double>& times, double t);  // index of the nearest time

Limits celsius_limits(Limits kelvin_range);  // [degC] round ones round [K]
Limits kelvin(Limits celsius);               // [K]

}  // namespace pmr::report
