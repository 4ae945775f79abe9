// The report of a study: one self-contained page.
#pragma once
#include "study/results.hpp"

namespace pmr::study {

// Writes FOLDER/report.html.
void write_page(const Study& study, const Plan& plan, const Results& results, const Folder& folder);

}  // namespace pmr::study
