// Text dumps of LAMMPS and LIGGGHTS: "ITEM: ATOMS id type radius x y z ...", one line an atom.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "pmr/base/vec3.hpp"

namespace pmr::io {

struct DumpAtom {
  std::uint64_t id;    // [1] as in the dump
  std::uint64_t type;  // [1] from 1
  double radius;       // [m]
  Vec3 position;       // [m]
  Vec3 velocity;       // [m/s] zero where the dump has no vx vy vz
  Vec3 spin;           // [rad/s] zero where the dump has no omegax omegay omegaz
  std::size_t line;    // [1] of the file, for messages
};

struct Dump {
  std::uint64_t time_step = 0;  // [1] of the frame
  std::vector<DumpAtom> atoms;  // by id
};

// The last frame of the dump. Columns may stand in any order; those that are not wanted are passed
// over. Units are SI (`units si`). CaseError with each fault's file:line: other units declared,
// missing columns and those that stand twice, scaled or unwrapped coordinates, lines that are cut
// or hold anything but finite numbers, radii that no grain has (1 um to 50 mm), ids that appear
// twice, fewer or more atoms than announced.
Dump read_dump(const std::filesystem::path& file);

// True when the file opens with "ITEM:".
bool is_dump(const std::filesystem::path& file);

}  // namespace pmr::io
