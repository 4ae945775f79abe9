#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "pmr/base/constants.hpp"
#include "statistics/expression.hpp"

using namespace pmr::statistics;

namespace {

double value(const std::string& formula, std::vector<double> xy = {3.0, 2.0}) {
  return Expression(formula, {"x", "y"})(xy);
}

std::string problem(const std::string& formula, const std::vector<std::string>& variables) {
  try {
    const Expression expression(formula, variables);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("A formula has the value that school gives it, at x = 3 and y = 2") {
  CHECK(value("1 + x*y - 4/y") == 5.0);
  CHECK(value("x - y - 1") == 0.0);
  CHECK(value("x / y / 2") == 0.75);
  CHECK(value("-x^2") == -9.0);
  CHECK(value("2^3^y") == 512.0);
  CHECK(value("2^-1 * x") == 1.5);
  CHECK(value("x - -+-y") == 1.0);
  CHECK(value("2 * -x") == -6.0);
  CHECK(value("(x + y) * (x - y)") == 5.0);
  CHECK(value("1.5e3 + .5 + 2. + 1E-3 + 1.e1") == Approx(1512.501).epsilon(1e-15));
  CHECK(value("min(x, y, 7) + max(x, y) + min(x)") == 8.0);
  CHECK(value("abs(-x) + sqrt(4) + log10(1000)") == Approx(8.0).epsilon(1e-15));
  CHECK(value("exp(log(x))") == Approx(3.0).epsilon(1e-15));
  CHECK(value("cbrt(-27)") == Approx(-3.0).epsilon(1e-15));
  CHECK(value("27^(1/3)") == Approx(3.0).epsilon(1e-15));
  CHECK(value("4") == 4.0);
}

TEST_CASE("Names may be capitals, reserved words, functions or have points") {
  // t and T are two; "and", "if", "e_" and "sum" mean something to the parser behind.
  CHECK(Expression("T - t", {"t", "T"})(std::vector{1.0, 5.0}) == 4.0);
  CHECK(Expression("and * if + e_ - sum",
                   {"and", "if", "e_", "sum"})(std::vector{2.0, 3.0, 4.0, 5.0}) == 5.0);
  CHECK(Expression("bed.height / V0", {"V0", "bed.height"})(std::vector{2.0, 3.0}) == 1.5);
  CHECK(Expression("min(min, exp) + exp(0)", {"min", "exp"})(std::vector{2.0, 3.0}) == 3.0);
}

TEST_CASE("An expression knows the variables it uses") {
  const Expression expression("c + a*a", {"a", "b", "c"});
  CHECK(expression.variables_used() == std::vector<std::size_t>{0, 2});
  CHECK(expression(std::vector{2.0, pmr::nan, 1.0}) == 5.0);
  CHECK(Expression("7", {"a"}).variables_used().empty());
}

TEST_CASE("A value that is no finite number is not a number") {
  for (const char* formula :
       {"log(-x)", "x/0", "sqrt(-x)", "(-8)^(1/3)", "0/0", "exp(1000*x)", "max(x, log(-1) + y)"})
    CHECK(std::isnan(value(formula)));
  CHECK(std::isnan(value("max(x, y)", {1.0, pmr::nan})));
  CHECK(std::isnan(value("min(x, y)", {pmr::nan, 1.0})));
}

TEST_CASE("What is wrong with a formula is said in one line with its place") {
  const std::vector<std::string> names = {"yield", "cost"};
  CHECK(problem("yield*costs", names) ==
        "'yield*costs': no variable is named 'costs'; there is yield, cost");
  CHECK(problem("Yield", names) == "'Yield': no variable is named 'Yield'; there is yield, cost");
  CHECK(problem("x", {}) == "'x': no variable is named 'x'; there are none");
  CHECK(problem("sin(cost)", names) ==
        "'sin(cost)': no function is named 'sin'; there is abs, "
        "cbrt, exp, log, log10, max, min, sqrt");
  CHECK(problem("yield(2)", names).find("no function is named 'yield'") != std::string::npos);
  CHECK(problem("2*(cost", names) == "'2*(cost': the bracket opened at character 3 is not closed");
  CHECK(problem("cost)*2", names) == "'cost)*2': the bracket closed at character 5 was not opened");
  CHECK(problem("cost *", names) ==
        "'cost *': a number, a name or '(' is wanted instead of the end");
  CHECK(problem("", names) == "'': a number, a name or '(' is wanted instead of the end");
  CHECK(problem("2cost", names) == "'2cost': an operator is wanted instead of 'c' at character 2");
  CHECK(problem("cost := 2", names) ==
        "'cost := 2': an operator is wanted instead of ':' at character 6");
  CHECK(problem("(cost, 2)", names) ==
        "'(cost, 2)': an operator or ')' is wanted instead of ',' at character 6");
  CHECK(problem("sqrt(cost, 2)", names) == "'sqrt(cost, 2)': sqrt takes one argument, not 2");
  CHECK(problem("min()", names) ==
        "'min()': a number, a name or '(' is wanted instead of ')' at character 5");
  CHECK(problem("1e999", names) == "'1e999': the number at character 1 is beyond all bounds");
  CHECK(problem("log", names).find("no variable is named 'log'") != std::string::npos);
  CHECK(problem("yield ^ cost", names) == "none");
}
