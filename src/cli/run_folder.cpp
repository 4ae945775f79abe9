#include "cli/run_folder.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <system_error>

#include "io/run_file.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/storage_error.hpp"

namespace pmr::cli {
namespace {

namespace fs = std::filesystem;

// All that a run writes; run.h5, by which a folder is known, goes last.
constexpr std::array files{"run.xdmf",    "checkpoint.h5", "summary.json", "report.html",
                           "instruments", "log.txt",       "run.h5"};

[[noreturn]] void refuse(const fs::path& folder, const std::string& problem) {
  throw CaseError({{folder.string(), "", problem}});
}

// Empty, or begun by a time as ours are: "2026-01-31T12:00:00+0000 info ...".
bool is_our_log(const fs::path& file) {
  std::string head(20, ' ');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  return in.gcount() == 0 || (head[4] == '-' && head[7] == '-' && head[10] == 'T' &&
                              head[13] == ':' && head[16] == ':');
}

// What a run that was killed before its run.h5 was there leaves. (.write-test: of version 0.1)
bool is_leftover(const fs::path& file) {
  const std::string name = file.filename().string();
  if (name == io::FolderLock::name || name == ".write-test") return true;
  if (name == "log.txt") return is_our_log(file);
  return std::any_of(files.begin(), files.end(),
                     [&](const char* ours) { return name == std::string(ours) + ".tmp"; });
}

bool is_ours(const fs::path& folder) {
  if (fs::exists(folder / "run.h5")) return true;
  return std::all_of(fs::directory_iterator(folder), fs::directory_iterator(),
                     [](const fs::directory_entry& entry) { return is_leftover(entry.path()); });
}

void take_away(const fs::path& file) {
  std::error_code error;
  fs::remove_all(file, error);
  if (error) throw StorageError(file.string() + ": cannot be removed: " + error.message());
}

}  // namespace

io::FolderLock begin_in(const fs::path& folder) {
  std::error_code error;
  const auto status = fs::status(folder, error);
  if (error && status.type() != fs::file_type::not_found) refuse(folder, error.message());
  if (fs::exists(status) && !fs::is_directory(status)) refuse(folder, "is not a folder");
  if (fs::exists(status) && !is_ours(folder))
    refuse(folder, "holds files that are no run of pmr; name another output folder");
  const bool made = fs::create_directories(folder, error);
  if (error) refuse(folder, "cannot be made: " + error.message());
  try {
    io::FolderLock lock(folder);
    for (const char* file : files) {
      take_away(folder / (std::string(file) + ".tmp"));
      take_away(folder / file);
    }
    take_away(folder / ".write-test");
    return lock;
  } catch (...) {
    if (made) fs::remove(folder, error);
    throw;
  }
}

io::FolderLock go_on_in(const fs::path& folder) {
  if (!io::has_checkpoint(folder)) refuse(folder, "holds no checkpoint to go on from");
  return io::FolderLock(folder);
}

}  // namespace pmr::cli
