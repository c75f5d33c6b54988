#include "limes/study/selection.h"

#include <array>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/study/expression.h"
#include "limes/study/nearest.h"

namespace limes {
namespace {

VertexId parse_vertex(std::string_view word) {
  const auto number = parse_integer(word);
  if (!number || *number < 0 || *number > std::numeric_limits<std::int32_t>::max())
    throw InputError("{} is no vertex; they count from 0, as in vertex:12", quote(word));
  return VertexId(*number);
}

/// A word with a colon that is no formula: group:, part:, vertex: or a misspelt one of them.
std::optional<Where> parse_prefixed(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || text.find('?') < colon) return std::nullopt;
  const std::string_view prefix = trim(text.substr(0, colon));
  const std::string_view rest = trim(text.substr(colon + 1));
  Where where;
  where.text = text;
  if (prefix == "vertex") {
    where.kind = Where::Kind::vertex;
    where.vertex = parse_vertex(rest);
    return where;
  }
  if (prefix != "group" && prefix != "part") {
    constexpr std::array<std::string_view, 3> known{"group", "part", "vertex"};
    throw InputError("{} selects nothing; {}", quote(text), suggest(prefix, known));
  }
  if (rest.empty()) throw InputError("{} lacks a name after the colon", quote(text));
  where.kind = prefix == "group" ? Where::Kind::group : Where::Kind::part;
  where.name = rest;
  return where;
}

bool is_word(std::string_view text) {
  for (const char c : text)
    if (!(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z')) return false;
  return true;
}

}  // namespace

Where parse_where(std::string_view text) {
  text = trim(text);
  constexpr std::array<std::string_view, 5> words{"all", "boundary", "group:NAME", "part:NAME",
                                                  "vertex:NUMBER"};
  if (text.empty())
    throw InputError("an empty text selects nothing; a condition such as x == 0, or \"all\", does");
  if (auto where = parse_prefixed(text)) return *where;
  Where where;
  where.text = text;
  if (text == "all") return where;
  where.kind = text == "boundary" ? Where::Kind::boundary : Where::Kind::condition;
  if (text == "boundary") return where;
  if (is_word(text))
    throw InputError("{} selects nothing; {}, or a condition such as x == 0", quote(text),
                     suggest(text, words));
  (void)Expression(text);
  return where;
}

}  // namespace limes
