// The mixing as a strip of frames for each run: the same times, the same scale, by species.
#pragma once
#include <string>
#include <vector>

#include "report/run_data.hpp"

namespace pmr::report {

// Times after release at which frames are shown [s]: as chosen, else six from the release to when
// the last of the runs has come to rest.
std::vector<double> frame_times(const std::vector<const RunData*>& runs);

// Indices of the snapshots nearest to these times, each once; none if the bed did not move.
std::vector<std::size_t> mixing_frames(const RunData& run, const std::vector<double>& times);

std::string mixing_strips(const std::vector<const RunData*>& runs);

}  // namespace pmr::report
