// run.h5 and checkpoint.h5 of a run folder. Every write is a new file, renamed into place: a kill
// at any moment leaves the last complete one. HDF5 itself stays in hdf5.cpp.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "pmr/state/case.hpp"
#include "pmr/state/state.hpp"

namespace pmr::io {

// A table over time; the first column is "time". Columns are fixed by the first append.
struct Column {
  std::string name;            // "temperature_mean.SrFeO3", [a-zA-Z0-9_.-]
  std::string unit;            // "K"
  std::vector<double> values;  // one per row
};
struct Series {
  std::vector<Column> columns;
  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
  const std::vector<double>& values(const std::string& name) const;  // throws if absent
  bool has(const std::string& name) const;
};

// Particles and walls at one moment.
struct Snapshot {
  double time = 0.0;  // [s]
  Phase phase = Phase::fill;
  Particles particles;
  std::vector<double> wall_temperature;  // [K] face of each wall patch, order of RunHeader::patches
  std::vector<Vec3> adhered = {};        // [m] grains on walls, order of RunHeader::adhered_radius
};

// What is known when a run starts.
struct RunHeader {
  std::string case_text;                          // TOML, with --set applied
  std::map<std::string, std::string> provenance;  // version, git, case_hash, command, machine, ...
  std::vector<std::string> species;               // names by index
  std::vector<std::string> patches;               // names of the wall patches
  std::vector<double> adhered_radius = {};        // [m] of each grain that adheres to a wall
};

void create_run(const std::filesystem::path& dir, const RunHeader& header);
// Appends rows and snapshots in one atomic replacement of run.h5, and renews run.xdmf.
void append_run(const std::filesystem::path& dir, const Series& rows,
                std::span<const Snapshot> snapshots);
// Drops rows and snapshots later than `time` [s] (a run resumed from an older checkpoint).
void drop_after(const std::filesystem::path& dir, double time);

RunHeader read_header(const std::filesystem::path& dir);
Series read_series(const std::filesystem::path& dir);
std::vector<double> snapshot_times(const std::filesystem::path& dir);  // [s]
Snapshot read_snapshot(const std::filesystem::path& dir, std::size_t index);

// The whole State, bit for bit.
void save_checkpoint(const std::filesystem::path& dir, const State& state);
State load_checkpoint(const std::filesystem::path& dir);
bool has_checkpoint(const std::filesystem::path& dir);

// Hash over all that a checkpoint holds, with particles and contacts in the order of ids.
std::uint64_t state_hash(const State& state);

}  // namespace pmr::io
