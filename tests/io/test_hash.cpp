// The state hash pins a state, not the order in which its particles stand today.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "io/state_members.hpp"
#include "samples.hpp"

using namespace pmr;

namespace {

ContactHistory reversed(const ContactHistory& old, std::size_t rows) {
  ContactHistory history;
  for (std::size_t i = rows; i-- > 0;) {
    for (std::size_t c = old.start[i]; c < old.start[i + 1]; ++c) {
      history.partner.push_back(old.partner[c]);
      history.tangential.push_back(old.tangential[c]);
      history.rolling.push_back(old.rolling[c]);
    }
    history.start.push_back(static_cast<std::uint32_t>(history.partner.size()));
  }
  return history;
}

State with_reversed_order(State state) {
  const std::size_t count = state.particles.size();
  for_each_field(state.particles, [](const char*, const char*, auto& field) {
    std::reverse(field.begin(), field.end());
  });
  state.pair_contacts = reversed(state.pair_contacts, count);
  state.wall_contacts = reversed(state.wall_contacts, count);
  std::reverse(state.lost.begin(), state.lost.end());
  return state;
}

// Towards zero, so that infinities move, too.
void nudge(double& x) {
  x = x == 0.0 ? std::numeric_limits<double>::denorm_min() : std::nextafter(x, 0.0);
}
void nudge(Vec3& v) { nudge(v.z()); }
void nudge(bool& x) { x = !x; }
void nudge(Phase& x) { x = Phase::done; }
template <class T>
requires std::is_unsigned_v<T>
void nudge(T& x) { x ^= T{1}; }

}  // namespace

TEST_CASE("The state hash does not depend on the spatial order") {
  const State state = test::random_state(500, 21);
  CHECK(io::state_hash(with_reversed_order(state)) == io::state_hash(state));
}

TEST_CASE("The state hash sees one unit in the last place of any number") {
  State state = test::random_state(40, 22);
  const std::uint64_t before = io::state_hash(state);
  const auto changes = [&](auto& value) {
    const auto old = value;
    nudge(value);
    CHECK(io::state_hash(state) != before);
    value = old;
  };
  const auto visit = [&]<class T>(const std::string& name, const char*, T& value) {
    INFO(name);
    if constexpr (std::is_scalar_v<T>) {
      changes(value);
    } else if (name != "start") {
      changes(value.back());
    }
  };
  for_each_field(state.particles, [&](const char* name, const char* unit, auto& field) {
    if (std::string(name) != "id") visit(name, unit, field);
  });
  io::for_each_contact_field(state.pair_contacts, visit);
  io::for_each_contact_field(state.wall_contacts, visit);
  changes(state.lost.back().time);
  io::for_each_ordered_field(state, visit);
}

TEST_CASE("The state hash tells particles apart that swapped their ids") {
  State state = test::random_state(10, 23);
  const std::uint64_t before = io::state_hash(state);
  std::swap(state.particles.id[2], state.particles.id[5]);
  CHECK(io::state_hash(state) != before);
}
