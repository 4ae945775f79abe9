// A file that appears whole or not at all: written beside its target, made durable, renamed. What
// the disk refuses is a StorageError.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace pmr::io {

class Replacement {
 public:
  // Opens DIR/NAME.tmp afresh: whatever a killed run left there goes.
  explicit Replacement(std::filesystem::path target);
  ~Replacement();  // takes the temporary away unless committed
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  const std::filesystem::path& temporary() const { return temporary_; }
  // To the disk, then renamed over the target, then the folder to the disk.
  void commit();

 private:
  std::filesystem::path target_, temporary_;
  bool committed_ = false;
};

// A whole file as it is; empty where there is none.
std::string read_text(const std::filesystem::path& file);

// A whole file of text or bytes, replaced atomically.
void replace_text(const std::filesystem::path& target, std::string_view text);

}  // namespace pmr::io
