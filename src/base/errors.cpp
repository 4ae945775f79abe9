#include "pmr/base/errors.hpp"

namespace pmr {

std::string to_string(const Fault& fault) {
  std::string text = fault.where;
  if (!fault.key.empty()) text += (text.empty() ? "" : ": ") + fault.key;
  return text + (text.empty() ? "" : ": ") + fault.problem;
}

namespace {
std::string joined(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) text += (text.empty() ? "" : "\n") + to_string(fault);
  return text;
}
}  // namespace

CaseError::CaseError(std::vector<Fault> faults)
    : std::runtime_error(joined(faults)), faults_(std::move(faults)) {}

void ensure(bool holds, const char* promise, const char* file, int line) {
  if (holds) return;
  throw std::logic_error(std::string(file) + ":" + std::to_string(line) +
                         ": broken promise: " + promise);
}

}  // namespace pmr
