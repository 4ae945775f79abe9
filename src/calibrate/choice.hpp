// Which point of a stage's parameters is given: crossings, modes, and what decides between them.
#pragma once
#include "calibrate/stage.hpp"

namespace pmr::calibrate {

// Fills in modes, the mass on the box's edge, what decided, and doubts; heaviest mode first. Anew
// where the levels were chosen from before.
void choose(const Lab& lab, const Stage& stage, StageResult& result);

// How far a level is missed at a point: in the target's unit, in deviations, and the discrepancy
// that would reconcile them [unit]; 0 where one deviation already does.
struct Miss {
  double predicted, difference, deviations, discrepancy;
};
Miss miss_of(const Target& target, const Level& level, const std::vector<double>& point);

}  // namespace pmr::calibrate
