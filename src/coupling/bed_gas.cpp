#include "coupling/bed_gas.hpp"

#include "chemistry/chamber.hpp"
#include "chemistry/gas.hpp"
#include "physics/porous_bed.hpp"
#include "physics/upright.hpp"
#include "pmr/base/constants.hpp"
#include "pmr/base/errors.hpp"

namespace pmr::coupling {
namespace {

// Of the gas at a particle's film [W/m/K], that of O2 at 1000 K (A): films are so good that the
// gas has the bed's temperature whatever stands here.
constexpr double film_conductivity = 0.07;

PoreLayer layer_of_bed(const physics::BedLayer& layer, double tortuosity) {
  const double porosity = layer.porosity();
  if (!(porosity > 0.0 && layer.sauter_diameter > 0.0))
    throw NumericsError("bed gas: a layer of the bed has no pores or no particles; take fewer");
  const double permeability = physics::carman_kozeny(layer.sauter_diameter, porosity);
  return {layer.area,
          layer.height,
          layer.pore_volume(),
          permeability,
          physics::capillary_radius(permeability, porosity, tortuosity),
          porosity / tortuosity,
          0.0};
}

}  // namespace

PoreSpace cut_pores(const Case& c, const Nodes& nodes, const State& state) {
  PoreSpace pores;
  const Particles& p = state.particles;
  if (!c.models.bed_gas || p.size() == 0) return pores;
  if (state.phase != Phase::react && state.phase != Phase::done) return pores;
  const BedGasModel& model = *c.models.bed_gas;
  const physics::LayeredBed bed = physics::cut_in_layers(
      p, model.layers, physics::up_against(c.gravity).value_or(Vec3::UnitZ()));
  for (const physics::BedLayer& layer : bed.layers)
    pores.layers.push_back(layer_of_bed(layer, model.tortuosity));
  pores.layer_of.assign(nodes.particles, 0);
  pores.share.assign(nodes.particles, 0.0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Node node = nodes.particle(p.id[i]);
    pores.layer_of[node] = bed.layer_of[i];
    pores.share[node] = 4.0 * pi * p.radius[i] * film_conductivity;  // [W/K] Nu 2: 2 pi d k
    pores.layers[bed.layer_of[i]].film += pores.share[node];
  }
  for (std::size_t node = 0; node < nodes.particles; ++node)
    if (pores.share[node] > 0.0) pores.share[node] /= pores.layers[pores.layer_of[node]].film;
  return pores;
}

void fill_pores(const Case& c, const Nodes& nodes, const PoreSpace& pores, State& state) {
  const std::size_t layers = pores.layers.size();
  std::vector<double> temperature(layers, 0.0);
  const Particles& p = state.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Node node = nodes.particle(p.id[i]);
    temperature[pores.layer_of[node]] += pores.share[node] * p.temperature[i];
  }
  Gas& gas = state.gas;
  gas.pore_volume.clear();
  for (std::size_t k = 0; k < layers; ++k) {
    ChamberCase air = *c.chamber;
    air.gas_temperature = temperature[k];
    const auto amount = chemistry::air_in(air, pores.layers[k].volume);
    gas.pore_volume.push_back(pores.layers[k].volume);
    gas.pore_oxygen.push_back(amount.oxygen);
    gas.pore_nitrogen.push_back(amount.nitrogen);
    gas.pore_energy.push_back(chemistry::internal_energy(amount, temperature[k]));
    state.fluxes.oxygen_closed_in += amount.oxygen;
    state.fluxes.nitrogen_closed_in += amount.nitrogen;
    state.fluxes.gas_energy_in += gas.pore_energy[k];
    state.fluxes.gas_turnover +=
        chemistry::total(amount) * chemistry::enthalpy_from_zero(temperature[k]);
  }
}

std::vector<Atmosphere> pore_atmospheres(const State& state) {
  const Gas& gas = state.gas;
  std::vector<Atmosphere> layers;
  for (std::size_t k = 0; k < gas.pore_volume.size(); ++k) {
    const chemistry::GasAmount amount{gas.pore_oxygen[k], gas.pore_nitrogen[k]};
    const double T = chemistry::gas_temperature(amount, gas.pore_energy[k], 1e3);
    layers.push_back({chemistry::gas_pressure(chemistry::total(amount), T, gas.pore_volume[k]),
                      chemistry::oxygen_fraction(amount), T});
  }
  return layers;
}

}  // namespace pmr::coupling
