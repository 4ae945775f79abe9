// `pmr render`: one picture as PNG, with its colour bar and the ends of its scale burnt in.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "pmr/base/errors.hpp"
#include "report/picture_html.hpp"
#include "report/picture_section.hpp"
#include "report/report.hpp"
#include "report/text.hpp"

namespace pmr::report {
namespace {

constexpr std::size_t picture_width = 900, bar_height = 18, foot_height = 64;  // [pixels]

// 5 x 7 letters, a row a byte from the top, bit 4 on the left.
struct Glyph {
  char letter;
  std::array<std::uint8_t, 7> rows;
};
constexpr Glyph glyphs[] = {
    {'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},
    {'2', {14, 17, 1, 6, 8, 16, 31}},    {'3', {31, 2, 4, 2, 1, 17, 14}},
    {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
    {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 8, 8, 8}},
    {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 2, 12}},
    {'.', {0, 0, 0, 0, 0, 12, 12}},      {'-', {0, 0, 0, 31, 0, 0, 0}},
    {'=', {0, 0, 31, 0, 31, 0, 0}},      {'C', {14, 17, 16, 16, 16, 17, 14}},
    {'d', {1, 1, 13, 19, 17, 17, 15}},   {'e', {0, 0, 14, 17, 31, 16, 14}},
    {'g', {0, 15, 17, 17, 15, 1, 14}},   {'l', {12, 4, 4, 4, 4, 4, 14}},
    {'t', {8, 8, 28, 8, 8, 9, 6}},       {'a', {0, 0, 14, 1, 15, 17, 15}},
    {'s', {0, 0, 15, 16, 14, 1, 30}},    {'m', {0, 0, 26, 21, 21, 17, 17}}};

void write(Image& image, std::size_t x, std::size_t y, std::string_view text) {
  constexpr std::size_t size = 2;  // [pixels] of a dot
  for (const char letter : text) {
    const auto* glyph = std::find_if(std::begin(glyphs), std::end(glyphs),
                                     [&](const Glyph& g) { return g.letter == letter; });
    for (std::size_t k = 0; glyph != std::end(glyphs) && k < 35 * size * size; ++k) {
      const std::size_t column = k % (5 * size), row = k / (5 * size);
      if ((glyph->rows[row / size] >> (4 - column / size) & 1) == 0) continue;
      if (x + column < image.width && y + row < image.height)
        std::fill_n(image.at(x + column, y + row), 3, std::uint8_t{40});
    }
    x += 6 * size;
  }
}

void paint_pixel(Image& image, std::size_t x, std::size_t y, const Rgb& colour) {
  for (std::size_t c = 0; c < 3; ++c)
    image.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(255.0 * colour[c]));
}

// The picture with room under it.
Image with_foot(const Image& picture) {
  Image image(picture.width, picture.height + foot_height, {255, 255, 255});
  std::copy(picture.rgb.begin(), picture.rgb.end(), image.rgb.begin());
  return image;
}

struct Scale {
  ColourMap map;
  Limits shown;      // in the unit of the label
  const char* unit;  // in letters that the font has
  int decimals;
};

std::string plain(double value, int decimals) {
  std::string text = fixed(value, decimals);
  if (text.rfind("\u2212", 0) == 0) text.replace(0, 3, "-");
  return text;
}

void burn_bar(Image& image, const Scale& scale) {
  const std::size_t left = 20, width = image.width / 2, top = image.height - foot_height + 12;
  for (std::size_t x = 0; x < width; ++x)
    for (std::size_t y = 0; y < bar_height; ++y)
      paint_pixel(image, left + x, top + y,
                  colour_at(scale.map, static_cast<double>(x) / static_cast<double>(width)));
  write(image, left, top + bar_height + 6, plain(scale.shown.low, scale.decimals));
  const std::string high = plain(scale.shown.high, scale.decimals) + " " + scale.unit;
  write(image, left + width - 12UL * 4, top + bar_height + 6, high);
}

Image temperature_picture(const io::Snapshot& snapshot, const RunData& run, const View& view) {
  const auto range = temperature_limits(snapshot);
  const Limits shown = celsius_limits(range.value_or(Limits{273.15, 373.15}));
  Image image = with_foot(
      draw(snapshot, run.setup, view, picture_width, paint_temperature(snapshot, kelvin(shown))));
  burn_bar(image, {ColourMap::inferno, shown, "degC", shown.high - shown.low < 5.0 ? 2 : 0});
  return image;
}

Image delta_picture(const io::Snapshot& snapshot, const RunData& run, const View& view) {
  const auto range = delta_limits(snapshot);
  if (!range) throw CaseError({{"--colour", "delta", "this run has no reactive particles"}});
  const Limits shown = round_limits(range->low, range->high);
  Image image =
      with_foot(draw(snapshot, run.setup, view, picture_width, paint_delta(snapshot, shown)));
  burn_bar(image, {ColourMap::viridis, shown, "delta", 3});
  return image;
}

Image species_picture(const io::Snapshot& snapshot, const RunData& run, const View& view) {
  Image image = with_foot(draw(snapshot, run.setup, view, picture_width, paint_species(snapshot)));
  for (std::size_t s = 0; s < run.header.species.size(); ++s)
    for (std::size_t k = 0; k < 60 * bar_height; ++k)
      paint_pixel(image, 20 + 80 * s + k % 60, image.height - foot_height + 12 + k / 60,
                  species_colour(s));
  return image;
}

}  // namespace

void render_picture(const std::filesystem::path& folder, std::optional<double> time, Colour colour,
                    const std::filesystem::path& png) {
  const RunData run = read_run(folder);
  if (run.snapshot_times.empty())
    throw CaseError({{folder.string(), "", "holds no snapshots to draw"}});
  const io::Snapshot snapshot =
      run.snapshot(nearest(run.snapshot_times, time.value_or(run.snapshot_times.back())));
  View view = look_at_cut(run.setup);
  frame(view, snapshot, 0.05);
  Image image = colour == Colour::temperature ? temperature_picture(snapshot, run, view)
                : colour == Colour::delta     ? delta_picture(snapshot, run, view)
                                              : species_picture(snapshot, run, view);
  write(image, image.width * 3 / 4, image.height - foot_height + 14,
        "t = " + plain(snapshot.time, 2) + " s");
  write_png(image, png);
}

}  // namespace pmr::report
