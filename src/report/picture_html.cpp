#include "report/picture_html.hpp"

#include <cmath>

#include "report/figures.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

std::string attribute(const char* name, double value) {
  // Attributes are for machines: a plain minus sign, two decimals.
  std::string number = std::to_string(std::round(100.0 * value) / 100.0);
  number.erase(number.find('.') + 3);
  return std::string(name) + "=\"" + number + "\" ";
}

// The longest of 1, 2 or 5 times a power of ten that is at most `length` [m].
double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  const double digit = length / power;
  return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

std::string scale_bar(const View& view, double pixels_x, double pixels_y) {
  const double length = round_length(0.3 * view.width);  // [m]
  const double pixels = length / view.width * pixels_x;
  const double x = pixels_x - pixels - 8.0, y = pixels_y + 16.0;
  const std::string bar = element("line", "",
                                  attribute("x1", x) + attribute("x2", x + pixels) +
                                      attribute("y1", y) + attribute("y2", y) + "class=\"scale\"");
  const std::string text =
      element("text", significant(1e3 * length, 1) + " mm",
              attribute("x", x - 8.0) + attribute("y", y + 6.0) + "text-anchor=\"end\"");
  return bar + text;
}

std::string walls_path(const std::vector<Line>& lines) {
  std::string path;
  for (const Line& l : lines) {
    const auto point = [](double x, double y) {
      return significant(x, 5) + " " + significant(y, 5);
    };
    std::string piece = "M" + point(l.x0, l.y0) + "L" + point(l.x1, l.y1);
    for (std::size_t k; (k = piece.find("\u2212")) != std::string::npos;) piece.replace(k, 3, "-");
    path += piece;
  }
  return element("path", "", "class=\"wall\" d=\"" + path + "\"");
}

std::string tick_text(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  return fixed(value, decimals);
}

}  // namespace

std::string shot_html(const Shot& shot, const Paint& paint) {
  const Image image = draw(shot.snapshot, shot.setup, shot.view, shot.pixels_x, paint);
  const auto width = static_cast<double>(image.width), height = static_cast<double>(image.height);
  const std::string bitmap =
      element("image", "",
              attribute("width", width) + attribute("height", height) +
                  "href=\"data:image/png;base64," + base64(encode_png(image)) + "\"");
  const auto walls = wall_section(shot.setup, shot.snapshot.time, shot.view, width);
  const std::string clip = element("svg", bitmap + walls_path(walls),
                                   attribute("width", width) + attribute("height", height));
  const std::string time =
      element("text", "t = " + with_unit(Quantity::time, shot.snapshot.time),
              attribute("x", 2.0) + attribute("y", height + 22.0) + "class=\"time\"");
  const std::string box = "viewBox=\"0 0 " + std::to_string(image.width) + " " +
                          std::to_string(image.height + 30) + "\" role=\"img\"";
  const std::string svg = element("svg", clip + time + scale_bar(shot.view, width, height), box);
  const std::string caption = shot.caption.empty() ? "" : element("figcaption", shot.caption);
  return element("figure", svg + caption, "class=\"shot\"");
}

std::string strip(const std::vector<std::string>& shots, const std::string& legend,
                  const std::string& title, const std::string& caption) {
  const std::size_t n = shots.size(), on_paper = n > 4 ? (n + 1) / 2 : n;  // in a row
  const std::string pictures = element("div", join(shots, ""),
                                       "class=\"shots\" style=\"--n:" + std::to_string(n) +
                                           ";--paper:" + std::to_string(on_paper) + "\"");
  const std::string below = caption.empty() ? "" : element("p", caption, "class=\"caption\"");
  return element("div", element("h3", title) + pictures + legend + below, "class=\"strip\"");
}

std::vector<double> round_ticks(Limits limits, int wanted) {
  const double rough = (limits.high - limits.low) / wanted;
  if (!(rough > 0.0)) return {limits.low};
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double digit = rough / power;
  const double step = power * (digit < 1.5 ? 1.0 : digit < 3.5 ? 2.0 : digit < 7.5 ? 5.0 : 10.0);
  std::vector<double> ticks;
  for (double k = std::ceil(limits.low / step - 1e-9); k * step <= limits.high + 1e-9 * step; ++k)
    ticks.push_back(k * step);
  return ticks;
}

std::string colour_bar(ColourMap map, Limits limits, const std::string& label) {
  // Same map, same gradient: bars may share it.
  const std::string id = map == ColourMap::viridis ? "viridis" : "inferno";
  std::string svg =
      element("defs", element("linearGradient", gradient_stops(map, 24), "id=\"" + id + "\""));
  svg +=
      element("rect", "", "x=\"10\" y=\"4\" width=\"400\" height=\"14\" fill=\"url(#" + id + ")\"");
  const std::vector<double> ticks =
      round_ticks(limits, limits.high - limits.low < 1e-3 * std::abs(limits.high) ? 2 : 5);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  for (const double tick : ticks) {
    const double x = 10.0 + 400.0 * limits.fraction(tick);
    svg += element("line", "",
                   attribute("x1", x) + attribute("x2", x) + "y1=\"18\" y2=\"23\" class=\"tick\"");
    svg += element("text", tick_text(tick, step),
                   attribute("x", x) + "y=\"36\" text-anchor=\"middle\"");
  }
  const std::string bar =
      element("svg", svg, "viewBox=\"-12 0 444 40\" class=\"bar\" role=\"img\"");
  return element("div", element("span", label) + bar, "class=\"legend\"");
}

std::string species_legend(const std::vector<std::string>& names) {
  std::string html;
  for (std::size_t s = 0; s < names.size(); ++s)
    html += element("span",
                    element("i", "", "style=\"background:" + hex(species_colour(s)) + "\"") +
                        escape(chemical(names[s])),
                    "class=\"key\"");
  return element("div", html, "class=\"legend\"");
}

}  // namespace pmr::report
