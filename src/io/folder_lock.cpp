#include "io/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "io/atomic_file.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/storage_error.hpp"

namespace pmr::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, const std::string& problem) {
  throw CaseError({{folder.string(), "", problem}});
}

// The user's mistake, or the disk's.
[[noreturn]] void fail_to_lock(const fs::path& folder, int reason) {
  const std::string problem = std::string("cannot be written: ") + std::strerror(reason);
  if (reason == ENOSPC || reason == EDQUOT || reason == EIO)
    throw StorageError(folder.string() + ": " + problem);
  refuse(folder, problem);
}

std::string this_process() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return "process " + std::to_string(::getpid()) + " on " + host.data();
}

// Who wrote the lock file.
std::string holder(const fs::path& lock) {
  std::string text = read_text(lock);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.empty() ? "another process" : text;
}

}  // namespace

FolderLock::FolderLock(fs::path folder) : folder_(std::move(folder)) {
  const fs::path file = folder_ / name;
  while (true) {
    descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail_to_lock(folder_, errno);
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(std::exchange(descriptor_, -1));
      refuse(folder_, "is being written by " + holder(file) +
                          "; wait for its end, or name another output folder");
    }  // other failures: a file system without locks (docs/file-formats.md)
    if (stands()) break;
    ::close(descriptor_);  // the file went with its last holder just now
  }
  const std::string text = this_process() + "\n";
  const auto size = static_cast<ssize_t>(text.size());
  if (::ftruncate(descriptor_, 0) == 0 &&
      ::pwrite(descriptor_, text.data(), text.size(), 0) == size)
    return;
  const int reason = errno;
  ::unlink(file.c_str());
  ::close(descriptor_);
  fail_to_lock(folder_, reason);
}

FolderLock::~FolderLock() {
  if (descriptor_ < 0) return;
  if (stands()) ::unlink((folder_ / name).c_str());
  ::close(descriptor_);
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : folder_(std::move(other.folder_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

// Whether the file that is held is the one that stands in the folder.
bool FolderLock::stands() const {
  struct stat held {
  }, there{};
  return ::fstat(descriptor_, &held) == 0 && ::stat((folder_ / name).c_str(), &there) == 0 &&
         held.st_dev == there.st_dev && held.st_ino == there.st_ino;
}

void FolderLock::require_standing() const {
  if (!stands())
    throw StorageError(folder_.string() + ": was removed or replaced while it was written");
}

}  // namespace pmr::io
