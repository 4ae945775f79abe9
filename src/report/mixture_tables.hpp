// Tables and sentences of the mixture, for one run or for several side by side. HTML.
#pragma once
#include <string>
#include <vector>

#include "report/mixture_charts.hpp"

namespace pmr::report {

// Lacey index, difference of mirrored sections, deviation from the reference.
std::string mixture_indices(const Bed& bed, double lacey_index);
// A row per layer: masses and w, the sector of its largest w, left against right, the reference.
std::string layer_table(const Bed& bed);
// The same of several beds, values beside each other, with differences from the first.
std::string compared_layers(const std::vector<Bed>& beds);
// w of every section, the beds' rows of a layer one under the other, the largest of a row in bold.
std::string section_table(const std::vector<Bed>& beds);
// How the bed stands to what is published of the measured ones, told from its own data.
std::string against_measurement(const Bed& bed, double settled_time);

}  // namespace pmr::report
