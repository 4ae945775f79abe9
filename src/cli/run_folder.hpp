// The folder of a run: whose it is, and that one process alone writes it.
#pragma once
#include <filesystem>

#include "io/folder_lock.hpp"

namespace pmr::cli {

// A new or empty folder, or one that holds an earlier run or what is left of its beginning: empty
// but for the lock now. CaseError when it is something else or another process writes it.
io::FolderLock begin_in(const std::filesystem::path& folder);

// A folder with a checkpoint to go on from.
io::FolderLock go_on_in(const std::filesystem::path& folder);

}  // namespace pmr::cli
