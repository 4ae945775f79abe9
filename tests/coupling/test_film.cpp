// Which particles the gas over the bed reaches.
#include <algorithm>
#include <catch2/catch.hpp>

#include "coupling/heat_links.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;

namespace {

// A hundred spheres in a row along `up`, 2.1 mm apart; ids count upwards.
struct Row {
  Case setup{};
  State state;
  coupling::Nodes nodes;

  Row(const Vec3& up, const Vec3& gravity) {
    setup.gravity = gravity;
    setup.chamber = ChamberCase{};
    setup.chamber->closing = 1e9;
    setup.chamber->pressure = 1e5;
    setup.chamber->gas_temperature = 300.0;
    setup.chamber->film_coefficient = 10.0;
    Particles& p = state.particles;
    resize(p, 100);
    for (std::size_t i = 0; i < 100; ++i) {
      p.id[i] = static_cast<ParticleId>(i);
      p.radius[i] = 1e-3;
      p.position[i] = 2.1e-3 * static_cast<double>(i) * up;
    }
    nodes = coupling::number_nodes(setup, 100);
    state.phase = Phase::react;
  }
  // Ids of those that have a film; each of h pi R^2.
  std::vector<ParticleId> met() const {
    std::vector<ParticleId> ids;
    for (const auto& link : coupling::conduct(setup, nodes, state)) {
      CHECK(link.b == nodes.gas());
      CHECK(link.gap == Approx(10.0 * pi * 1e-6));
      ids.push_back(link.a);
    }
    return ids;
  }
};

}  // namespace

TEST_CASE("The film of gas lies over the bed's top along gravity, whatever axis that is") {
  for (const Vec3& up : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0.0, 0.8)}) {
    // The top is where 99 % of the centres do not rise above: the second but last of a hundred.
    const auto met = Row(up, -9.81 * up).met();
    CHECK(met == std::vector<ParticleId>{98, 99});
  }
}

TEST_CASE("Without gravity there is no top, and all particles meet the gas") {
  CHECK(Row(Vec3::UnitZ(), Vec3::Zero()).met().size() == 100);
}
