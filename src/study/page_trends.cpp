// In words: what each response does from one end of the variable to the other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/text.hpp"
#include "study/page_parts.hpp"

namespace pmr::study {
namespace {

constexpr std::size_t places = 61;  // [1] on the curve

struct Course {
  std::vector<double> x, y;
  double noise;  // of the curve's ends and turns, two deviations
};

Course course_of(const Findings& f, const Fit& fit) {
  Course c{abscissae(f, fit, 0, places), {}, 0.0};
  for (const double x : c.x) {
    const auto at = fit.surrogate.main_effect(0, x);
    c.y.push_back(at.mean);
    c.noise = std::max(c.noise, 2.0 * at.deviation);
  }
  return c;
}

std::string number(double value) { return report::significant(value, 3); }

// "rises from 0.1 to 0.3", with a turn between the ends where there is one beyond the noise.
std::string told(const Course& c, const std::string& unit, const std::string& x_unit) {
  const auto [low, high] = std::minmax_element(c.y.begin(), c.y.end());
  const double first = c.y.front(), last = c.y.back();
  const auto with = [&](double value) { return number(value) + (unit.empty() ? "" : " " + unit); };
  if (*high - *low <= c.noise || number(*low) == number(*high))
    return "does not change by more than its noise, near " + with(first);
  std::string text =
      fmt::format("{} from {} to {}", last > first ? "rises" : "falls", number(first), with(last));
  const auto turn = [&](std::vector<double>::const_iterator at, const char* word, double beyond) {
    if (beyond <= 0.5 * c.noise) return;
    const double x = c.x[static_cast<std::size_t>(at - c.y.begin())];
    text += fmt::format(", with its {}, {}, near {}{}", word, with(*at), number(x),
                        x_unit.empty() ? "" : " " + x_unit);
  };
  turn(low, "lowest", std::min(first, last) - *low);
  turn(high, "highest", *high - std::max(first, last));
  return text;
}

}  // namespace

std::string trends(const Findings& f) {
  if (f.numeric.size() != 1 || is_sampled(f.study)) return "";
  const Variable& variable = f.study.variables[f.numeric.front()];
  const std::string unit = unit_shown(variable.unit);
  const std::array<double, 2> ends = ends_of(f, f.numeric.front());
  const auto span = [&](const std::array<double, 2>& of) {
    return fmt::format("{} to {}{}{}", number(of[0]), number(of[1]), unit.empty() ? "" : " ", unit);
  };
  std::string items;
  for (const Fit& fit : f.fits) {
    if (!fit.surrogate.basis().why_constant.empty()) continue;
    const Response& response = f.study.responses[fit.response];
    const std::string& group = f.groups[fit.group].name;
    items += report::element(
        "li",
        report::escape(response.label + (group.empty() ? "" : " (" + group + ")") + " " +
                       told(course_of(f, fit), response.unit, unit) +
                       (fit.ends[0] == ends ? "" : " (from " + span(fit.ends[0]) + ")") + "."));
  }
  if (items.empty()) return "";
  const std::string head =
      fmt::format("From {} {}, by the fitted curves:", variable.label, span(ends));
  return report::element("p", report::escape(head)) + report::element("ul", items);
}

}  // namespace pmr::study
