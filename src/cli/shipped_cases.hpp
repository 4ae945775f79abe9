// Cases, studies, labs and experiments that come with the program, found by name from any folder.
#pragma once
#include <filesystem>
#include <vector>

namespace pmr::cli {

// The file itself if there is one; else, for a bare name, the shipped case ("demonstrator-small",
// with or without ".toml"). A bare name that is neither is a fault that names the shipped ones.
std::filesystem::path find_case(const std::filesystem::path& named);
std::filesystem::path find_study(const std::filesystem::path& named);
std::filesystem::path find_lab(const std::filesystem::path& named);
// Where none is named, all shipped experiments but the long ones.
std::vector<std::filesystem::path> find_experiments(
    const std::vector<std::filesystem::path>& named);

}  // namespace pmr::cli
