// A formula that the user writes, such as "yield / (1 + cost^2)".
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace pmr::statistics {

// A real function of named variables: numbers, names, brackets, + - * / ^ and abs, cbrt, exp, log
// (natural), log10, max, min (one argument or more), sqrt. -x^2 is -(x^2), 2^3^2 is 2^(3^2).
// A name is letters, digits, underscores and inner points, not starting with a digit; capitals
// count. A name before a bracket is a function, any other a variable: "min(min, x)" is well said.
class Expression {
 public:
  // Throws std::invalid_argument, one line, when the formula is none or names unknown variables.
  Expression(const std::string& formula, const std::vector<std::string>& variables);

  // Value for the values of all variables in the order of the list; NaN where the value, a
  // function's argument or a used variable is no finite number (log(-1), max(1, 1/0), (-8)^(1/3)).
  // One thread at a time.
  double operator()(std::span<const double> values) const;

  // Places in the list of variables that the formula names, rising.
  const std::vector<std::size_t>& variables_used() const;

 private:
  struct Compiled;
  std::shared_ptr<const Compiled> compiled_;
};

}  // namespace pmr::statistics
