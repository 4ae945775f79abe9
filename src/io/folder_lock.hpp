// One folder, one writer.
#pragma once
#include <filesystem>

namespace pmr::io {

// Holds DIR/.lock for as long as it lives. The lock is the kernel's (flock): it ends with the
// process however that ends, so that none is ever stale; the file says who holds it. It binds
// processes of one machine, and those of several where the file system passes flock on.
class FolderLock {
 public:
  // The folder must be there. CaseError when another process holds it, or when it cannot be
  // written; StorageError when the disk is full or fails.
  explicit FolderLock(std::filesystem::path folder);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock& operator=(FolderLock&&) = delete;

  // StorageError once the folder has been removed, or removed and made anew by somebody else.
  void require_standing() const;

  static constexpr const char* name = ".lock";

 private:
  bool stands() const;

  std::filesystem::path folder_;
  int descriptor_ = -1;
};

}  // namespace pmr::io
