#include "physics/pair_kernel.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "physics/contact_law.hpp"
#include "pmr/base/random.hpp"

using namespace pmr;
using namespace pmr::physics;

namespace {

// Spheres in a crowd, every one paired with the next eight, some of which it overlaps; or with the
// next one alone, so that most are the first of one pair and the second of another in a group.
struct Crowd {
  static constexpr std::size_t spheres = 64;
  std::vector<double> sphere, kinetics, load = std::vector<double>(8 * spheres, 0.0);
  std::vector<PairGroup> groups;
  ContactLaw laws[2] = {{4e6, 1e7, 900.0, 1300.0, 0.3, 0.13},
                        {3e6, 9e6, 4000.0, 6000.0, 0.28, 0.38}};

  Crowd() {
    Random random(7, Purpose::test, 0);
    const auto between = [&](double low, double high) {
      return low + (high - low) * random.uniform();
    };
    for (std::uint32_t k = 0; k < spheres; ++k) {
      for (int axis = 0; axis < 3; ++axis) sphere.push_back(between(0.0, 4e-3));
      sphere.push_back(between(0.5e-3, 1.5e-3));
      for (int axis = 0; axis < 3; ++axis) kinetics.push_back(between(-1.0, 1.0));
      kinetics.push_back(between(1e4, 2e5));
      for (int axis = 0; axis < 3; ++axis) kinetics.push_back(between(-100.0, 100.0));
      kinetics.push_back(0.0);
    }
    for (std::uint32_t i = 0; i + PairGroup::count < spheres; ++i) {
      const bool is_chain = i % 7 == 3;
      PairGroup& g = groups.emplace_back();
      g.law = i % 2;
      g.used = i % 5 == 0 ? 0x3f : 0xff;
      g.touching = 0xff;
      g.own_i = i % 3 == 0 ? 0x0f : 0xff;
      g.own_j = 0xf7;
      for (std::uint32_t lane = 0; lane < PairGroup::count; ++lane) {
        g.i[lane] = PairGroup::index_step * (is_chain ? i + lane : i);
        g.j[lane] = PairGroup::index_step * (i + 1 + lane);
        for (int axis = 0; axis < 3; ++axis) {
          g.tangential[axis][lane] = between(-1e-6, 1e-6);
          g.rolling[axis][lane] = between(-1e-7, 1e-7);
        }
      }
    }
  }

  ContactBook evaluate(PairKernel kernel) {
    return kernel({.sphere = sphere.data(),
                   .kinetics = kinetics.data(),
                   .load = load.data(),
                   .first = 0,
                   .laws = laws,
                   .groups = groups.data(),
                   .group_count = groups.size(),
                   .dt = 2e-5});
  }
};

Triple<double> at(const std::vector<double>& list, std::size_t from) {
  return {list[from], list[from + 1], list[from + 2]};
}

// Each force law with each rolling law.
template <class... Force, class... Rolling>
std::vector<ContactModel> all_pairs(const std::variant<Force...>*,
                                    const std::variant<Rolling...>*) {
  std::vector<ContactModel> all;
  const auto add = [&](auto force) { (all.push_back({force, Rolling{}}), ...); };
  (add(Force{}), ...);
  return all;
}
std::vector<ContactModel> all_models() {
  return all_pairs(static_cast<const ForceLaw*>(nullptr), static_cast<const RollingLaw*>(nullptr));
}

}  // namespace

