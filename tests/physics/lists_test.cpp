// Lists hold all that they must hold: against looking at everything.
#include <catch2/catch.hpp>
#include <set>

#include "mechanics_scene.hpp"
#include "physics/near_pairs.hpp"
#include "physics/wall_tree.hpp"
#include "physics/wide_list.hpp"
#include "pmr/base/random.hpp"

using namespace pmr;
using namespace pmr::physics;
using namespace pmr::test;

namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

// A cloud with sizes over a factor of ten and a hundredth of the particles far off.
Particles cloud(std::size_t n) {
  Particles p;
  Random random(3, Purpose::test, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    p.id.push_back(i);
    p.species.push_back(i % 2);
    p.radius.push_back(0.3e-3 + 2.7e-3 * std::pow(random.uniform(), 6));
    p.mass.push_back(1e-6);
    const double side = i % 100 == 0 ? 1.0 : 0.03;
    p.position.push_back(side * Vec3(random.uniform(), random.uniform(), random.uniform()));
    for (auto* v : {&p.velocity, &p.spin, &p.force, &p.torque}) v->push_back(Vec3::Zero());
  }
  return p;
}

Pairs by_looking(const Spheres& s, double skin) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < s.size(); ++i)
    for (std::uint32_t j = i + 1; j < s.size(); ++j) {
      const double reach = s.sphere[i].radius + s.sphere[j].radius + skin;
      if ((s.sphere[i].position - s.sphere[j].position).squaredNorm() < reach * reach)
        pairs.insert({i, j});
    }
  return pairs;
}

}  // namespace

TEST_CASE("Wide lists hold every pair within the skin, near pairs those within theirs") {
  Spheres s = gather_spheres(cloud(2500));
  const std::vector<Block> blocks = cut(s.size());
  bound(s, blocks);
  const WideSearch search(s, blocks);
  const double skin = 0.4e-3, thin = 0.1e-3;
  Pairs wide, near, touching;
  for (const Block& block : blocks) {
    std::vector<WideList> lists((block.size() + run_length - 1) / run_length);
    std::vector<NearRun> runs;
    for (std::uint32_t r = 0; r < lists.size(); ++r) {
      search.find(s, block.first / run_length + r, search.blocks_around(s, block.number, 2e-3),
                  skin, 2e-3, lists[r]);
      runs.push_back({&lists[r], thin});
    }
    for (std::uint32_t row = 0; row < block.size(); ++row)
      for (const std::uint32_t j : lists[row / run_length].row(row % run_length))
        wide.insert(std::minmax(block.first + row, j));
    for (const NearPair& pair : near_pairs(s, block, runs, 2)) {
      near.insert(std::minmax(pair.own, pair.partner));
      if (pair.kind % 2 == 0) touching.insert(std::minmax(pair.own, pair.partner));
    }
  }
  // those far apart share a run with others: searched in single precision over a box of 1 m
  const auto holds = [](const Pairs& all, const Pairs& some) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
  };
  CHECK(holds(wide, by_looking(s, skin)));
  CHECK(holds(by_looking(s, skin + 4e-6), wide));
  CHECK(near == by_looking(s, thin));
  CHECK(touching == by_looking(s, 0.0));
  CHECK(touching.size() > 1000);
}

TEST_CASE("While particles fly, touch and part, the state holds exactly the pairs that touch") {
  Case c = bare_case();
  add_can(c, 0.01);
  fill(c, 150, 600, 0.01, 0.0);
  State state = opened(c);
  for (Vec3& v : state.particles.velocity) v += Vec3(0.5, -0.3, 0.8);
  for (int k = 0; k < 6; ++k) {
    run(c, state, 250);
    CHECK(state.pair_contacts.partner.size() ==
          by_looking(gather_spheres(state.particles), 0.0).size());
  }
}

TEST_CASE("The wall tree finds every part within reach, on bodies that have moved") {
  Case c = bare_case();
  const std::uint32_t body = add_body(c, Translate{Vec3(0.1, 0.0, -0.05), 0.0, 1.0});
  for (int k = 0; k < 20; ++k)
    add_surface(
        c, rectangle(Vec3(0.01 * k, 0.003 * k, 0.0), Vec3(0.01, 0, 0.004), Vec3(0, 0.02, 0)), body);
  add_surface(c, Plane{Vec3(0, 0, -0.02), Vec3::UnitZ()}, body);
  const WallTree tree(c.walls);
  const std::vector<Pose> poses{pose(c.walls.bodies[body].motion, 0.4)};
  Random random(5, Purpose::test, 0);
  std::size_t found = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec3 x(0.25 * random.uniform(), 0.08 * random.uniform(), 0.06 * random.uniform() - 0.05);
    const double reach = 0.01 * random.uniform();
    std::set<std::uint32_t> near;
    for (const WallPart& part : tree.near(x, reach, poses)) near.insert(part.surface);
    for (std::uint32_t s = 0; s < c.walls.surfaces.size(); ++s) {
      const Vec3 at = poses[0].to_body(x);
      if ((closest_point(c.walls.surfaces[s].shape, at) - at).norm() > reach) continue;
      ++found;
      CHECK(near.count(s) == 1);
    }
  }
  CHECK(found > 50);
}
