// The log of a run: to the terminal and to DIR/log.txt.
#pragma once
#include <filesystem>
#include <string>

namespace pmr::cli {

// StorageError when there can be none.
void open_log(const std::filesystem::path& folder);
void log_info(const std::string& line);
void log_error(const std::string& line);

// To the terminal alone. Like the log it goes on in silence when nobody reads it any more.
void say(const std::string& text);

}  // namespace pmr::cli
