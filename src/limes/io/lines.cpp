#include "limes/io/lines.h"

#include <algorithm>

#include "limes/core/text.h"

namespace limes {
namespace {

bool ends_line(char c) {
  return c == '\n' || c == '\r';
}

/// Number of bytes of the line end at the front: 2 for CRLF.
std::size_t line_end_size(std::string_view text) {
  return text.size() > 1 && text[0] == '\r' && text[1] == '\n' ? 2 : 1;
}

/// The line ends in a backslash: drop it and say so.
bool cut_continuation(std::string_view& line) {
  const std::string_view text = trim(line);
  if (text.empty() || text.back() != '\\' || text.front() == '#') return false;
  line = text.substr(0, text.size() - 1);
  return true;
}

}  // namespace

std::string_view checked_text(std::string_view bytes, std::string_view file) {
  using namespace std::string_view_literals;
  if (bytes.substr(0, 2) == "\xff\xfe"sv || bytes.substr(0, 2) == "\xfe\xff"sv)
    throw error_at(file, 1, "UTF-16 text; save it as UTF-8 or ASCII");
  const std::size_t nul = bytes.find('\0');
  if (nul != std::string_view::npos) {
    LineReader lines(bytes.substr(0, nul + 1));
    while (lines.next()) {
    }
    throw error_at(file, lines.number(), "NUL byte; a text file is expected here");
  }
  if (bytes.substr(0, 3) == "\xef\xbb\xbf"sv) bytes.remove_prefix(3);
  return bytes;
}

bool LineReader::next() {
  if (rest_.empty()) return false;
  const auto end = std::find_if(rest_.begin(), rest_.end(), ends_line);
  const auto length = static_cast<std::size_t>(end - rest_.begin());
  line_ = rest_.substr(0, length);
  rest_.remove_prefix(length);
  if (!rest_.empty()) rest_.remove_prefix(line_end_size(rest_));
  number_ = ++lines_read_;
  return true;
}

bool LineReader::next_joined() {
  if (!next()) return false;
  if (line_.empty() || line_.find('\\') == std::string_view::npos) return true;
  if (!cut_continuation(line_)) return true;
  const std::int64_t first = number_;
  std::string joined(line_);
  bool more = true;
  while (more && next()) {
    more = cut_continuation(line_);
    joined.append(" ").append(line_);
  }
  joined_ = std::move(joined);
  line_ = joined_;
  number_ = first;
  return true;
}

std::string_view WordReader::next() {
  while (!rest_.empty() && (is_blank(rest_[0]) || ends_line(rest_[0]))) {
    if (ends_line(rest_[0]))
      skip_line_end();
    else
      rest_.remove_prefix(1);
  }
  std::size_t length = 0;
  while (length < rest_.size() && !is_blank(rest_[length]) && !ends_line(rest_[length]))
    ++length;
  const std::string_view word = rest_.substr(0, length);
  rest_.remove_prefix(length);
  return word;
}

void WordReader::skip_line() {
  while (!rest_.empty() && !ends_line(rest_[0]))
    rest_.remove_prefix(1);
}

void WordReader::skip_line_end() {
  rest_.remove_prefix(line_end_size(rest_));
  ++line_;
}

}  // namespace limes
