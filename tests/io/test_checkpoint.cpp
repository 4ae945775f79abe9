// Restart depends on every bit of the state.
#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <map>

#include "io/hdf5.hpp"
#include "io/state_members.hpp"
#include "pmr/base/errors.hpp"
#include "samples.hpp"

// HDF5 1.10 itself leaks some 400 bytes each time it refuses damaged metadata; the address
// sanitizer asks here what to overlook.
// NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

using namespace pmr;

namespace {

template <class T>
std::string bits(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}
template <class T>
requires std::is_scalar_v<T> std::string bits(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

// All bits of a state by the name of the member.
std::map<std::string, std::string> all_bits(const State& state) {
  std::map<std::string, std::string> found;
  const auto visit = [&](const std::string& prefix) {
    return [&found, prefix](const std::string& name, const char*, const auto& value) {
      found[prefix + name] = bits(value);
    };
  };
  for_each_field(state.particles, visit("particles/"));
  for_each_field(state.waiting, visit("waiting/"));
  io::for_each_contact_field(state.pair_contacts, visit("pair/"));
  io::for_each_contact_field(state.wall_contacts, visit("wall/"));
  io::for_each_ordered_field(state, visit(""));
  for (std::size_t i = 0; i < state.lost.size(); ++i)
    found["lost/" + std::to_string(i)] = bits(state.lost[i].id) + bits(state.lost[i].time) +
                                         bits(std::vector<Vec3>{state.lost[i].position});
  return found;
}

void require_round_trip(const State& state) {
  const test::Folder folder("checkpoint");
  std::filesystem::create_directories(folder.path());
  io::save_checkpoint(folder.path(), state);
  REQUIRE(io::has_checkpoint(folder.path()));
  const State back = io::load_checkpoint(folder.path());
  const auto wanted = all_bits(state), found = all_bits(back);
  REQUIRE(wanted.size() == found.size());
  for (const auto& [name, value] : wanted) {
    INFO(name);
    CHECK(found.at(name) == value);
  }
  CHECK(io::state_hash(back) == io::state_hash(state));
}

}  // namespace

TEST_CASE("A checkpoint gives back a random state bit for bit") {
  State state = test::random_state(2500, 11);
  require_round_trip(state);
  state.waiting = test::random_state(40, 14).particles;
  require_round_trip(state);
}

TEST_CASE("A checkpoint gives back a bed of more than one chunk") {
  require_round_trip(test::random_state(20000, 12));  // chunks hold 16384 rows
}

TEST_CASE("A checkpoint gives back the empty state with its infinities") {
  require_round_trip(State{});
}

TEST_CASE("A checkpoint gives back one particle without contact rows") {
  State state = test::random_state(1, 13);
  state.pair_contacts = ContactHistory{};
  state.particles.temperature[0] = std::numeric_limits<double>::quiet_NaN();
  state.particles.position[0] = Vec3(-0.0, std::numeric_limits<double>::denorm_min(), 1e308);
  require_round_trip(state);
}

TEST_CASE("The visitor of fluxes names every member") {
  std::size_t count = 0;
  const Fluxes fluxes;
  for_each_flux(fluxes, [&](const char*, const char*, const double&) { ++count; });
  CHECK(count * sizeof(double) == sizeof(Fluxes));
}

TEST_CASE("The visitor of particles names every field") {
  std::size_t size = 0;
  const Particles particles;
  for_each_field(particles, [&](const char*, const char*, const auto& f) { size += sizeof f; });
  CHECK(size == sizeof(Particles));
}

TEST_CASE("A new checkpoint replaces the old one and a stale temporary") {
  const test::Folder folder("stale");
  std::filesystem::create_directories(folder.path());
  io::save_checkpoint(folder.path(), test::random_state(10, 1));
  std::ofstream(folder.path() / "checkpoint.h5.tmp") << "half a file of a killed run";
  CHECK(io::load_checkpoint(folder.path()).particles.size() == 10);
  io::save_checkpoint(folder.path(), test::random_state(20, 2));
  CHECK(io::load_checkpoint(folder.path()).particles.size() == 20);
  CHECK_FALSE(std::filesystem::exists(folder.path() / "checkpoint.h5.tmp"));
}

TEST_CASE("A damaged byte of a checkpoint is refused or harmless, never read as data") {
  const test::Folder folder("damaged");
  std::filesystem::create_directories(folder.path());
  const State state = test::random_state(300, 3);
  const auto path = folder.path() / "checkpoint.h5";
  io::save_checkpoint(folder.path(), state);
  const std::uint64_t wanted = io::state_hash(state);
  const auto size = std::filesystem::file_size(path);
  std::size_t refused = 0;
  for (std::uintmax_t at = 0; at < size; at += 997) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(static_cast<std::streamoff>(at));
    const char old = static_cast<char>(file.get());
    const auto put = [&](char c) {
      file.seekp(static_cast<std::streamoff>(at));
      file.put(c).flush();
    };
    put(static_cast<char>(old ^ 0x10));
    try {
      const State back = io::load_checkpoint(folder.path());  // a spare byte: no harm
      CHECK(io::state_hash(back) == wanted);
    } catch (const CaseError& error) {
      ++refused;
      CHECK(std::string(error.what()).find("checkpoint.h5") != std::string::npos);
    }
    put(old);
  }
  CHECK(refused > 0);
  CHECK(io::state_hash(io::load_checkpoint(folder.path())) == wanted);
}

TEST_CASE("A missing checkpoint is said by its path") {
  const test::Folder folder("missing");
  CHECK_FALSE(io::has_checkpoint(folder.path()));
  CHECK_THROWS_WITH(io::load_checkpoint(folder.path()),
                    Catch::Matchers::Contains("checkpoint.h5: no such file"));
}

TEST_CASE("A run file in the place of a checkpoint is refused with what was wanted") {
  const test::Folder folder("mixed");
  io::create_run(folder.path(), test::header());
  std::filesystem::copy_file(folder.path() / "run.h5", folder.path() / "checkpoint.h5");
  CHECK_THROWS_WITH(io::load_checkpoint(folder.path()),
                    Catch::Matchers::Contains("pmr-checkpoint version 5 wanted, found pmr-run"));
}
