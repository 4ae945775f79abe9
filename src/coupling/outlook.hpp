// What the coefficients of an interval are taken at: the bed and the gas as they will be in its
// middle if they go on as they went in the interval before. Conductances that stand still while the
// network moves are then right to second order in the interval's length.
#pragma once
#include <vector>

#include "coupling/bed_gas.hpp"

namespace pmr::coupling {

struct Outlook {
  std::vector<double> temperature;  // [K] by particle index
  WallNodes walls;
  Atmosphere gas;                 // of the chamber
  std::vector<Atmosphere> pores;  // of each layer of the bed, where they are resolved
};

// `ahead` [s] of the state; 0: as things are.
Outlook look_ahead(const Case& c, const State& state, double ahead);

// What the state went through, for the next outlook: begun when an interval begins, set at its end.
class TrendWatch {
 public:
  TrendWatch(const Case& c, const State& before);
  void set(const Case& c, double length, State& after) const;  // [s]

 private:
  std::vector<double> temperature_;  // [K] by particle index
  std::vector<double> cell_energy_;  // [J] by wall cell
  double pressure_;                  // [Pa]
  std::vector<Atmosphere> pores_;
};

}  // namespace pmr::coupling
