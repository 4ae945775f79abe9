#include <catch2/catch.hpp>
#include <fstream>

#include "report/picture.hpp"
#include "report/report.hpp"
#include "synthetic_run.hpp"

using namespace pmr;
using namespace pmr::report;

namespace {

std::uint32_t big_endian(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t k = 0; k < 4; ++k) word = (word << 8) | bytes.at(at + k);
  return word;
}

void check_png(const std::vector<std::uint8_t>& bytes, std::uint32_t width, std::uint32_t height) {
  // PNG specification: 8 bytes of signature, then IHDR with width and height.
  const std::vector<std::uint8_t> signature{0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a};
  REQUIRE(bytes.size() > 33);
  CHECK(std::equal(signature.begin(), signature.end(), bytes.begin()));
  CHECK(big_endian(bytes, 16) == width);
  CHECK(big_endian(bytes, 20) == height);
}

io::Snapshot one_sphere() {
  io::Snapshot snapshot;
  resize(snapshot.particles, 1);
  snapshot.particles.radius[0] = 1e-3;
  snapshot.particles.position[0] = Vec3(0, 1e-3, 0);
  return snapshot;
}

}  // namespace

TEST_CASE("A picture becomes a PNG of its size") {
  check_png(encode_png(Image(17, 9, {1, 2, 3})), 17, 9);
}

TEST_CASE("A sphere shows in its colour in the middle, and the sky at the corners") {
  const io::Snapshot snapshot = one_sphere();
  View view = look_at_cut(std::nullopt);
  frame(view, snapshot, 0.5);
  CHECK(view.width == Approx(4e-3));  // its diameter, and half of it on either side
  const Image image = draw(snapshot, std::nullopt, view, 64, paint_species(snapshot));
  const auto* middle = image.at(32, 32);
  CHECK(middle[0] > middle[2] + 50);  // orange
  CHECK(image.at(0, 0)[0] == image.at(63, 63)[0]);
  CHECK(image.at(0, 0)[0] > 240);
}

TEST_CASE("What lies before the cut is taken away") {
  io::Snapshot snapshot = one_sphere();
  View view = look_at_cut(std::nullopt);
  frame(view, snapshot, 0.5);
  snapshot.particles.position[0].y() = -1e-3;
  const Image image = draw(snapshot, std::nullopt, view, 64, paint_species(snapshot));
  CHECK(image.at(32, 32)[2] > 240);
}

TEST_CASE("A picture has a size where nothing, or nothing behind the cut, is left to frame") {
  io::Snapshot snapshot = one_sphere();
  snapshot.particles.position[0].y() = -1e-3;
  for (const io::Snapshot& shown : {snapshot, io::Snapshot{}}) {
    View view = look_at_cut(std::nullopt);
    frame(view, shown, 0.5);
    const Image image = draw(shown, std::nullopt, view, 64, paint_species(shown));
    CHECK(image.height == 64);
  }
}

TEST_CASE("Both signs of the cut's normal look the same way") {
  Case c;
  c.output.cut_point = Vec3::Zero();
  c.output.cut_normal = Vec3(0, -1, 0);
  const View a = look_at_cut(c);
  c.output.cut_normal = Vec3(0, 1, 0);
  const View b = look_at_cut(c);
  CHECK((a.forward - b.forward).norm() == 0.0);
  CHECK((a.right - Vec3::UnitX()).norm() < 1e-15);
}

TEST_CASE("The walls' section follows the chamber") {
  const RunData run = synthetic_run(60, "walls");
  const io::Snapshot last = run.snapshot(run.snapshot_times.size() - 1);
  View view = look_at_cut(run.setup);
  frame(view, last, 0.2);
  const auto lines = wall_section(run.setup, 1.0, view, 100.0);
  double left = 1e9, right = -1e9;
  for (const auto& line : lines)
    if (std::abs(line.x0 - line.x1) < 0.01 && line.y0 > -1e3) {
      left = std::min(left, line.x0);
      right = std::max(right, line.x0);
    }
  REQUIRE(lines.size() > 2);
  CHECK(left >= -1.0);
  CHECK(right > left);
}

TEST_CASE("A run folder renders to a PNG in every colour") {
  const auto folder = std::filesystem::temp_directory_path() / "pmr_test_render";
  write_folder(synthetic_run(120, "render"), folder);
  for (const Colour colour : {Colour::species, Colour::temperature, Colour::delta}) {
    const auto file = folder / "picture.png";
    render_picture(folder, 0.3, colour, file);
    std::ifstream in(file, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
    check_png(bytes, 900, big_endian(bytes, 20));
  }
  std::filesystem::remove_all(folder);
}
