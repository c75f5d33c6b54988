#include "limes/problem/expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <locale>
#include <string>
#include <thread>
#include <vector>

#include "limes/core/error.h"
#include "limes/problem/expression_syntax.h"

namespace limes {
namespace {

constexpr double pi = 3.14159265358979323846;

struct Case {
  std::string text;
  std::function<double(double, double, double)> truth;
};

#define SAME(formula)                                                                                                    \
  Case {                                                                                                                 \
#formula, [](double x, double y, double z) -> double { (void)x, (void)y, (void)z; using namespace std; return formula; } \
  }

const std::vector<Vec3>& samples() {
  static const std::vector<Vec3> points{{0, 0, 0},         {1, 2, 3},      {-0.5, 0.25, 1e-3},
                                        {0.1, -0.7, 0.99}, {3.5, -2, 0.5}, {-1, -1, -1}};
  return points;
}

void expect_same(double value, double truth, const std::string& text, const Vec3& p) {
  if (std::isnan(truth))
    EXPECT_TRUE(std::isnan(value)) << text << " at " << p.transpose();
  else
    EXPECT_EQ(value, truth) << text << " at " << p.transpose();
}

// The same text means the same to a C++ compiler and to us, to the last bit.
TEST(Expression, AgreesWithTheCompiler) {
  const std::vector<Case> cases{SAME(x),
                                SAME(x + y * z),
                                SAME(x - y - z),
                                SAME(x / y / z),
                                SAME(2 * x * 3 / 7),
                                SAME(-x * -y),
                                SAME(x * (y - z) + (x)),
                                SAME(+x),
                                SAME(1e-3 * x + .5 - 2.),
                                SAME(1.5E+2 * y),
                                SAME(1e-300 * z),
                                SAME(sin(pi * x) * cos(y) + tan(z)),
                                SAME(asin(x) + acos(y) - atan(z)),
                                SAME(atan2(y, x)),
                                SAME(sinh(x) + cosh(y) * tanh(z)),
                                SAME(exp(-x * x) + log(y)),
                                SAME(log10(z)),
                                SAME(sqrt(x)),
                                SAME(abs(x) + floor(y) - ceil(z)),
                                SAME(round(2 * x)),
                                SAME(hypot(x, y)),
                                SAME(pow(x, 3)),
                                SAME(max(x, y)),
                                SAME(min(x, y)),
                                SAME(x < y),
                                SAME(x <= y),
                                SAME(x > y),
                                SAME(x >= 0),
                                SAME(x == 1),
                                SAME(x != 1),
                                SAME(x == 0 || y > 1),

                                SAME(!(x > 0)),
                                SAME(!x == 0),
                                SAME(x > 0 ? y : z),
                                SAME(x > 0 ? y > 0 ? 1 : 2 : 3),
                                SAME(x > 0   ? 1
                                     : y > 0 ? 2
                                             : 3),
                                SAME(x + 1 < y * 2 && !(z == 3)),
                                SAME(0.5 && 0.25),
                                SAME(x - -y),
                                SAME(x * -2),
                                SAME(1 / x),
                                SAME(x == -1 && y == -1),
                                SAME((((x)))),
                                SAME(2 > 1 ? x : y)};
  for (const Case& c : cases) {
    const Expression e(c.text);
    for (const Vec3& p : samples())
      expect_same(e(p), c.truth(p.x(), p.y(), p.z()), c.text, p);
  }
}

// What C++ writes otherwise, or not at all.
TEST(Expression, WordsPowersAndVariadicFunctions) {
  const std::vector<Case> cases{
      {"x == 0 or y > 1", [](double x, double y, double) { return x == 0 || y > 1; }},
      {"x < 0 && y < 0 || z > 0",
       [](double x, double y, double z) { return (x < 0 && y < 0) || z > 0; }},
      {"x < 0 or y < 0 and z > 0",
       [](double x, double y, double z) { return x < 0 || (y < 0 && z > 0); }},
      {"x > 0 and not y > 1", [](double x, double y, double) { return x > 0 && !(y > 1); }},
      {"not x == 0", [](double x, double, double) { return !(x == 0); }},
      {"not x == 1 and y == 2", [](double x, double y, double) { return !(x == 1) && y == 2; }},
      {"not (x == 1 or y == 2)", [](double x, double y, double) { return !(x == 1 || y == 2); }},
      {"(x>0)and(y>0)", [](double x, double y, double) { return x > 0 && y > 0; }},
      {"x^2", [](double x, double, double) { return std::pow(x, 2); }},
      {"-x^2", [](double x, double, double) { return -std::pow(x, 2); }},
      {"2^-y", [](double, double y, double) { return std::pow(2, -y); }},
      {"2^3^x", [](double x, double, double) { return std::pow(2, std::pow(3, x)); }},
      {"max(x, y, z, 0)",
       [](double x, double y, double z) {
         return std::max({x, y, z, 0.0});
       }},
      {"min(x, y, z)",
       [](double x, double y, double z) {
         return std::min({x, y, z});
       }},
      {"max(x)", [](double x, double, double) { return x; }},
      {"sign(x)", [](double x, double, double) { return x > 0   ? 1.0
                                                        : x < 0 ? -1.0
                                                                : 0.0; }},
      {"2\n * x", [](double x, double, double) { return 2 * x; }},
  };
  for (const Case& c : cases) {
    const Expression e(c.text);
    for (const Vec3& p : samples())
      expect_same(e(p), c.truth(p.x(), p.y(), p.z()), c.text, p);
  }
}

TEST(Expression, EveryFunctionOfTheTableIsKnownToTheParser) {
  for (const FormulaFunction& f : formula_functions) {
    std::string text = std::string(f.name) + "(x";
    for (int i = 1; i < f.fewest; ++i)
      text += ", x";
    const Expression e(text + ")");
    EXPECT_TRUE(std::isfinite(e(Vec3(0.5, 0, 0)))) << text;
  }
}

TEST(Expression, EqualMeansWithinTheTolerance) {
  const Expression equal("x == 0.3", 1e-9);
  EXPECT_EQ(equal(Vec3(0.1 + 0.2, 0, 0)), 1);
  EXPECT_EQ(equal(Vec3(0.3 + 0.9e-9, 0, 0)), 1);
  EXPECT_EQ(equal(Vec3(0.3 + 1.1e-9, 0, 0)), 0);
  const Expression unequal("x != 0.3", 1e-9);
  EXPECT_EQ(unequal(Vec3(0.3 + 0.9e-9, 0, 0)), 0);
  EXPECT_EQ(unequal(Vec3(0.3 + 1.1e-9, 0, 0)), 1);
  EXPECT_EQ(Expression("x == 0.3")(Vec3(0.1 + 0.2, 0, 0)), 0) << "no tolerance unless asked for";
  // each expression keeps its own
  const Expression wide("x == 0", 1);
  EXPECT_EQ(wide(Vec3(0.5, 0, 0)), 1);
  EXPECT_EQ(equal(Vec3(0.5, 0, 0)), 0);
  EXPECT_EQ(wide(Vec3(0.5, 0, 0)), 1);
  EXPECT_EQ(Expression("1 == 1.5", 1)(Vec3::Zero()), 1);
}

TEST(Expression, ConstantsAreConstants) {
  EXPECT_TRUE(Expression().is_zero());
  EXPECT_EQ(Expression().text(), "0");
  EXPECT_EQ(Expression()(Vec3(1, 2, 3)), 0);
  EXPECT_EQ(Expression(2.5)(Vec3(1, 2, 3)), 2.5);
  EXPECT_EQ(Expression(0.1).text(), "0.1");
  EXPECT_TRUE(Expression("0.0").is_zero());
  EXPECT_TRUE(Expression("1 - 1").is_zero());
  EXPECT_TRUE(Expression(" -0 ").is_zero());
  EXPECT_FALSE(Expression("1e-300").is_zero());
  EXPECT_FALSE(Expression("0 * x").is_zero()) << "a formula may be anything";
  EXPECT_EQ(Expression("2 * pi")(Vec3::Zero()), 2 * pi);
  EXPECT_EQ(Expression("x + 1").text(), "x + 1");
}

TEST(Expression, CopiesAreIndependentInValue) {
  const Expression a("x + y");
  const Expression b = a;
  EXPECT_EQ(a(Vec3(1, 2, 0)), 3);
  EXPECT_EQ(b(Vec3(5, 2, 0)), 7);
  EXPECT_EQ(a(Vec3(1, 2, 0)), 3);
}

TEST(Expression, DifferentExpressionsRunInDifferentThreads) {
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([t, &wrong] {
      const double tolerance = 0.1 * (t + 1);
      const Expression e("x == 0 and y > -1", tolerance);
      for (int i = 0; i < 2000; ++i) {
        const double x = 0.0003 * i;
        if (e(Vec3(x, 0, 0)) != (x <= tolerance)) ++wrong[static_cast<std::size_t>(t)];
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

TEST(Expression, LocaleDoesNotMatter) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  const double value = Expression("0.5 * x")(Vec3(1, 0, 0));
  std::locale::global(before);
  EXPECT_EQ(value, 0.5);
}

struct Wrong {
  const char* text;
  int character;      // 1-based
  const char* words;  // of the message
};

TEST(Expression, MessagesSayWhereAndWhat) {
  const std::vector<Wrong> wrong{
      {"x = 1", 3, "== compares"},
      {"x + foo", 5, "unknown name 'foo'; known are x, y, z, pi"},
      {"2 * sine(x)", 5, "unknown name 'sine'; the variables are x, y, z; did you mean 'sin'?"},
      {"sqr(x)", 1, "did you mean 'sqrt'?"},
      {"SIN(x)", 1, "did you mean 'sin'?"},
      {"_pi", 1, "did you mean 'pi'?"},
      {"t", 1, "known are x, y, z, pi"},
      {"2x", 1, "'2x' is no number; a product is written with *"},
      {"1.2.3", 1, "'1.2.3' is no finite number"},
      {"0x10 + x", 1, "'0x10' is no number"},
      {"1e999 * x", 1, "'1e999' is no finite number"},
      {"2e", 1, "'2e' is no number"},
      {"x**2", 2, "^ is the power"},
      {"x & y", 3, "and, or, && and || are"},
      {"x +", 4, "ends where a value is due"},
      {"x + * y", 5, "'*' stands where a value is due"},
      {"x y", 3, "'y' stands where an operator is due"},
      {"3 (x)", 3, "'(' stands where an operator is due"},
      {"x not y", 3, "'not' stands where an operator is due"},
      {"x!", 2, "'!' stands where an operator is due"},
      {"(x + 1", 1, "'(' is never closed"},
      {"x + 1)", 6, "')' closes nothing"},
      {"()", 2, "')' stands where a value is due"},
      {"sin", 1, "sin is a function; write sin(...)"},
      {"sin x", 1, "sin is a function"},
      {"sin(x, y)", 4, "sin takes 1 value, not 2"},
      {"atan2(x)", 6, "atan2 takes 2 values, not 1"},
      {"max()", 5, "')' stands where a value is due"},
      {"1,5 * x", 2, "decimals have a point"},
      {"0 < x < 1", 7, "write '0 < x and x < 1'"},
      {"x == y == z", 8, "comparisons form no chains"},
      {"x > 0 ? 1", 10, "ends before the ':'"},
      {"x : 1", 3, "':' has no '?' before it"},
      {"(x > 0 ? 1) : 2", 11, "')' stands before the ':'"},
      {"--x", 2, "'-' follows another sign; use parentheses"},
      {"x; y", 2, "';' has no meaning in a formula"},
      {"\"x\"", 1, "has no meaning in a formula"},
      {"x # y", 3, "'#' has no meaning"},
      {"~x", 1, "'~' has no meaning"},
      {"x \xc3\xa4", 3, "has no meaning in a formula"},
  };
  for (const Wrong& w : wrong) {
    try {
      const Expression e(w.text);
      ADD_FAILURE() << w.text << " was accepted";
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(", character " + std::to_string(w.character) + ": "),
                std::string::npos)
          << message;
      EXPECT_NE(message.find(w.words), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

TEST(Expression, RefusesWhatHasNoValueOrIsTooLong) {
  EXPECT_THROW(Expression(""), InputError);
  EXPECT_THROW(Expression("  "), InputError);
  EXPECT_THROW(Expression("1 / 0"), InputError);
  EXPECT_THROW(Expression("sqrt(-1)"), InputError);
  EXPECT_THROW(Expression("nan"), InputError);
  EXPECT_THROW(Expression("inf"), InputError);
  std::string sum = "x";
  while (sum.size() < 2000)
    sum += "+x";
  EXPECT_THROW(Expression{sum}, InputError);
  EXPECT_THROW(Expression(std::string(300, '(') + "x" + std::string(300, ')')), InputError);
  EXPECT_EQ(Expression(std::string(150, '(') + "x" + std::string(150, ')'))(Vec3(7, 0, 0)), 7);
}

}  // namespace
}  // namespace limes
