// Several doubles side by side in one register: the reals of the pair kernel. `Lanes` is what the
// processor offers for which this is compiled: eight with AVX-512, else four with AVX2. Every
// operation is IEEE's own, so that results do not depend on the number of lanes.
#pragma once
#include <immintrin.h>

#include <cstddef>
#include <cstdint>

#if defined(__AVX512F__) && defined(__AVX512DQ__)
#define PMR_EIGHT_LANES 1
#endif

namespace pmr::physics {

#ifdef PMR_EIGHT_LANES
inline namespace eight_lanes {

struct Mask {
  __mmask8 m;
};
struct Lanes {
  static constexpr std::size_t count = 8;
  __m512d v;
  Lanes() = default;
  [[gnu::always_inline]] Lanes(__m512d x) : v(x) {}
  [[gnu::always_inline]] explicit Lanes(double x) : v(_mm512_set1_pd(x)) {}
};
#define PMR_LANES(operation) _mm512_##operation
[[gnu::always_inline]] inline Mask operator>(Lanes a, Lanes b) {
  return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)};
}
[[gnu::always_inline]] inline Mask operator&(Mask a, Mask b) {
  return {static_cast<__mmask8>(a.m & b.m)};
}
[[gnu::always_inline]] inline std::uint32_t bits(Mask a) { return a.m; }
[[gnu::always_inline]] inline Mask mask(std::uint32_t bits) {
  return {static_cast<__mmask8>(bits)};
}
[[gnu::always_inline]] inline Lanes select(Mask condition, Lanes yes, Lanes no) {
  return _mm512_mask_blend_pd(condition.m, no.v, yes.v);
}
[[gnu::always_inline]] inline Lanes abs(Lanes a) { return _mm512_abs_pd(a.v); }

#else
inline namespace four_lanes {

struct Mask {
  __m256d m;
};
struct Lanes {
  static constexpr std::size_t count = 4;
  __m256d v;
  Lanes() = default;
  [[gnu::always_inline]] Lanes(__m256d x) : v(x) {}
  [[gnu::always_inline]] explicit Lanes(double x) : v(_mm256_set1_pd(x)) {}
};
#define PMR_LANES(operation) _mm256_##operation
[[gnu::always_inline]] inline Mask operator>(Lanes a, Lanes b) {
  return {_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ)};
}
[[gnu::always_inline]] inline Mask operator&(Mask a, Mask b) { return {_mm256_and_pd(a.m, b.m)}; }
[[gnu::always_inline]] inline std::uint32_t bits(Mask a) {
  return static_cast<std::uint32_t>(_mm256_movemask_pd(a.m));
}
[[gnu::always_inline]] inline Mask mask(std::uint32_t bits) {
  const __m256i lane = _mm256_setr_epi64x(1, 2, 4, 8);
  const __m256i all = _mm256_set1_epi64x(static_cast<long long>(bits));
  return {_mm256_castsi256_pd(_mm256_cmpeq_epi64(_mm256_and_si256(all, lane), lane))};
}
[[gnu::always_inline]] inline Lanes select(Mask condition, Lanes yes, Lanes no) {
  return _mm256_blendv_pd(no.v, yes.v, condition.m);
}
[[gnu::always_inline]] inline Lanes abs(Lanes a) {
  return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v);
}

#endif

