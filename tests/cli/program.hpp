// Runs pmr as a user would, and catches what it says.
#pragma once
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

struct Said {
  int status;        // exit status
  std::string text;  // standard output and error
};

// `arguments` as typed in a shell, after what `before` does in it ("ulimit -f 100; ").
inline Said pmr_says(const std::string& arguments, const std::string& before = "") {
  const std::string command = before + PMR_PROGRAM + " " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  Said said{-1, {}};
  if (pipe == nullptr) return said;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
    said.text.append(buffer.data(), n);
  const int status = pclose(pipe);
  said.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return said;
}

// A pmr that runs beside the test; what it says goes into a file. It ends with the value.
class Beside {
 public:
  Beside(std::vector<std::string> words, const std::filesystem::path& said) {
    words.insert(words.begin(), PMR_PROGRAM);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t into;
    posix_spawn_file_actions_init(&into);
    posix_spawn_file_actions_addopen(&into, 1, said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&into, 1, 2);
    if (posix_spawn(&pid_, PMR_PROGRAM, &into, nullptr, argv.data(), environ) != 0) pid_ = 0;
    posix_spawn_file_actions_destroy(&into);
  }
  ~Beside() {
    if (pid_ == 0) return;
    signal(SIGKILL);
    wait();
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  void signal(int number) const { ::kill(pid_, number); }
  pid_t pid() const { return pid_; }
  // Exit status, 128 + the signal that ended it.
  int wait() {
    int status = 0;
    ::waitpid(std::exchange(pid_, 0), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  pid_t pid_ = 0;
};

// Until it is there, or half a minute is over.
inline bool comes(const std::filesystem::path& file) {
  for (int k = 0; k < 3000 && !std::filesystem::exists(file); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return std::filesystem::exists(file);
}

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// state_hash in summary.json of a run folder; "" where there is none.
inline std::string hash_in(const std::filesystem::path& folder) {
  const std::string text = text_of(folder / "summary.json"), key = "\"state_hash\": \"";
  const std::size_t at = text.find(key);
  return at == std::string::npos ? "" : text.substr(at + key.size(), 16);
}

inline const std::filesystem::path source_dir = PMR_SOURCE_DIR;
inline const std::string tiny = (source_dir / "tests/sim/tiny.toml").string();  // a case

// A folder that goes with the value.
struct Scratch {
  std::filesystem::path path;
  explicit Scratch(const std::string& name)
      : path(std::filesystem::temp_directory_path() /
             ("pmr-cli-" + name + "-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~Scratch() { std::filesystem::remove_all(path); }
};
