#include "limes/problem/expression_syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/problem/suggest.h"

namespace limes {
namespace {

enum class TokenKind { number, name, symbol, end };

struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;
  std::size_t begin = 0;
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_name_start(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_name(char c) {
  return is_name_start(c) || is_digit(c);
}
bool is_comparison(std::string_view op) {
  return op == "==" || op == "!=" || op == "<" || op == ">" || op == "<=" || op == ">=";
}

/// Reads a formula once from left to right, alternately waiting for a value and for an operator.
class Checker {
 public:
  explicit Checker(std::string_view text) : text_(text) {}
  CheckedFormula run();

 private:
  /// A pair of parentheses, or the formula itself.
  struct Level {
    const FormulaFunction* function = nullptr;  // whose values these are
    std::size_t begin = 0;
    int commas = 0;
    int open_questions = 0;   // '?' without its ':'
    bool comparison = false;  // since the last and, or, comma, '?', ':'
  };

  [[noreturn]] void fail(std::size_t at, std::string_view what) const;
  Token next_token();
  Token number_token();
  [[nodiscard]] std::string_view symbol_at(std::size_t at) const;
  void take_value(const Token& token);
  void take_name(const Token& token);
  void take_operator(const Token& token);
  void take_comma(const Token& token);
  void open(const FormulaFunction* function, std::size_t at);
  void close(const Token& token);
  void finish(const Token& token) const;
  void put(std::string_view parser_text) { out_.append(parser_text).push_back(' '); }

  std::string_view text_;
  std::size_t at_ = 0;
  bool wants_value_ = true;
  bool after_sign_ = false;
  bool constant_ = true;
  std::vector<Level> levels_{1};
  std::string out_;
};

void Checker::fail(std::size_t at, std::string_view what) const {
  throw InputError("formula {}, character {}: {}", quote(text_), at + 1, what);
}

std::string_view Checker::symbol_at(std::size_t at) const {
  for (const std::string_view two : {"==", "!=", "<=", ">=", "&&", "||"})
    if (text_.substr(at, 2) == two) return two;
  const std::string_view one = text_.substr(at, 1);
  if (one == "=") fail(at, "'=' assigns nothing here; == compares");
  if (one == "&" || one == "|")
    fail(at, fmt::format("'{}' is no operator; and, or, && and || are", one));
  if (one == "*" && text_.substr(at, 2) == "**") fail(at, "'**' is no operator; ^ is the power");
  if (std::string_view("+-*/^()<>!,?:").find(one) == std::string_view::npos)
    fail(at, fmt::format("{} has no meaning in a formula", quote(one)));
  return one;
}

Token Checker::number_token() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.'))
    ++at_;
  std::size_t exponent = at_;
  if (exponent < text_.size() && (text_[exponent] == 'e' || text_[exponent] == 'E')) {
    ++exponent;
    if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
    if (exponent < text_.size() && is_digit(text_[exponent])) {
      at_ = exponent;
      while (at_ < text_.size() && is_digit(text_[at_]))
        ++at_;
    }
  }
  if (at_ < text_.size() && (is_name(text_[at_]) || text_[at_] == '.')) {
    std::size_t end = at_;
    while (end < text_.size() && (is_name(text_[end]) || text_[end] == '.'))
      ++end;
    fail(begin, fmt::format("{} is no number; a product is written with *",
                            quote(text_.substr(begin, end - begin))));
  }
  return {TokenKind::number, text_.substr(begin, at_ - begin), begin};
}

Token Checker::next_token() {
  while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '\n' || text_[at_] == '\r'))
    ++at_;
  const std::size_t begin = at_;
  if (begin == text_.size()) return {TokenKind::end, {}, begin};
  if (is_digit(text_[at_]) || text_[at_] == '.') return number_token();
  if (!is_name_start(text_[at_])) {
    const std::string_view symbol = symbol_at(begin);
    at_ += symbol.size();
    return {TokenKind::symbol, symbol, begin};
  }
  while (at_ < text_.size() && is_name(text_[at_]))
    ++at_;
  const std::string_view name = text_.substr(begin, at_ - begin);
  if (name == "and") return {TokenKind::symbol, "&&", begin};
  if (name == "or") return {TokenKind::symbol, "||", begin};
  if (name == "not") return {TokenKind::symbol, "not", begin};
  return {TokenKind::name, name, begin};
}

