#include <catch2/catch.hpp>

#include "instruments/catching.hpp"
#include "pmr/base/constants.hpp"

using namespace pmr;
using namespace pmr::instruments;

namespace {

// Two level openings, one below the other, that face upwards; 10 mm squares from the origin.
Case two_openings() {
  Case c{};
  c.species.resize(2);
  const Vec3 x(10e-3, 0, 0), y(0, 10e-3, 0);
  c.catches = {{"high", Vec3(0, 0, 0), x, y, 2e-3, true},
               {"low", Vec3(0, 0, -5e-3), x, y, {}, false}};
  return c;
}

State at(double time, const std::vector<Vec3>& places) {
  State state;
  state.time = time;
  state.opening.particles = places.size();
  resize(state.particles, places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    state.particles.id[i] = static_cast<ParticleId>(places.size() - 1 - i);
    state.particles.species[i] = static_cast<SpeciesIndex>(i % 2);
    state.particles.mass[i] = 1e-3;
    state.particles.position[i] = places[i];
  }
  return state;
}

}  // namespace

TEST_CASE("What crosses an opening from its facing side is caught where and when it crossed") {
  const Case c = two_openings();
  const Vec3 middle(5e-3, 5e-3, 0), beside(15e-3, 5e-3, 0), up(0, 0, 1e-3);
  const State before = at(1.0, {middle + up, middle - up, beside + up, middle + 4.5 * up, middle});
  const State after =
      at(1.1, {middle - 3 * up, middle + up, beside - up, middle - 9 * up, middle + up});
  const auto caught = crossings(c, before, after);
  REQUIRE(caught.size() == 2);  // the others went up, passed beside, or stayed
  CHECK(caught[0].id == 4);
  CHECK(caught[0].time == Approx(1.025));
  CHECK(caught[0].position.z() == Approx(0.0).margin(1e-12));
  CHECK(caught[0].by == 0);
  CHECK(caught[1].id == 1);  // through both: the first has it
  CHECK(caught[1].by == 0);
  CHECK(caught[1].time == Approx(1.0 + 0.1 / 3.0));
}

TEST_CASE("Masses add up by opening and species, and a threshold lies between two arrivals") {
  const Case c = two_openings();
  State state;
  state.caught = {{0, 0, 0, 1.0, 1.5e-3, Vec3::Zero()},
                  {1, 1, 1, 1.5, 9.0e-3, Vec3::Zero()},
                  {2, 1, 0, 3.0, 1.0e-3, Vec3::Zero()},
                  {3, 1, 0, 4.0, 1.0e-3, Vec3::Zero()}};
  const auto all = caught_so_far(c, state);
  CHECK(all[0].mass == Approx(3.5e-3));
  CHECK(all[0].by_species[1] == Approx(2e-3));
  CHECK(all[1].mass == Approx(9e-3));
  REQUIRE(all[0].time_to_threshold);
  CHECK(*all[0].time_to_threshold == Approx(2.0));  // half a gram of the second arrival's
  CHECK_FALSE(all[1].time_to_threshold);
  CHECK(ends_motion(c, state));
  auto first = state;  // a threshold that the first arrival passes: nothing came before it
  first.caught = {{0, 0, 0, 1.0, 5e-3, Vec3::Zero()}};
  CHECK(*caught_so_far(c, first)[0].time_to_threshold == 1.0);
  state.caught.resize(2);
  CHECK_FALSE(ends_motion(c, state));
}
