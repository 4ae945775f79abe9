// The fourth road for errors, beside those of errors.hpp: the disk's.
#pragma once
#include <stdexcept>

namespace pmr {

// The disk failed, or a folder is no longer what it was: "file: what was tried: why". Exit status
// 3; files that stood before stand as they were.
class StorageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pmr
