// How HDF5 reaches the disk when it writes. Its own driver fails in the middle of the library,
// which then loses data in silence (a failed H5Dclose) and crashes at exit (a file whose H5Fclose
// failed is closed once more). This one takes every write as done, keeps the first refusal of the
// disk, and writes nothing from then on: the caller asks for it once the file is closed.
#pragma once
#include <hdf5.h>

namespace pmr::io {

// Makes the files that are opened with `access` write this way. `refusal`, 0 before, becomes the
// first errno; it must outlive the file.
herr_t write_through(hid_t access, int* refusal);

}  // namespace pmr::io
