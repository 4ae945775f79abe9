// Pictures as figures of the page: bitmap, walls, scale bar and time as one SVG; colour bars.
#pragma once
#include <string>
#include <vector>

#include "report/picture.hpp"

namespace pmr::report {

struct Shot {
  const io::Snapshot& snapshot;
  const std::optional<Case>& setup;
  const View& view;
  std::size_t pixels_x;  // [1]
  std::string caption;   // HTML
};
std::string shot_html(const Shot& shot, const Paint& paint);
std::string strip(const std::vector<std::string>& shots, const std::string& legend,
                  const std::string& title, const std::string& caption);

// A scale from limits.low to limits.high in the unit that is shown.
std::string colour_bar(ColourMap map, Limits limits, const std::string& label);
std::string species_legend(const std::vector<std::string>& names);
std::vector<double> round_ticks(Limits limits, int wanted);

}  // namespace pmr::report
