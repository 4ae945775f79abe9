// Exchange factors G_ij = eps_i A_i D_ij between grey, diffuse, opaque surfaces in a transparent
// gas, by Monte Carlo ray tracing. D_ij is the part of what i emits that j absorbs, reflections
// included; the net heat is Q_ij = G_ij sigma (T_j^4 - T_i^4).
//
// A wall's back absorbs and reflects like its face but emits nothing: close what rays may see.
// Rays are dealt in proportion to eps_i A_i, so that all carry about the same power c and the mean
// of the two directions, G_ij = (c_i n_ij + c_j n_ji)/2, is close to the best estimate of the two;
// where an emitter has to send fewer (radiation/dealing.hpp) each direction weighs as 1/c.
// Then G_ij *= s_i s_j brings each row's sum to eps_i A_i. G stays symmetric bit by bit, so that an
// isothermal system exchanges exactly nothing, however few the rays.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pmr/base/stop.hpp"
#include "pmr/state/state.hpp"
#include "radiation/tracer.hpp"

namespace pmr::radiation {

struct ExchangeInput {
  std::span<const Sphere> spheres;
  std::span<const Triangle> triangles;
  std::vector<double> emissivity;  // [1] per node; 0 re-radiates all and takes no part itself
  std::vector<double> area;        // [m2] per node; the power emitted is eps A sigma T^4
  std::uint32_t nodes;             // number of nodes; the last is the surroundings
  double rays;                     // [1] of the sphere that emits least (no spheres: of the node)
  std::uint64_t seed;
  std::uint64_t step;  // tracings of one run are numbered: fresh rays each time
  // Per node, 1: of given temperature, absorbs and needs no rays of its own, like the surroundings;
  // empty: none.
  std::vector<char> reservoir = {};
  StopToken stop = {};
};

// Throws Stopped when asked to.
Exchange trace(const ExchangeInput& input);  // traced_at is the caller's to set

// The factors after emissivities have changed a little: each times s_i s_j, so that rows sum up to
// the new eps_i A_i [m2] (0 for nodes that do not emit of their own). Paths stay as they were
// traced: from 0.5 to 0.55 a bed's k_rad comes out 2 % high.
void rescale(std::vector<double> emissivity, const std::vector<double>& emission,
             Exchange& exchange);

// Where `rays` diffuse rays from one primitive land first, all being black: hits by node [nodes];
// those that leave the scene count for the last node.
std::vector<std::uint64_t> view_counts(const Tracer& tracer, std::uint32_t primitive,
                                       std::uint64_t rays, std::uint64_t seed, std::uint32_t nodes);

// Sum of each row [unit of the matrix].
std::vector<double> row_sums(const Csr& matrix);

}  // namespace pmr::radiation
