#include <algorithm>
#include <numeric>

#include "io/run_file.hpp"
#include "io/state_members.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/hash.hpp"

namespace pmr::io {
namespace {

using Order = std::vector<std::size_t>;

// Places by ascending id: the order that does not depend on where particles stand today.
Order order_by_id(const Particles& particles) {
  Order order(particles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return particles.id[a] < particles.id[b]; });
  return order;
}

void add(Hash& hash, const Vec3& v) { hash.bytes(v.data(), 3 * sizeof(double)); }
template <class T>
requires std::is_scalar_v<T>
void add(Hash& hash, const T& value) { hash.add(value); }
template <class T>
void add(Hash& hash, const std::vector<T>& values) {
  hash.add(static_cast<std::uint64_t>(values.size()));
  hash.bytes(values.data(), values.size() * sizeof(T));
}

void add_particles(Hash& hash, const Particles& particles, const Order& order) {
  hash.add(static_cast<std::uint64_t>(particles.size()));
  for_each_field(particles, [&](const char*, const char*, const auto& field) {
    for (const std::size_t i : order) add(hash, field[i]);
  });
}

// A history without rows counts as one with empty rows: there is no contact in either.
void add_contacts(Hash& hash, const ContactHistory& history, const Order& order) {
  const bool has_rows = history.start.size() > 1;
  ensure(!has_rows || history.start.size() == order.size() + 1,
         "a contact history has a row for each particle");
  for (const std::size_t i : order) {
    const std::size_t first = has_rows ? history.start[i] : 0;
    const std::size_t last = has_rows ? history.start[i + 1] : 0;
    hash.add(static_cast<std::uint64_t>(last - first));
    for (std::size_t c = first; c < last; ++c) {
      hash.add(history.partner[c]);
      add(hash, history.tangential[c]);
      add(hash, history.rolling[c]);
    }
  }
}

void add_lost(Hash& hash, std::vector<LostParticle> lost) {
  std::sort(lost.begin(), lost.end(),
            [](const LostParticle& a, const LostParticle& b) { return a.id < b.id; });
  hash.add(static_cast<std::uint64_t>(lost.size()));
  for (const LostParticle& particle : lost) {
    hash.add(particle.id);
    hash.add(particle.time);
    add(hash, particle.position);
  }
}

// None is nothing: cases without openings that catch keep the hash that they had before those came.
void add_caught(Hash& hash, const std::vector<CaughtParticle>& caught) {
  for (const auto& [id, species, by, time, mass, position] : caught) {
    hash.add(id);
    hash.add(species);
    hash.add(by);
    hash.add(time);
    hash.add(mass);
    add(hash, position);
  }
}

}  // namespace

std::uint64_t state_hash(const State& state) {
  Hash hash;
  const Order order = order_by_id(state.particles);
  add_particles(hash, state.particles, order);
  if (state.waiting.size() > 0) add_particles(hash, state.waiting, order_by_id(state.waiting));
  add_contacts(hash, state.pair_contacts, order);
  add_contacts(hash, state.wall_contacts, order);
  for_each_ordered_field(
      state, [&](const std::string&, const char*, const auto& value) { add(hash, value); });
  add_lost(hash, state.lost);
  add_caught(hash, state.caught);
  return hash.value();
}

}  // namespace pmr::io
