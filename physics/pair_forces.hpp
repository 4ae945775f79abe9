// The pair kernel's text, compiled once by each pair_kernel_*.cpp for its processor.
#pragma once
#include "physics/lanes.hpp"
#include "physics/pair_kernel.hpp"

namespace pmr::physics {
namespace {

using Vector = Triple<Lanes>;

// Position and radius, velocity and inverse mass, spin of the spheres index[lane].
struct Side {
  Lanes sphere[4], motion[4], spin[4];
};

[[gnu::always_inline]] inline void gather_spheres(const PairWork& work, const std::uint32_t* index,
                                                  Side& side) {
  // a sphere's index times index_step is half its place: counted in halves of a double
  const auto* const halves = reinterpret_cast<const float*>(work.sphere);
  gather([&](std::size_t l) { return reinterpret_cast<const double*>(halves + index[l]); },
         side.sphere);
}

[[gnu::always_inline]] inline void gather_kinetics(const PairWork& work, const std::uint32_t* index,
                                                   Side& side) {
  gather([&](std::size_t l) { return work.kinetics + index[l]; }, side.motion);
  gather([&](std::size_t l) { return work.kinetics + index[l] + 4; }, side.spin);
}

[[gnu::always_inline]] inline Vector vector(const Lanes (&record)[4]) {
  return {record[0], record[1], record[2]};
}

[[gnu::always_inline]] inline Vector load_vector(const double (&from)[3][PairGroup::count],
                                                 std::size_t lane) {
  return {load(&from[0][lane]), load(&from[1][lane]), load(&from[2][lane])};
}

[[gnu::always_inline]] inline void store_vector(double (&to)[3][PairGroup::count], std::size_t lane,
                                                Mask where, const Vector& v) {
  const Lanes zero{0.0};
  store(&to[0][lane], select(where, v.x, zero));
  store(&to[1][lane], select(where, v.y, zero));
  store(&to[2][lane], select(where, v.z, zero));
}

// A vector per lane, as records.
struct Records {
  alignas(64) double of_lane[Lanes::count][4];
  [[gnu::always_inline]] explicit Records(const Vector& v) {
    Lanes none{0.0};
    asm("" : "+v"(none.v));  // else GCC 12 with its thread sanitizer unpacks (z, z) for (z, 0)
    Lanes fields[4] = {v.x, v.y, v.z, none};
    store_records(of_lane[0], fields);
  }
};

[[gnu::always_inline]] inline void add(double* to, const double* record) {
  _mm256_storeu_pd(to, _mm256_add_pd(_mm256_loadu_pd(to), _mm256_load_pd(record)));
}
[[gnu::always_inline]] inline void subtract(double* to, const double* record) {
  _mm256_storeu_pd(to, _mm256_sub_pd(_mm256_loadu_pd(to), _mm256_load_pd(record)));
}

template <class Visit>
[[gnu::always_inline]] inline void for_each_bit(std::uint32_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(__builtin_ctz(bits)));
}

struct Sums {
  alignas(64) double elastic[PairGroup::count] = {};
  Lanes overlap_ratio{0.0};
};

// Lanes::count pairs of a group, from lane `from` on. Returns the bits of those that touch.
template <class Force, class Rolling>
[[gnu::always_inline]] inline std::uint32_t evaluate_lanes(const PairWork& work,
                                                           const LawOf<Lanes>& law,
                                                           PairGroup& group, std::size_t from,
                                                           Sums& sums) {
  constexpr std::uint32_t all = (1U << Lanes::count) - 1U;
  const std::uint32_t* const i = group.i + from;
  const std::uint32_t* const j = group.j + from;
  const auto bits_of = [&](std::uint8_t b) { return (std::uint32_t{b} >> from) & all; };
  const std::uint32_t own_i = bits_of(group.own_i), own_j = bits_of(group.own_j);
  const Lanes zero{0.0}, one{1.0}, half{0.5};

  Side a, b;
  gather_spheres(work, i, a);
  gather_spheres(work, j, b);
  const Vector d = vector(a.sphere) - vector(b.sphere);
  const Lanes &radius_i = a.sphere[3], &radius_j = b.sphere[3];
  const Lanes sum = radius_i + radius_j;
  const Lanes squared = dot(d, d);
  const Mask touches = (sum * sum > squared) & mask(bits_of(group.used));
  const std::uint32_t touching = bits(touches);
  if ((touching | bits_of(group.touching)) == 0) return 0;

  gather_kinetics(work, i, a);
  gather_kinetics(work, j, b);
  const Lanes distance = sqrt(squared);
  const Lanes overlap = max(sum - distance, zero);  // rounding may deny what the squares say
  const Lanes arm_i = radius_i - half * overlap, arm_j = radius_j - half * overlap;
  const Lanes inverse_mass = a.motion[3] + b.motion[3];
  const Lanes product = one / (distance * sum * inverse_mass);  // one division for three
  const Touch<Lanes> touch{product * sum * inverse_mass * d,
                           overlap,
                           vector(a.motion) - vector(b.motion),
                           plus(arm_i * vector(a.spin), arm_j, vector(b.spin)),
                           vector(a.spin) - vector(b.spin),
                           one,
                           radius_i * radius_j * (product * distance * inverse_mass),
                           product * distance * sum};
  Springs<Lanes> springs{load_vector(group.tangential, from), load_vector(group.rolling, from)};
  const ContactForce<Lanes> f = evaluate<Force, Rolling>(law, touch, Lanes{work.dt}, springs);
  store_vector(group.tangential, from, touches, springs.tangential);
  store_vector(group.rolling, from, touches, springs.rolling);

  const Records force(f.force);
  const Records less_torque_i(plus(f.rolling, arm_i, f.twist));
  const Records torque_j(minus(f.rolling, arm_j, f.twist));
  // Pair by pair: a sphere may be i of one lane and j of another, and sums must not depend on how
  // many lanes there are.
  for_each_bit(touching, [&](std::size_t l) {
    if ((own_i >> l & 1U) != 0) {
      double* const to = work.load + (i[l] - work.first);
      add(to, force.of_lane[l]);
      subtract(to + 4, less_torque_i.of_lane[l]);
    }
    if ((own_j >> l & 1U) != 0) {
      double* const to = work.load + (j[l] - work.first);
      subtract(to, force.of_lane[l]);
      add(to + 4, torque_j.of_lane[l]);
    }
  });
  const Mask counts = touches & mask(own_i);
  store(sums.elastic + from, load(sums.elastic + from) + select(counts, f.elastic, zero));
  const Lanes smaller = min(radius_i, radius_j);
  const Mask is_deepest = (overlap > sums.overlap_ratio * smaller) & touches;
  if (any(is_deepest))
    sums.overlap_ratio = select(is_deepest, overlap / smaller, sums.overlap_ratio);
  return touching;
}

[[gnu::always_inline]] inline LawOf<Lanes> on_all_lanes(const ContactLaw& law) {
  return {Lanes{law.normal},         Lanes{law.tangential},
          Lanes{law.normal_damping}, Lanes{law.tangential_damping},
          Lanes{law.friction},       Lanes{law.rolling_friction}};
}

template <class Force, class Rolling>
ContactBook pair_forces(const PairWork& work) {
  Sums sums;
  for (std::size_t g = 0; g < work.group_count; ++g) {
    PairGroup& group = work.groups[g];
    const LawOf<Lanes> law = on_all_lanes(work.laws[group.law]);
    std::uint32_t touching = 0;
    for (std::size_t from = 0; from < PairGroup::count; from += Lanes::count)
      touching |= evaluate_lanes<Force, Rolling>(work, law, group, from, sums) << from;
    group.touching = static_cast<std::uint8_t>(touching);
  }
  ContactBook book;
  for (const double e : sums.elastic) book.elastic += e;
  alignas(64) double ratio[Lanes::count];
  store(ratio, sums.overlap_ratio);
  for (const double r : ratio)
    if (r > book.overlap_ratio) book.overlap_ratio = r;
  return book;
}

// The kernels of a force law with each rolling law, in the order of their set.
template <class Force, class... Rolling>
PairKernel kernel_with(std::size_t rolling, const std::variant<Rolling...>*) {
  constexpr PairKernel kernels[] = {pair_forces<Force, Rolling>...};
  return kernels[rolling];
}

template <class... Force>
PairKernel kernel_of(LawPair laws, const std::variant<Force...>*) {
  using Choice = PairKernel (*)(std::size_t, const RollingLaw*);
  constexpr Choice choices[] = {kernel_with<Force>...};
  return choices[laws.force](laws.rolling, nullptr);
}

}  // namespace
}  // namespace pmr::physics
