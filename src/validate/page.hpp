// The page of a validation: what was measured, what was computed, and what is made of it.
#pragma once
#include "validate/comparison.hpp"

namespace pmr::validate {

// FOLDER/report.html.
void write_page(std::span<const Experiment> experiments, const ValidationPlan& plan,
                const Findings& findings, const study::Folder& folder);

}  // namespace pmr::validate
