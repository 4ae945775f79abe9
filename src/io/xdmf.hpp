// run.xdmf: what ParaView and VisIt open; a list of clouds of points that refers to run.h5.
#pragma once
#include <filesystem>
#include <string>

#include "io/hdf5.hpp"

namespace pmr::io {

// XDMF version 2 text: a temporal collection, one Polyvertex grid per snapshot. Snapshots without
// particles are left out: readers refuse arrays of length zero.
std::string xdmf_text(const H5File& run);

}  // namespace pmr::io