[[gnu::always_inline]] inline bool any(Mask a) { return bits(a) != 0; }
[[gnu::always_inline]] inline Lanes operator+(Lanes a, Lanes b) {
  return PMR_LANES(add_pd)(a.v, b.v);
}
[[gnu::always_inline]] inline Lanes operator-(Lanes a, Lanes b) {
  return PMR_LANES(sub_pd)(a.v, b.v);
}
[[gnu::always_inline]] inline Lanes operator*(Lanes a, Lanes b) {
  return PMR_LANES(mul_pd)(a.v, b.v);
}
// c + a b, c - a b, in one rounding
[[gnu::always_inline]] inline Lanes plus(Lanes c, Lanes a, Lanes b) {
  return PMR_LANES(fmadd_pd)(a.v, b.v, c.v);
}
[[gnu::always_inline]] inline Lanes minus(Lanes c, Lanes a, Lanes b) {
  return PMR_LANES(fnmadd_pd)(a.v, b.v, c.v);
}
[[gnu::always_inline]] inline Lanes operator/(Lanes a, Lanes b) {
  return PMR_LANES(div_pd)(a.v, b.v);
}
[[gnu::always_inline]] inline Lanes sqrt(Lanes a) { return PMR_LANES(sqrt_pd)(a.v); }
[[gnu::always_inline]] inline Lanes max(Lanes a, Lanes b) { return PMR_LANES(max_pd)(a.v, b.v); }
[[gnu::always_inline]] inline Lanes min(Lanes a, Lanes b) { return PMR_LANES(min_pd)(a.v, b.v); }
[[gnu::always_inline]] inline Lanes load(const double* p) { return PMR_LANES(loadu_pd)(p); }
[[gnu::always_inline]] inline void store(double* p, Lanes a) { PMR_LANES(storeu_pd)(p, a.v); }
#undef PMR_LANES

// Records are runs of four doubles; field f of the record of lane l is lane l of the f-th Lanes.
#ifdef PMR_EIGHT_LANES

// Turns four-by-four blocks: lanes 0-3 and 4-7 on their own.
[[gnu::always_inline]] inline void turn(Lanes (&a)[4]) {
  const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
  const __m512i second = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
  const __m512d low01 = _mm512_unpacklo_pd(a[0].v, a[1].v);
  const __m512d high01 = _mm512_unpackhi_pd(a[0].v, a[1].v);
  const __m512d low23 = _mm512_unpacklo_pd(a[2].v, a[3].v);
  const __m512d high23 = _mm512_unpackhi_pd(a[2].v, a[3].v);
  a[0] = _mm512_permutex2var_pd(low01, first, low23);
  a[1] = _mm512_permutex2var_pd(high01, first, high23);
  a[2] = _mm512_permutex2var_pd(low01, second, low23);
  a[3] = _mm512_permutex2var_pd(high01, second, high23);
}

// Loads the record at record(l) for each lane.
template <class Record>
[[gnu::always_inline]] inline void gather(const Record& record, Lanes (&out)[4]) {
  for (std::size_t l = 0; l < 4; ++l)
    out[l] = _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(record(l))),
                                _mm256_loadu_pd(record(l + 4)), 1);
  turn(out);
}

// Writes the lanes' records one behind the other.
[[gnu::always_inline]] inline void store_records(double* to, Lanes (&fields)[4]) {
  turn(fields);
  for (std::size_t l = 0; l < 4; ++l) {
    _mm256_store_pd(to + 4 * l, _mm512_castpd512_pd256(fields[l].v));
    _mm256_store_pd(to + 4 * (l + 4), _mm512_extractf64x4_pd(fields[l].v, 1));
  }
}

#else

[[gnu::always_inline]] inline void turn(Lanes (&a)[4]) {
  const __m256d low01 = _mm256_unpacklo_pd(a[0].v, a[1].v);
  const __m256d high01 = _mm256_unpackhi_pd(a[0].v, a[1].v);
  const __m256d low23 = _mm256_unpacklo_pd(a[2].v, a[3].v);
  const __m256d high23 = _mm256_unpackhi_pd(a[2].v, a[3].v);
  a[0] = _mm256_permute2f128_pd(low01, low23, 0x20);
  a[1] = _mm256_permute2f128_pd(high01, high23, 0x20);
  a[2] = _mm256_permute2f128_pd(low01, low23, 0x31);
  a[3] = _mm256_permute2f128_pd(high01, high23, 0x31);
}

template <class Record>
[[gnu::always_inline]] inline void gather(const Record& record, Lanes (&out)[4]) {
  for (std::size_t l = 0; l < 4; ++l) out[l] = _mm256_loadu_pd(record(l));
  turn(out);
}

[[gnu::always_inline]] inline void store_records(double* to, Lanes (&fields)[4]) {
  turn(fields);
  for (std::size_t l = 0; l < 4; ++l) _mm256_store_pd(to + 4 * l, fields[l].v);
}

#endif

}  // inline namespace
}  // namespace pmr::physics
