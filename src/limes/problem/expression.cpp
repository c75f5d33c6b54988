#include "limes/problem/expression.h"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/problem/expression_syntax.h"

namespace limes {
namespace {

// muParser hands no context to an operator, so the tolerance of the formula that this thread is
// evaluating waits here.
thread_local double equal_within_now = 0;

double equal(double a, double b) {
  return a == b || std::abs(a - b) <= equal_within_now ? 1 : 0;
}
double unequal(double a, double b) {
  return 1 - equal(a, b);
}
double negation(double a) {
  return a == 0 ? 1 : 0;
}
double sign(double a) {
  return a > 0 ? 1 : a < 0 ? -1 : 0;
}
double smallest(const double* values, int count) {
  return *std::min_element(values, values + count);
}
double largest(const double* values, int count) {
  return *std::max_element(values, values + count);
}

using Function1 = double (*)(double);
using Function2 = double (*)(double, double);

void define_functions(mu::Parser& parser) {
  parser.ClearFun();
  parser.DefineFun("abs", static_cast<Function1>(std::abs));
  parser.DefineFun("acos", static_cast<Function1>(std::acos));
  parser.DefineFun("asin", static_cast<Function1>(std::asin));
  parser.DefineFun("atan", static_cast<Function1>(std::atan));
  parser.DefineFun("atan2", static_cast<Function2>(std::atan2));
  parser.DefineFun("ceil", static_cast<Function1>(std::ceil));
  parser.DefineFun("cos", static_cast<Function1>(std::cos));
  parser.DefineFun("cosh", static_cast<Function1>(std::cosh));
  parser.DefineFun("exp", static_cast<Function1>(std::exp));
  parser.DefineFun("floor", static_cast<Function1>(std::floor));
  parser.DefineFun("hypot", static_cast<Function2>(std::hypot));
  parser.DefineFun("log", static_cast<Function1>(std::log));
  parser.DefineFun("log10", static_cast<Function1>(std::log10));
  parser.DefineFun("max", largest);
  parser.DefineFun("min", smallest);
  parser.DefineFun("pow", static_cast<Function2>(std::pow));
  parser.DefineFun("round", static_cast<Function1>(std::round));
  parser.DefineFun("sign", sign);
  parser.DefineFun("sin", static_cast<Function1>(std::sin));
  parser.DefineFun("sinh", static_cast<Function1>(std::sinh));
  parser.DefineFun("sqrt", static_cast<Function1>(std::sqrt));
  parser.DefineFun("tan", static_cast<Function1>(std::tan));
  parser.DefineFun("tanh", static_cast<Function1>(std::tanh));
}

void define_operators(mu::Parser& parser) {
  parser.DefineOprt(std::string(parser_equal), equal, mu::prCMP);
  parser.DefineOprt(std::string(parser_unequal), unequal, mu::prCMP);
  parser.DefineInfixOprt(std::string(parser_not), negation, mu::prCMP - 1);
  parser.DefineInfixOprt(std::string(parser_negate), negation);
}

}  // namespace

struct Expression::Formula {
  mu::Parser parser;
  double x = 0, y = 0, z = 0;
  double equal_within;

  Formula(const std::string& parser_text, double tolerance) : equal_within(tolerance) {
    define_functions(parser);
    define_operators(parser);
    parser.ClearConst();
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineVar("x", &x);
    parser.DefineVar("y", &y);
    parser.DefineVar("z", &z);
    parser.EnableOptimizer(false);  // the operations as written, in their order
    parser.SetExpr(parser_text);
  }

  double evaluate() const {
    equal_within_now = equal_within;
    return parser.Eval();
  }
};

Expression::Expression() : Expression(0.0) {}

Expression::Expression(double value) : text_(format_real(value)), constant_(value) {}

Expression::Expression(std::string_view text, double equal_within) : text_(text) {
  if (const auto value = parse_real(trim(text))) {
    constant_ = *value;
    return;
  }
  const CheckedFormula checked = check_formula(text);
  try {
    formula_ = std::make_shared<Formula>(checked.parser_text, equal_within);
    constant_ = formula_->evaluate();
  } catch (const mu::ParserError& error) {
    throw InputError("formula {}: {}", quote(text), error.GetMsg());
  }
  if (!checked.constant) return;
  formula_ = nullptr;
  if (!std::isfinite(constant_)) throw InputError("formula {} has no finite value", quote(text));
}

double Expression::operator()(const Vec3& x) const {
  if (!formula_) return constant_;
  formula_->x = x.x();
  formula_->y = x.y();
  formula_->z = x.z();
  return formula_->evaluate();
}

bool Expression::is_zero() const {
  return !formula_ && constant_ == 0;
}

}  // namespace limes
