// Settings with expressions in them.
#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "study/study.hpp"

namespace pmr::study {

using Values = std::map<std::string, double>;  // of constants, variables and what follows from them

// Value of an expression; std::invalid_argument, with one line, where there is none.
double evaluated(const std::string& formula, const Values& values);

// Adds the values of named formulas to what is known, in whatever order they are written.
// std::invalid_argument where one has none.
void derive(std::vector<std::pair<std::string, std::string>> formulas, Values& known);

// The text with each ${expression} replaced by its value, all digits written.
std::string filled(const std::string& text, const Values& values);

// "key=VALUE" as `--set` takes it, with its expressions evaluated.
std::string filled(const Setting& setting, const Values& values);

}  // namespace pmr::study
