#include "cli/log.hpp"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace pmr::cli {

void open_log(const std::filesystem::path& folder) {
  auto terminal = std::make_shared<spdlog::sinks::stdout_sink_mt>();
  terminal->set_pattern("%v");
  auto file = std::make_shared<spdlog::sinks::basic_file_sink_mt>((folder / "log.txt").string());
  file->set_pattern("%Y-%m-%dT%H:%M:%S%z %l %v");
  auto logger = std::make_shared<spdlog::logger>(
      "pmr", spdlog::sinks_init_list{std::move(terminal), std::move(file)});
  logger->flush_on(spdlog::level::info);
  spdlog::set_default_logger(std::move(logger));
}

void log_info(const std::string& line) { spdlog::info("{}", line); }
void log_error(const std::string& line) { spdlog::error("{}", line); }

}  // namespace pmr::cli
