#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "case/rig.hpp"
#include "helpers.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::test;
using Catch::Contains;

namespace {

Case demonstrator(const std::string& name, const std::vector<std::string>& sets = {}) {
  return casefile::load_case(PMR_SOURCE_DIR "/cases/" + name + ".toml", sets);
}

casefile::RigDimensions full_size() {
  const double degree = pi / 180;
  return {0.05, 0.2,   0.07, 0.06,  43 * degree, 0.526, 70 * degree, 0.09,  65 * degree, 0.08,
          0.8,  0.035, 0.3,  0.006, 0.0005,      0.03,  0.006,       0.045, 9.80665};
}

bool same_point(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-9; }

// Faces that have the edge a-b, run either way.
int faces_with_edge(const std::vector<casefile::Polygon>& faces, const Vec3& a, const Vec3& b) {
  int count = 0;
  for (const auto& face : faces)
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
      const Vec3& p = face.corners[k];
      const Vec3& q = face.corners[(k + 1) % face.corners.size()];
      count += (same_point(p, a) && same_point(q, b)) || (same_point(p, b) && same_point(q, a));
    }
  return count;
}

double area(const Facet& facet) {
  double sum = 0.0;
  for (const auto& t : facet.triangles)
    sum += 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).dot(facet.normal);
  return sum;
}

const Surface& surface(const Case& made, const std::string& name) {
  for (const Surface& one : made.walls.surfaces)
    if (one.name == name) return one;
  throw std::runtime_error("no surface " + name);
}

}  // namespace

TEST_CASE("the mixer is closed but for the spout's top") {
  const auto faces = casefile::mixer_faces(full_size());
  CHECK(faces.size() == 9);
  int open = 0;
  for (const auto& face : faces)
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
      const Vec3& a = face.corners[k];
      const Vec3& b = face.corners[(k + 1) % face.corners.size()];
      const int shared = faces_with_edge(faces, a, b);
      if (shared == 2) continue;
      CHECK(shared == 1);
      ++open;
      for (const Vec3& corner : {a, b}) {  // the spout square: +-35 mm at z = 260 mm
        CHECK(std::abs(corner.x()) == Approx(0.035).epsilon(1e-9));
        CHECK(std::abs(corner.y()) == Approx(0.035).epsilon(1e-9));
        CHECK(corner.z() == Approx(0.26).epsilon(1e-9));
      }
    }
  CHECK(open == 4);
}

TEST_CASE("every face of the mixer looks at its middle and closes by Gauss's theorem") {
  Vec3 sum = 0.07 * 0.07 * Vec3::UnitZ();  // the spout's top, inwards
  for (const auto& face : casefile::mixer_faces(full_size())) {
    const Facet facet = casefile::triangulated(face);
    CHECK(area(facet) > 0.0);
    CHECK((Vec3(0.1, 0, 0.6) - face.corners[0]).dot(face.normal) > 0.0);
    sum += area(facet) * face.normal;
  }
  CHECK(sum.norm() < 1e-12);
}

TEST_CASE("the roof lacks the tubes' holes and the lid the spout") {
  const Case made = demonstrator("demonstrator");
  const double hole = 64 * std::tan(pi / 64) * 0.035 * 0.035;  // polygon round the tube
  const auto& roof = std::get<Facet>(surface(made, "mixer.roof").shape);
  CHECK(area(roof) == Approx((0.576 + 0.09) * 0.16 - 2 * hole).epsilon(1e-12));
  const auto& lid = std::get<Facet>(surface(made, "chamber.lid").shape);
  CHECK(area(lid) == Approx(64 * std::tan(pi / 64) * 0.05 * 0.05 - 0.07 * 0.07).epsilon(1e-12));
  for (const auto* facet : {&roof, &lid})
    for (const auto& t : facet->triangles)
      CHECK((t[1] - t[0]).cross(t[2] - t[0]).z() < 0.0);  // all face down
  for (const auto& t : roof.triangles)  // nothing protrudes into a tube: edges stay outside it
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 middle = 0.5 * (t[k] + t[(k + 1) % 3]);
      for (const double x : {0.05, 0.5})
        CHECK(std::hypot(middle.x() - x, middle.y()) >= 0.035 * (1 - 1e-12));
    }
}

