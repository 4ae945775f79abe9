// Disks that are full, folders that are somebody else's: what stood stands, and the error is told.
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "io/hdf5.hpp"
#include "io/series.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/storage_error.hpp"
#include "samples.hpp"

using namespace pmr;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

// No file grows beyond `bytes` for as long as the value lives: a write then fails in the middle
// with EFBIG, as on a full disk, for every user on every file system.
struct FullDisk {
  explicit FullDisk(rlim_t bytes) {
    ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before);
    const rlimit now{bytes, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before); }
  rlimit before{};
};

// A process that holds the lock of a folder until it is killed.
struct Holder {
  pid_t pid;
  explicit Holder(const fs::path& folder) : pid(0) {
    int ready[2];
    REQUIRE(::pipe(ready) == 0);
    pid = ::fork();
    if (pid == 0) {
      const io::FolderLock lock(folder);
      [[maybe_unused]] const ssize_t told = ::write(ready[1], "x", 1);
      while (true) ::pause();
    }
    char letter = ' ';
    CHECK(::read(ready[0], &letter, 1) == 1);
    ::close(ready[0]);
    ::close(ready[1]);
  }
  void kill() {
    ::kill(pid, SIGKILL);
    ::waitpid(pid, nullptr, 0);
  }
};

}  // namespace

TEST_CASE("Wherever the disk is full, a checkpoint is whole or an error, and the last one stands") {
  const test::Folder folder("full-checkpoint");
  io::create_run(folder.path(), test::header());
  const State first = test::random_state(100, 1), second = test::random_state(300, 2);
  io::save_checkpoint(folder.path(), second);
  const auto size = fs::file_size(folder.path() / "checkpoint.h5");
  std::size_t refused = 0;
  for (rlim_t bytes = 0; bytes <= size + 2000; bytes += size / 37) {
    io::save_checkpoint(folder.path(), first);
    bool saved = true;
    try {
      const FullDisk disk(bytes);
      io::save_checkpoint(folder.path(), second);
    } catch (const StorageError& error) {
      saved = false;
      ++refused;
      CHECK_THAT(error.what(), Contains("checkpoint.h5"));
      CHECK_THAT(error.what(), Contains("File too large"));
    }
    INFO(bytes << " of " << size << " bytes");
    CHECK(saved == (bytes >= size));
    CHECK(io::state_hash(io::load_checkpoint(folder.path())) ==
          io::state_hash(saved ? second : first));
    CHECK_FALSE(fs::exists(folder.path() / "checkpoint.h5.tmp"));
  }
  CHECK(refused >= 36);
}

TEST_CASE("A run file that cannot grow stays as it was, with the rows it had") {
  const test::Folder folder("full-run");
  io::create_run(folder.path(), test::header());
  io::append_run(folder.path(), test::rows(0.0, 3), {});
  const auto size = fs::file_size(folder.path() / "run.h5");
  {
    const FullDisk disk(size + 100);
    CHECK_THROWS_AS(io::append_run(folder.path(), test::rows(3.0, 100000), {}), StorageError);
  }
  CHECK(io::read_series(folder.path()).rows() == 3);
  io::append_run(folder.path(), test::rows(3.0, 2), {});
  CHECK(io::read_series(folder.path()).rows() == 5);
}

TEST_CASE("A text that does not fit is an error, and the last one stands") {
  const test::Folder folder("full-text");
  fs::create_directories(folder.path());
  const fs::path file = folder.path() / "a.txt";
  io::replace_text(file, "short");
  const FullDisk disk(1000);
  CHECK_THROWS_AS(io::replace_text(file, std::string(5000, 'x')), StorageError);
  CHECK(io::read_text(file) == "short");
  CHECK_FALSE(fs::exists(folder.path() / "a.txt.tmp"));
}

TEST_CASE("A folder that was taken away is the disk's fault, not the input's") {
  const test::Folder folder("gone");
  io::create_run(folder.path(), test::header());
  fs::remove_all(folder.path());
  CHECK_THROWS_AS(io::append_run(folder.path(), test::rows(0.0, 1), {}), StorageError);
  CHECK_THROWS_AS(io::save_checkpoint(folder.path(), State{}), StorageError);
  CHECK_THROWS_AS(io::drop_after(folder.path(), 0.0), StorageError);
}

TEST_CASE("A folder has one writer, which is named, and none once that was killed") {
  const test::Folder folder("lock");
  fs::create_directories(folder.path());
  Holder holder(folder.path());
  try {
    const io::FolderLock lock(folder.path());
    holder.kill();
    FAIL("two writers");
  } catch (const CaseError& error) {
    CHECK_THAT(error.what(), Contains("process " + std::to_string(holder.pid) + " on "));
  }
  holder.kill();
  CHECK(fs::exists(folder.path() / io::FolderLock::name));  // and binds nobody
  { const io::FolderLock lock(folder.path()); }
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("Who writes a folder notices that it was removed, or made anew by somebody else") {
  const test::Folder folder("replaced");
  fs::create_directories(folder.path());
  const io::FolderLock lock(folder.path());
  CHECK_NOTHROW(lock.require_standing());
  fs::remove_all(folder.path());
  CHECK_THROWS_AS(lock.require_standing(), StorageError);
  fs::create_directories(folder.path());
  const io::FolderLock other(folder.path());
  CHECK_THROWS_AS(lock.require_standing(), StorageError);
  CHECK_NOTHROW(other.require_standing());
}
