// Three roads for errors: the user's (CaseError), nature's or the solver's (NumericsError), and
// ours (ensure -> std::logic_error).
#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace pmr {

// One fault in the user's input. `where` is "file:line:column" or a file or option name.
struct Fault {
  std::string where;    // "cases/x.toml:12:3"
  std::string key;      // dotted key, may be empty
  std::string problem;  // what is wrong and what was wanted, one line
};

// "where: key: problem"
std::string to_string(const Fault& fault);

// The user's input is wrong: every fault found, together. Exit status 2.
class CaseError : public std::runtime_error {
 public:
  explicit CaseError(std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

// The simulation failed: what, where, when. Exit status 3, state saved by the caller.
class NumericsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws std::logic_error when a promise of ours is broken; on in every build, at stage borders.
// (Built-ins of both compilers: clang 14 has no std::source_location with libstdc++ 12.)
void ensure(bool holds, const char* promise, const char* file = __builtin_FILE(),
            int line = __builtin_LINE());

}  // namespace pmr
