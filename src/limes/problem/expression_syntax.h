#pragma once

#include <array>
#include <string>
#include <string_view>

namespace limes {

// The language of formulas, checked before muParser sees it: our names and nothing else, messages
// that say where, no assignment, no chains like 0 < x < 1 (which would mean something unexpected).

struct FormulaFunction {
  std::string_view name;
  int fewest, most;  ///< number of values it takes
};

inline constexpr int any_number = 1000;
inline constexpr std::array formula_functions{
    FormulaFunction{"abs", 1, 1},          FormulaFunction{"acos", 1, 1},
    FormulaFunction{"asin", 1, 1},         FormulaFunction{"atan", 1, 1},
    FormulaFunction{"atan2", 2, 2},        FormulaFunction{"ceil", 1, 1},
    FormulaFunction{"cos", 1, 1},          FormulaFunction{"cosh", 1, 1},
    FormulaFunction{"exp", 1, 1},          FormulaFunction{"floor", 1, 1},
    FormulaFunction{"hypot", 2, 2},        FormulaFunction{"log", 1, 1},
    FormulaFunction{"log10", 1, 1},        FormulaFunction{"max", 1, any_number},
    FormulaFunction{"min", 1, any_number}, FormulaFunction{"pow", 2, 2},
    FormulaFunction{"round", 1, 1},        FormulaFunction{"sign", 1, 1},
    FormulaFunction{"sin", 1, 1},          FormulaFunction{"sinh", 1, 1},
    FormulaFunction{"sqrt", 1, 1},         FormulaFunction{"tan", 1, 1},
    FormulaFunction{"tanh", 1, 1}};

/// Operators of our own in muParser's text.
inline constexpr std::string_view parser_equal = "##";    ///< == within a tolerance
inline constexpr std::string_view parser_unequal = "#%";  ///< != within a tolerance
inline constexpr std::string_view parser_not = "~";       ///< 'not': weaker than comparisons
inline constexpr std::string_view parser_negate = "!";    ///< '!': as strong as a sign

struct CheckedFormula {
  std::string parser_text;  ///< the same formula in muParser's terms
  bool constant;            ///< x, y, z do not occur
};

/// @throws InputError "formula 'x = 1', character 3: what is wrong; what would be right"
[[nodiscard]] CheckedFormula check_formula(std::string_view text);

}  // namespace limes
