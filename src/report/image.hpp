// A picture of 8-bit colours. libpng stays in png.cpp.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace pmr::report {

struct Image {
  std::size_t width = 0, height = 0;  // [pixels]
  std::vector<std::uint8_t> rgb;      // rows from the top, 3 bytes a pixel

  Image() = default;
  Image(std::size_t w, std::size_t h, std::array<std::uint8_t, 3> background);
  std::uint8_t* at(std::size_t x, std::size_t y) { return rgb.data() + 3 * (y * width + x); }
  const std::uint8_t* at(std::size_t x, std::size_t y) const {
    return rgb.data() + 3 * (y * width + x);
  }
};

std::vector<std::uint8_t> encode_png(const Image& image);
void write_png(const Image& image, const std::filesystem::path& file);  // CaseError if it cannot

}  // namespace pmr::report
