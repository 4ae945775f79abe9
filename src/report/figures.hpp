// The figures a run is judged by, each with its verdict, and the sentences made from them.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "report/run_data.hpp"
#include "report/text.hpp"

namespace pmr::report {

enum class Verdict { plain, good, attention };

struct KeyFigure {
  std::string id;     // "granule_temperature", the same in every run
  std::string label;  // "Mean granule temperature at the end"
  Quantity quantity;
  double value;      // SI; NaN where it was looked for and not reached
  std::string note;  // its band or its limit, may be empty
  Verdict verdict = Verdict::plain;
};

inline constexpr double energy_limit = 1e-6;   // [1] of the heat and gas turned over
inline constexpr double oxygen_limit = 1e-7;   // [1] of the oxygen turned over
inline constexpr double overlap_limit = 0.05;  // [1] of the smaller radius
inline constexpr double biot_limit = 0.1;      // [1] above it a sphere is no longer isothermal

// Every figure the run can give, the most wanted first: the first six head the page.
std::vector<KeyFigure> key_figures(const RunData& run);

// When the granules were hottest on average; in runs with heat alone.
struct HottestMoment {
  double time, mean, spread;  // [s], [K], [K] standard deviation, NaN where not recorded
  bool is_rise;               // they had been cooler before
};
std::optional<HottestMoment> granules_hottest(const RunData& run);

// Sentences: what came of it, what was done, whether to believe it. HTML; none without particles.
std::vector<std::string> answer(const RunData& run);

// Whether a figure that wants attention is to be listed: limits of the models are told by the
// summary's own warnings, where it has them.
bool is_worth_listing(const KeyFigure& figure, const RunData& run);

std::string charge(const RunData& run);       // "1.00 kg Al2O3 at 1100 °C and ...", HTML
std::string chemical(std::string_view name);  // "SrFeO₃": digits set low
std::string names_of(const RunData& run, const std::vector<std::size_t>& species);  // "A and B"

}  // namespace pmr::report
