// The log of a run: to the terminal and to DIR/log.txt.
#pragma once
#include <filesystem>
#include <string>

namespace pmr::cli {

void open_log(const std::filesystem::path& folder);
void log_info(const std::string& line);
void log_error(const std::string& line);

}  // namespace pmr::cli
