// Killed at any moment, a run goes on from its last checkpoint and ends with the same bits.
#include <signal.h>
#include <spawn.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <regex>
#include <thread>

#include "program.hpp"

namespace {

std::string hash_in(const std::filesystem::path& folder) {
  std::ifstream in(folder / "summary.json");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  std::smatch match;
  return std::regex_search(text, match, std::regex("\"state_hash\": \"([0-9a-f]{16})\""))
             ? match[1].str()
             : std::string();
}

// Starts a run and sends it a signal after a while; waits for its end.
int start_and_signal(const std::string& case_file, const std::string& out, int signal,
                     std::chrono::milliseconds after) {
  std::vector<std::string> words{
      PMR_PROGRAM, "run", case_file, "-o", out, "--set", "output.checkpoint_wall_time=\"50 ms\""};
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  posix_spawn_file_actions_addopen(&quiet, 1, "/dev/null", 1, 0);
  posix_spawn_file_actions_addopen(&quiet, 2, "/dev/null", 1, 0);
  REQUIRE(posix_spawn(&child, PMR_PROGRAM, &quiet, nullptr, argv.data(), environ) == 0);
  posix_spawn_file_actions_destroy(&quiet);
  std::this_thread::sleep_for(after);
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

TEST_CASE("A run that was killed or interrupted ends with the bits of one that was not") {
  const std::string tiny = (source_dir / "tests/sim/tiny.toml").string();
  const Scratch scratch("kill");
  const std::string whole = (scratch.path / "whole").string();
  REQUIRE(
      pmr_says("run " + tiny + " -o " + whole + " --set 'output.checkpoint_wall_time = \"50 ms\"'")
          .status == 0);
  REQUIRE(hash_in(whole).size() == 16);

  for (const int signal : {SIGKILL, SIGINT}) {
    const std::string out = (scratch.path / ("cut" + std::to_string(signal))).string();
    const int status = start_and_signal(tiny, out, signal, std::chrono::milliseconds(700));
    INFO("signal " << signal << ", status " << status);
    if (status != 0) {  // a fast machine may have been done
      CHECK(status == (signal == SIGINT ? 130 : 128 + SIGKILL));
      const Said said = pmr_says("resume " + out);
      INFO(said.text);
      REQUIRE(said.status == 0);
    }
    CHECK(hash_in(out) == hash_in(whole));
  }
}
