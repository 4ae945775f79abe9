// Mass ratios to compare a decomposition with, from a CSV file. The header is "layer, mass_ratio"
// with a row for each layer, or "layer, azimuth [deg], mass_ratio" with a row for each section;
// `layer` counts from 1 on top, `azimuth` is a sector's centre from the ramp (in -180 to 360 deg),
// `mass_ratio` [1] is empty or "nan" where nothing was measured. Lines that begin with # are
// comments. The other columns of a run's own instruments/sections.csv may stand there, unread.
#pragma once
#include <filesystem>
#include <optional>

#include "case/reader.hpp"
#include "pmr/state/case.hpp"

namespace pmr::casefile {

// None after a fault.
std::optional<MixtureReference> read_reference_csv(Reading& reading,
                                                   const std::filesystem::path& file,
                                                   const Decomposition& tool);

// The same for a file that stands in no case; throws CaseError with every fault.
MixtureReference load_reference(const std::filesystem::path& file, const Decomposition& tool);

// Puts it in place of the case's own. CaseError too if the case, told as `name`, has no tool.
void set_reference(Case& setup, const std::filesystem::path& file, const std::string& name);

}  // namespace pmr::casefile
