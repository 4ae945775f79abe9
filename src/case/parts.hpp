// Readers of the parts of a case, one function each.
#pragma once
#include <span>

#include "case/materials.hpp"
#include "case/reader.hpp"
#include "case/rig.hpp"
#include "chemistry/heat_curve.hpp"
#include "pmr/state/case.hpp"

namespace pmr::casefile {

// Of a particle or a gas: what the laws of heat are solved for.
inline constexpr Want a_state_temperature{
    Dimension::temperature,
    {chemistry::lowest_temperature, chemistry::highest_temperature, true, true}};

// species.cpp
// What the rest of the case says about where particles come from.
struct ParticleSetting {
  const std::optional<Rig>& rig;
  bool rig_is_faulty;
  bool has_bed;
  bool heat;    // temperatures matter
  bool reacts;  // delta changes
  std::uint64_t seed;
};
std::vector<Species> read_species(Table& root, MaterialBook& book, const ParticleSetting& setting);
std::vector<ExplicitParticle> read_particles(Table& root, std::span<const Species> species);
// Counts the explicit particles of species without a region.
void count_explicit(Table& root, Case& made);

// phases.cpp
std::optional<FillPhase> read_fill(Table& root);
std::optional<MixPhase> read_mix(Table& root);
std::optional<ReactPhase> read_react(Table& root);
std::optional<Decomposition> read_decomposition(Table& root);
std::vector<Thermocouple> read_thermocouples(Table& root);
std::optional<ConductivityInstrument> read_conductivity(Table& root, const Walls& walls);
OutputCase read_output(Table& root);

// gas_and_models.cpp
double read_closing(Table& root);  // [s] of the chamber; infinite without one
std::optional<ChamberCase> read_chamber(Table& root, const std::optional<Rig>& rig,
                                        bool rig_is_faulty);
Models read_models(Table& root);

}  // namespace pmr::casefile
