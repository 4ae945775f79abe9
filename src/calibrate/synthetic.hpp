// A lab made by the program itself: does a calibration find again what is known?
#pragma once
#include <filesystem>
#include <string>

#include "calibrate/runs.hpp"

namespace pmr::calibrate {

inline constexpr std::size_t first_synthetic_seed = 101;  // none that a calibration uses

// A lab file that lies on the lab's own and gives other results: what the tests give at the
// parameters of `truth`, means of each test's seeds and their standard errors. `truth` is a TOML
// file with the parameters under their keys (contacts.toml of a calibration, or of the shipped
// materials) or by their names; what a formula derives follows from them unless it stands there
// too. CaseError where a parameter is not there; NumericsError where fewer than two runs of a test
// give a result, or one ends beyond the limit of a censored response (which mean is not known);
// Stopped.
std::string synthetic_lab(const Lab& lab, const std::filesystem::path& truth, bool is_full,
                          Runs& runs);

}  // namespace pmr::calibrate
