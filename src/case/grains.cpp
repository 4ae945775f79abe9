#include "case/grains.hpp"

#include <fmt/format.h>

#include "case/csv.hpp"
#include "physics/grain_layer.hpp"
#include "pmr/base/random.hpp"

namespace pmr::casefile {
namespace {

using physics::Face;

// A flat face and where its plane coordinates lie in the body's frame.
struct PlacedFace {
  Face face;
  Vec3 origin, x, y, normal;  // [m], [1] orthonormal
};

// A disc faces along its axis, a rectangle along its normal.
std::optional<PlacedFace> face_of(const GrainGround& ground) {
  if (ground.shapes.size() != 1) return std::nullopt;
  if (ground.kind == "disc") {
    const auto& disc = std::get<Revolved>(ground.shapes.front());
    const Vec3 x = disc.axis.unitOrthogonal();
    return PlacedFace{{{0, 0}, disc.r1, disc.r0}, disc.origin, x, disc.axis.cross(x), disc.axis};
  }
  if (ground.kind != "rectangle") return std::nullopt;
  const auto& corner = std::get<Facet>(ground.shapes.front()).triangles.front();
  const Vec3 along = corner[1] - corner[0], across = corner[2] - corner[1];
  return PlacedFace{{{along.norm(), across.norm()}},
                    corner[0],
                    along.normalized(),
                    across.normalized(),
                    along.cross(across).normalized()};
}

struct Layer {
  double diameter, area_fraction, height_deviation;  // [m], [1], [1] of the diameter
};

// Each stands on the face, higher or lower by up to the deviation. False where no such layer could
// be made.
bool strew(const PlacedFace& at, const Layer& layer, std::uint64_t seed, Grain grain,
           std::vector<Grain>& grains) {
  const auto places =
      physics::grain_layer(at.face, layer.diameter, layer.area_fraction, seed, grain.body);
  if (!places) return false;
  Random random(seed, Purpose::adhesion, grain.body, 1);
  for (const auto& place : *places) {
    const double height =
        layer.diameter * (0.5 + layer.height_deviation * (2.0 * random.uniform() - 1.0));
    grain.centre = at.origin + place[0] * at.x + place[1] * at.y + height * at.normal;
    grains.push_back(grain);
  }
  return true;
}

void read_layer(Table& table, const WallSetting& setting, const GrainGround& ground,
                const Grain& grain, std::vector<Grain>& grains) {
  const Layer layer{
      2.0 * grain.radius,
      table.value("area_fraction", {Dimension::none, {0.0, physics::densest_layer, true}}),
      table.value("height_deviation", {Dimension::none, {0.0, 0.5}})};
  const auto face = face_of(ground);
  if (!face && !ground.shapes.empty())
    table.fault("area_fraction", "wanted a wall of kind disc or rectangle; or grains from a csv");
  const bool is_read = layer.area_fraction > 0.0 && layer.area_fraction <= physics::densest_layer &&
                       layer.height_deviation >= 0.0;
  if (face && is_read && grain.radius > 0.0 && face->face.area() > 0.0 &&
      !strew(*face, layer, setting.seed, grain, grains))
    table.fault("area_fraction", "grains of this diameter do not fit on this face so densely");
}

void read_sheet(Table& table, const std::string& file, Grain grain, std::vector<Grain>& grains) {
  const auto columns = read_number_csv(
      table.reading(), file,
      {{"x", Dimension::length}, {"y", Dimension::length}, {"z", Dimension::length}});
  if (!columns) return;
  const auto& [x, y, z] = std::tie((*columns)[0], (*columns)[1], (*columns)[2]);
  if (x.empty() || y.size() != x.size() || z.size() != x.size()) {
    table.fault("csv", "wanted the columns x, y and z, with a grain at least");
    return;
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    grain.centre = Vec3(x[k], y[k], z[k]);
    grains.push_back(grain);
  }
}

}  // namespace

void read_grains(Table& wall, const WallSetting& setting, const GrainGround& ground,
                 std::vector<Grain>& grains) {
  const Node* node = wall.look_table("grains");
  if (node == nullptr) return;
  Table table(wall.reading(), *node, wall.path("grains"));
  if (wall.has("from") || wall.has("until"))
    wall.fault("grains", "adhere for the whole run: wanted a wall without from and until");
  Grain grain{ground.body, setting.book.use(table, "material", MaterialBook::Role::surface),
              0.5 * table.value("diameter", a_length), Vec3::Zero()};
  const std::string file = table.file_if_any("csv");
  if (!file.empty())
    read_sheet(table, file, grain, grains);
  else
    read_layer(table, setting, ground, grain, grains);
}

}  // namespace pmr::casefile
