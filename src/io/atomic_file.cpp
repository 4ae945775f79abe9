#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "pmr/base/storage_error.hpp"

namespace pmr::io {
namespace {

[[noreturn]] void fail_on_disk(const std::filesystem::path& path, const char* what) {
  const int reason = errno;
  throw StorageError(path.string() + ": " + what + ": " + std::strerror(reason));
}

class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  bool is_open() const { return descriptor_ >= 0; }
  bool write(std::string_view bytes) const {  // all of them, in as many pieces as it takes
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }
  bool sync() const { return ::fsync(descriptor_) == 0; }
  bool close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

 private:
  int descriptor_;
};

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

}  // namespace

Replacement::Replacement(std::filesystem::path target)
    : target_(std::move(target)), temporary_(target_.string() + ".tmp") {
  const Descriptor file(temporary_, O_WRONLY | O_CREAT | O_TRUNC);
  if (!file.is_open()) fail_on_disk(target_, "cannot be written");
}

Replacement::~Replacement() {
  std::error_code ignored;
  if (!committed_) std::filesystem::remove(temporary_, ignored);
}

void Replacement::commit() {
  Descriptor file(temporary_, O_RDONLY);
  if (!file.is_open() || !file.sync() || !file.close())
    fail_on_disk(target_, "cannot be brought to the disk");
  if (::rename(temporary_.c_str(), target_.c_str()) != 0)
    fail_on_disk(target_, "cannot be replaced");
  committed_ = true;
  // EINVAL: file systems that cannot sync a folder; the file itself is whole either way.
  const Descriptor folder(folder_of(target_), O_RDONLY | O_DIRECTORY);
  if (!folder.is_open() || (!folder.sync() && errno != EINVAL))
    fail_on_disk(target_, "its folder cannot be brought to the disk");
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void replace_text(const std::filesystem::path& target, std::string_view text) {
  Replacement replacement(target);
  Descriptor file(replacement.temporary(), O_WRONLY | O_TRUNC);
  if (!file.is_open() || !file.write(text) || !file.close())
    fail_on_disk(target, "cannot be written");
  replacement.commit();
}

}  // namespace pmr::io
