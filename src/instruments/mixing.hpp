// How well two species are mixed, as one number.
#pragma once
#include "instruments/decomposition.hpp"

namespace pmr::instruments {

// Lacey's index M = (s0^2 - s^2) / (s0^2 - sR^2) [1] over the sections of the layers (the residuum
// is not cut into sections by the tool): 0 apart, 1 mixed at random.
//   s^2   variance of the bead mass fraction over the sections, weighted with their mass
//   s0^2  = p (1 - p), species apart; p the bead mass fraction of all sections
//   sR^2  = p (1 - p) / n, n = M_section / (p m_granule + (1 - p) m_bead) with mean masses:
//         random mixture of particles of two masses
// Sources: Lacey, J. Appl. Chem. 4 (1954) 257 (index); Stange, Chem.-Ing.-Tech. 26 (1954) 331
// (variance for unequal particle masses). NaN unless both species stand in two sections or more.
double lacey_index(const BedSections& sections);

}  // namespace pmr::instruments
