// The one place that knows libpng.
#include <png.h>

#include <string>

#include "io/atomic_file.hpp"
#include "pmr/base/errors.hpp"
#include "report/image.hpp"

namespace pmr::report {

Image::Image(std::size_t w, std::size_t h, std::array<std::uint8_t, 3> background)
    : width(w), height(h), rgb(3 * w * h) {
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = background[i % 3];
}

std::vector<std::uint8_t> encode_png(const Image& image) {
  png_image format{};
  format.version = PNG_IMAGE_VERSION;
  format.width = static_cast<png_uint_32>(image.width);
  format.height = static_cast<png_uint_32>(image.height);
  format.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  const bool sized =
      png_image_write_to_memory(&format, nullptr, &size, 0, image.rgb.data(), 0, nullptr) != 0;
  ensure(sized, "libpng tells the size of an image");
  std::vector<std::uint8_t> bytes(size);
  const bool written =
      png_image_write_to_memory(&format, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) != 0;
  ensure(written, "libpng writes an image to memory");
  bytes.resize(size);
  return bytes;
}

void write_png(const Image& image, const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes = encode_png(image);
  io::replace_text(file, std::string(bytes.begin(), bytes.end()));
}

}  // namespace pmr::report
