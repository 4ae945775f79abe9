// Where and with what a run is made, for its record.
#pragma once
#include <cstdint>
#include <map>
#include <string>

namespace pmr::cli {

// version, git, compiler, machine, cores, threads, started, command, case_hash.
std::map<std::string, std::string> provenance(const std::string& command,
                                              const std::string& case_text);
std::string hexadecimal(std::uint64_t value);  // 16 digits

}  // namespace pmr::cli
