// The shipped library of materials (cases/materials/*.toml), built into the program.
#pragma once
#include <span>

namespace pmr::casefile {

struct ShippedFile {
  const char* name;  // "Al2O3", or "contacts"
  const char* text;  // TOML
};
std::span<const ShippedFile> shipped_files();

}  // namespace pmr::casefile