TEST_CASE("The pair kernel gives the law of a single pair, lane by lane") {
  const ContactModel model = GENERATE(from_range(all_models()));
  const SingleContact evaluate = single_contact(model);
  Crowd crowd;
  const Crowd before = crowd;
  crowd.evaluate(pair_kernel_avx2(places_of(model)));
  std::size_t touching = 0;
  std::vector<double> load(8 * Crowd::spheres, 0.0);
  for (std::size_t k = 0; k < crowd.groups.size(); ++k) {
    const PairGroup& g = before.groups[k];
    for (std::size_t lane = 0; lane < PairGroup::count; ++lane) {
      const std::size_t i = g.i[lane] / 8, j = g.j[lane] / 8;
      const Triple<double> d = at(before.sphere, 4 * i) - at(before.sphere, 4 * j);
      const double ri = before.sphere[4 * i + 3], rj = before.sphere[4 * j + 3];
      const double distance = std::sqrt(dot(d, d)), overlap = ri + rj - distance;
      const bool is_used = (g.used >> lane) & 1;
      CHECK(((crowd.groups[k].touching >> lane) & 1) == (is_used && overlap > 0.0));
      if (!is_used || overlap <= 0.0) continue;
      ++touching;
      const double arm_i = ri - 0.5 * overlap, arm_j = rj - 0.5 * overlap;
      const Triple<double> wi = at(before.kinetics, 8 * i + 4), wj = at(before.kinetics, 8 * j + 4);
      Springs<double> springs{{g.tangential[0][lane], g.tangential[1][lane], g.tangential[2][lane]},
                              {g.rolling[0][lane], g.rolling[1][lane], g.rolling[2][lane]}};
      const ContactForce<double> f = evaluate(
          before.laws[g.law],
          {(1.0 / distance) * d, overlap, at(before.kinetics, 8 * i) - at(before.kinetics, 8 * j),
           arm_i * wi + arm_j * wj, wi - wj, 1.0, ri * rj / (ri + rj),
           1.0 / (before.kinetics[8 * i + 3] + before.kinetics[8 * j + 3])},
          2e-5, springs);
      CHECK(crowd.groups[k].tangential[0][lane] == Approx(springs.tangential.x).epsilon(1e-10));
      CHECK(crowd.groups[k].rolling[1][lane] == Approx(springs.rolling.y).epsilon(1e-10));
      const auto add = [&](std::size_t to, double sign, double arm, double roll) {
        const double force[3] = {f.force.x, f.force.y, f.force.z};
        const double twist[3] = {f.twist.x, f.twist.y, f.twist.z};
        const double rolling[3] = {f.rolling.x, f.rolling.y, f.rolling.z};
        for (std::size_t a = 0; a < 3; ++a) {
          load[8 * to + a] += sign * force[a];
          load[8 * to + 4 + a] += roll * rolling[a] - arm * twist[a];
        }
      };
      if ((g.own_i >> lane) & 1) add(i, 1.0, arm_i, -1.0);
      if ((g.own_j >> lane) & 1) add(j, -1.0, arm_j, 1.0);
    }
  }
  CHECK(touching > 100);
  for (std::size_t k = 0; k < load.size(); ++k)
    CHECK(crowd.load[k] == Approx(load[k]).epsilon(1e-9).margin(1e-12));
}

// Hidden: a CTest entry of its own, which says that it was skipped.
TEST_CASE("Four lanes and eight lanes give the same bits", "[.][eight-lanes]") {
  const LawPair laws = places_of(GENERATE(from_range(all_models())));
  if (best_pair_kernel(laws) != pair_kernel_avx512(laws)) {
    WARN("skipped: this processor has no AVX-512");
    return;
  }
  Crowd four, eight;
  const ContactBook a = four.evaluate(pair_kernel_avx2(laws));
  const ContactBook b = eight.evaluate(pair_kernel_avx512(laws));
  CHECK(a.elastic == b.elastic);
  CHECK(a.overlap_ratio == b.overlap_ratio);
  CHECK(four.load == eight.load);
  for (std::size_t k = 0; k < four.groups.size(); ++k) {
    const PairGroup &of_four = four.groups[k], &of_eight = eight.groups[k];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CHECK(std::ranges::equal(of_four.tangential[axis], of_eight.tangential[axis]));
      CHECK(std::ranges::equal(of_four.rolling[axis], of_eight.rolling[axis]));
    }
    CHECK(of_four.touching == of_eight.touching);
  }
}
