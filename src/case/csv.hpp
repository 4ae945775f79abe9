// CSV files. Explicit particles: a header "species, x [mm], y [mm], z [mm]", and if wanted
// "vx [m/s]" ..., "wx [rad/s]" ..., "temperature [degC]", "radius [mm]"; then one row a particle.
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case/reader.hpp"
#include "pmr/state/case.hpp"

namespace pmr::casefile {

std::vector<ExplicitParticle> read_particles_csv(Reading& reading,
                                                 const std::filesystem::path& file,
                                                 std::span<const Species> species);

// Columns of numbers in SI, in the order of `wanted`; a column that the file has not is empty. None
// after a fault: a file that cannot be read, an unknown column, a missing unit, a bad number.
struct NumberColumn {
  std::string name;
  Dimension dimension;
};
std::optional<std::vector<std::vector<double>>> read_number_csv(
    Reading& reading, const std::filesystem::path& file, const std::vector<NumberColumn>& wanted);

// Index of a species by name; a fault and 0 when there is none.
SpeciesIndex species_index(Reading& reading, const Place& place, const std::string& key,
                           const std::string& name, std::span<const Species> species);

}  // namespace pmr::casefile