TEST_CASE("a closed plug leaves its clearance, and falls by its stroke") {
  const Case made = demonstrator("demonstrator");
  const auto& skirt = std::get<Revolved>(surface(made, "valve.SrFeO3.skirt").shape);
  CHECK(skirt.r0 == Approx(0.0345));
  CHECK(std::max(skirt.z0, skirt.z1) == Approx(0.847));
  const Body& body = made.walls.bodies.at(surface(made, "valve.SrFeO3.skirt").body);
  const auto& fall = std::get<Fall>(body.motion);
  CHECK(fall.release == Approx(0.125));
  CHECK(fall.stroke == Approx(0.045));
  CHECK(std::sqrt(2 * fall.stroke / fall.acceleration) == Approx(0.096).epsilon(0.005));
  const auto& region = std::get<CylinderRegion>(*made.species.at(0).region);
  CHECK(region.base.isApprox(Vec3(0.5, 0, 0.877)));
  CHECK(region.inner_radius == Approx(0.006));
}

TEST_CASE("everything above the chamber leaves when it is closed, and the door comes") {
  const Case made = demonstrator("demonstrator-small");
  for (const Surface& one : made.walls.surfaces) {
    const bool stays = one.name == "chamber.side" || one.name == "chamber.floor";
    CHECK(is_present(one, 20.0) == (stays || one.name == "chamber.door"));
    CHECK(is_present(one, 1.0) == (one.name != "chamber.door"));
  }
}

TEST_CASE("a scale multiplies every length of the rig") {
  const Case one = demonstrator("demonstrator-small");
  const Case two = demonstrator("demonstrator-small", {"rig.scale=2.0"});
  REQUIRE(one.walls.surfaces.size() == two.walls.surfaces.size());
  const auto& a = std::get<Facet>(surface(one, "mixer.ramp").shape);
  const auto& b = std::get<Facet>(surface(two, "mixer.ramp").shape);
  for (std::size_t k = 0; k < a.triangles.size(); ++k)
    CHECK(b.triangles[k][1].isApprox(2 * a.triangles[k][1], 1e-12));
  CHECK(two.domain_high.isApprox(2 * one.domain_high, 1e-12));
}

TEST_CASE("parts of a rig that do not fit each other are faults") {
  const auto faults = [](const std::string& set) {
    try {
      demonstrator("demonstrator", {set});
    } catch (const CaseError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  CHECK_THAT(faults("rig.valves.Al2O3.x=\"0.6 m\""), Contains("does not fit into the roof"));
  CHECK_THAT(faults("rig.valves.Al2O3.x=\"0.1 m\""), Contains("two tubes meet"));
  CHECK_THAT(faults("rig.spout_width=\"80 mm\""), Contains("stand out of the chamber"));
  CHECK_THAT(faults("rig.back_wall=\"1 m\""), Contains("the ramp reaches the roof"));
  CHECK_THAT(faults("rig.tube_length=\"60 mm\""), Contains("do not fit"));
}

TEST_CASE("each dimension of the rig is paper or assumed, with its source") {
  int paper = 0, assumed = 0;
  for (const Provenance& figure : demonstrator("demonstrator").provenance) {
    if (figure.key.rfind("rig.", 0) != 0 || figure.key == "rig.scale") continue;
    INFO(figure.key);
    if (figure.key.find("release") == std::string::npos)
      CHECK(figure.source != "given in the case");
    paper += figure.mark == 'P';
    assumed += figure.mark == 'A';
  }
  CHECK(paper == 2);  // the chamber's diameter and the delay
  CHECK(assumed >= 20);
}
