#include "samples.hpp"

#include <unistd.h>

#include <cmath>
#include <limits>

namespace pmr::test {
namespace {

class Filler {
 public:
  explicit Filler(std::uint64_t seed) : random_(seed, Purpose::test, 0) {}

  void set(double& x) {
    x = std::ldexp(random_.uniform() - 0.5, static_cast<int>(random_.bits() % 600) - 300);
  }
  void set(Vec3& v) {
    for (double& x : v) set(x);
  }
  void set(std::uint8_t& x) { x = static_cast<std::uint8_t>(random_.bits()); }
  void set(std::uint32_t& x) { x = static_cast<std::uint32_t>(random_.bits()); }
  void set(std::uint64_t& x) { x = random_.bits(); }
  template <class T>
  void set(std::vector<T>& values, std::size_t count) {
    values.resize(count);
    for (T& value : values) set(value);
  }

 private:
  Random random_;
};

ContactHistory random_contacts(Filler& filler, std::size_t particles) {
  ContactHistory history;
  for (std::size_t i = 0; i < particles; ++i)
    history.start.push_back(history.start.back() + static_cast<std::uint32_t>(i % 3));
  filler.set(history.partner, history.start.back());
  filler.set(history.tangential, history.start.back());
  filler.set(history.rolling, history.start.back());
  return history;
}

Exchange random_exchange(Filler& filler, std::size_t nodes) {
  Exchange exchange;
  for (std::size_t i = 0; i < nodes; ++i)
    exchange.factor.start.push_back(exchange.factor.start.back() + i % 4);
  filler.set(exchange.factor.column, exchange.factor.start.back());
  filler.set(exchange.factor.value, exchange.factor.start.back());
  filler.set(exchange.self, nodes);
  filler.set(exchange.emissivity, nodes);
  filler.set(exchange.traced_emissivity, nodes);
  filler.set(exchange.traced_place, nodes);
  filler.set(exchange.rays);
  filler.set(exchange.relative_error);
  filler.set(exchange.row_sum_error);
  filler.set(exchange.unfinished);
  return exchange;  // traced_at stays at minus infinity
}

void fill_books(Filler& filler, State& state) {
  state.gas.closed = true;
  for (double* x : {&state.gas.oxygen, &state.gas.nitrogen, &state.gas.energy,
                    &state.opening.energy, &state.opening.oxygen, &state.opening.heat_content,
                    &state.extremes.overlap_ratio, &state.extremes.speed})
    filler.set(*x);
  filler.set(state.opening.particles);
  for (auto* values : {&state.gas.pore_volume, &state.gas.pore_oxygen, &state.gas.pore_nitrogen,
                       &state.gas.pore_energy, &state.trend.ln_pore_pressure})
    filler.set(*values, 3);
  for_each_flux(state.fluxes, [&](const char*, const char*, double& x) { filler.set(x); });
  state.breakdown = empty_breakdown({2});
  for_each_part(state.breakdown, [&](const char*, const char*, std::vector<double>& values) {
    for (double& x : values) filler.set(x);
  });
  filler.set(state.opening.species_energy, 2);
  filler.set(state.opening.species_oxygen, 2);
}

}  // namespace

unsigned long process_id() { return static_cast<unsigned long>(::getpid()); }

State random_state(std::size_t particles, std::uint64_t seed) {
  Filler filler(seed);
  State state;
  filler.set(state.time);
  state.phase = Phase::react;
  filler.set(state.step);
  filler.set(state.interval);
  filler.set(state.settled_at);
  filler.set(state.network_step);
  for_each_field(state.particles,
                 [&](const char*, const char*, auto& field) { filler.set(field, particles); });
  for (std::size_t i = 0; i < particles; ++i)
    state.particles.id[i] = static_cast<ParticleId>((i * 7 + 3) % (particles + 1));
  state.pair_contacts = random_contacts(filler, particles);
  state.wall_contacts = random_contacts(filler, particles);
  filler.set(state.walls.cell_energy, 17);
  filler.set(state.shells.enthalpy, 2 * particles);
  filler.set(state.shells.delta, 2 * particles);
  filler.set(state.trend.length);
  filler.set(state.trend.ln_pressure);
  filler.set(state.trend.warming, particles + 1);
  filler.set(state.trend.heating, 17);
  state.exchange = random_exchange(filler, particles + 5);
  fill_books(filler, state);
  state.lost = {{4, -0.25, Vec3(1.0, -0.0, 1e-310)}, {2, 0.5, Vec3(-3.0, 2.0, 1.0 / 3.0)}};
  return state;
}

io::Snapshot random_snapshot(double time, std::size_t particles) {
  State state = random_state(particles, 5 + particles);
  Random random(1, Purpose::test, particles);
  for (Vec3& v : state.particles.velocity) v = Vec3(0.5, -0.25, random.uniform());
  for (Vec3& v : state.particles.spin) v = Vec3(random.uniform(), 3.0, -1.0);
  for (double& h : state.particles.enthalpy) h = 100.0 * random.uniform();
  return {time, Phase::mix, state.particles, {300.0, 301.5, 1000.0 / 3.0}};
}

io::Series rows(double first, std::size_t count) {
  io::Series series{{{"time", "s", {}}, {"temperature_mean.SrFeO3", "K", {}}, {"zeta", "1", {}}}};
  for (std::size_t i = 0; i < count; ++i) {
    const double t = first + static_cast<double>(i);
    series.columns[0].values.push_back(t);
    series.columns[1].values.push_back(973.15 + t / 3.0);
    series.columns[2].values.push_back(std::numeric_limits<double>::infinity());
  }
  return series;
}

io::RunHeader header() {
  return {"title = \"Körner\"\n[phase]\n",
          {{"version", "0.1.0"}, {"git", ""}, {"case_hash", "00ff"}},
          {"Al2O3", "SrFeO3"},
          {"chamber.floor", "chamber.wall", "lid"}};
}

}  // namespace pmr::test
