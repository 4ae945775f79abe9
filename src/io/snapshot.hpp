// One snapshot as a group of run.h5.
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "io/hdf5.hpp"
#include "io/run_file.hpp"

namespace pmr::io {

// How a particle field stands in a snapshot; none: it does not (force and torque, which only the
// next sub-step needs). Places, sizes, masses, temperature and delta keep all bits, so that
// instruments give the same figures from the file as from the run: float32 would move a sphere 1 m
// from the origin by 6e-8 m, 6 % of an overlap of 1e-6 m. Velocity, spin and enthalpy
// are for pictures and plots: 7 digits do.
std::optional<Number> snapshot_number(std::string_view field);

void write_snapshot(H5File& file, const std::string& group, const Snapshot& snapshot);
Snapshot load_snapshot(const H5File& file, const std::string& group);

// Groups of all snapshots in the order of writing, "/snapshots/00000" first.
std::vector<std::string> snapshot_groups(const H5File& file);
// Name of the group after the last.
std::string next_snapshot_group(const std::vector<std::string>& groups);

// 0, 1, ... count - 1: the particle that each vertex of run.xdmf stands for. ParaView's newer
// readers draw no point that no cell names, and take cells from a dataset alone.
std::string vertices_path(std::size_t count);
void write_vertices(H5File& file);  // for every snapshot of the file that still lacks them

std::string_view phase_name(Phase phase);

}  // namespace pmr::io