/// A name where a value is due: a variable, pi, or a function with its parenthesis.
void Checker::take_name(const Token& token) {
  if (token.text == "x" || token.text == "y" || token.text == "z" || token.text == "pi") {
    constant_ = constant_ && token.text == "pi";
    put(token.text);
    wants_value_ = false;
    return;
  }
  const auto function =
      std::find_if(formula_functions.begin(), formula_functions.end(),
                   [&](const FormulaFunction& f) { return f.name == token.text; });
  if (function == formula_functions.end()) {
    std::vector<std::string_view> known{"pi", "and", "or", "not"};
    for (const FormulaFunction& f : formula_functions)
      known.push_back(f.name);
    std::string hint = suggest(token.text, known);
    if (hint.rfind("did", 0) != 0)
      hint = "known are x, y, z, pi and functions such as sin, sqrt, max";
    else
      hint = "the variables are x, y, z; " + hint;
    fail(token.begin, fmt::format("unknown name {}; {}", quote(token.text), hint));
  }
  const Token bracket = next_token();
  if (bracket.text != "(")
    fail(token.begin, fmt::format("{0} is a function; write {0}(...)", token.text));
  out_ += token.text;  // muParser wants the parenthesis right after the name
  open(&*function, bracket.begin);
}

void Checker::take_value(const Token& token) {
  const bool prefix =
      token.text == "-" || token.text == "+" || token.text == "!" || token.text == "not";
  if (token.kind == TokenKind::number) {
    const std::optional<double> value = parse_real(token.text);
    if (!value) fail(token.begin, fmt::format("{} is no finite number", quote(token.text)));
    put(format_real(*value));
    wants_value_ = false;
  } else if (token.kind == TokenKind::name) {
    take_name(token);
  } else if (token.text == "(") {
    open(nullptr, token.begin);
  } else if (prefix && !after_sign_) {
    put(token.text == "not" ? parser_not : token.text == "!" ? parser_negate : token.text);
    after_sign_ = true;
    return;
  } else if (prefix) {
    fail(token.begin, fmt::format("'{}' follows another sign; use parentheses", token.text));
  } else if (token.kind == TokenKind::end) {
    fail(token.begin, "the formula ends where a value is due");
  } else {
    fail(token.begin, fmt::format("'{}' stands where a value is due", token.text));
  }
  after_sign_ = false;
}

void Checker::open(const FormulaFunction* function, std::size_t at) {
  constexpr std::size_t deepest = 200;
  if (levels_.size() > deepest) fail(at, fmt::format("more than {} parentheses are open", deepest));
  levels_.push_back({.function = function, .begin = at});
  put("(");
  wants_value_ = true;
}

void Checker::close(const Token& token) {
  const Level level = levels_.back();
  if (levels_.size() == 1) fail(token.begin, "')' closes nothing");
  if (level.open_questions) fail(token.begin, "')' stands before the ':' of a '?'");
  const int given = level.commas + 1;
  if (level.function && (given < level.function->fewest || given > level.function->most))
    fail(level.begin,
         fmt::format("{} takes {} value{}, not {}", level.function->name, level.function->fewest,
                     level.function->fewest > 1 ? "s" : "", given));
  levels_.pop_back();
  put(")");
}

void Checker::take_comma(const Token& token) {
  Level& level = levels_.back();
  if (!level.function)
    fail(token.begin, "a comma separates the values of a function only; decimals have a point");
  if (level.open_questions) fail(token.begin, "',' stands before the ':' of a '?'");
  ++level.commas;
  level.comparison = false;
  put(",");
  wants_value_ = true;
}

void Checker::take_operator(const Token& token) {
  const std::string_view op = token.text;
  Level& level = levels_.back();
  if (op == ")") return close(token);
  if (op == ",") return take_comma(token);
  if (token.kind != TokenKind::symbol || op == "(" || op == "!" || op == "not")
    fail(token.begin, fmt::format("{} stands where an operator is due", quote(op)));
  if (is_comparison(op)) {
    if (level.comparison) fail(token.begin, "comparisons form no chains; write '0 < x and x < 1'");
    level.comparison = true;
  } else if (op == "&&" || op == "||" || op == "?" || op == ":") {
    level.comparison = false;
  }
  if (op == "?") ++level.open_questions;
  if (op == ":" && level.open_questions-- == 0) fail(token.begin, "':' has no '?' before it");
  put(op == "==" ? parser_equal : op == "!=" ? parser_unequal : op);
  wants_value_ = true;
}

void Checker::finish(const Token& token) const {
  if (levels_.size() > 1) fail(levels_.back().begin, "'(' is never closed");
  if (levels_.back().open_questions) fail(token.begin, "the formula ends before the ':' of a '?'");
}

CheckedFormula Checker::run() {
  constexpr std::size_t longest = 2000;
  if (text_.size() > longest)
    throw InputError("formula {} has {} characters; {} are allowed", quote(text_), text_.size(),
                     longest);
  for (;;) {
    const Token token = next_token();
    if (wants_value_) {
      take_value(token);
    } else if (token.kind == TokenKind::end) {
      finish(token);
      return {out_, constant_};
    } else {
      take_operator(token);
    }
  }
}

}  // namespace

CheckedFormula check_formula(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), [](char c) { return is_blank(c); }))
    throw InputError("an empty text is no formula");
  return Checker(text).run();
}

}  // namespace limes
