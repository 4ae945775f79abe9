#include "cli/log.hpp"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <utility>

#include "pmr/base/storage_error.hpp"

namespace pmr::cli {

void open_log(const std::filesystem::path& folder) try {
  auto terminal = std::make_shared<spdlog::sinks::stdout_sink_mt>();
  terminal->set_pattern("%v");
  auto file = std::make_shared<spdlog::sinks::basic_file_sink_mt>((folder / "log.txt").string());
  file->set_pattern("%Y-%m-%dT%H:%M:%S%z %l %v");
  auto logger = std::make_shared<spdlog::logger>(
      "pmr", spdlog::sinks_init_list{std::move(terminal), std::move(file)});
  logger->flush_on(spdlog::level::info);
  logger->set_error_handler([told = false](const std::string& what) mutable {
    if (!std::exchange(told, true))
      std::fprintf(stderr, "the log is no longer written: %s\n", what.c_str());
  });
  spdlog::set_default_logger(std::move(logger));
} catch (const spdlog::spdlog_ex& error) {
  throw StorageError(error.what());
}

void log_info(const std::string& line) { spdlog::info("{}", line); }
void log_error(const std::string& line) { spdlog::error("{}", line); }
void say(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace pmr::cli
