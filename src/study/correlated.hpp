// Variables of a study that depend on each other.
#pragma once
#include <string>

#include "case/reader.hpp"
#include "study/study.hpp"

namespace pmr::study {

// Adds the variables of [correlated.NAME] to the study: those of the [calibration] table of `file`,
// or of the table itself.
void read_correlated(casefile::Table& table, const std::string& name, Study& study);

}  // namespace pmr::study
