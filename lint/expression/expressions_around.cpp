#include <algorithm>

#include "lint/expression/source_expression.hpp"
#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// The longest expression that is read.
constexpr std::size_t most_bytes = 600;

bool is_open(char c) {
  return c == '(' || c == '[';
}
bool is_close(char c) {
  return c == ')' || c == ']';
}

/// Whether a character ends an expression at any depth.
bool ends_statement(char c) {
  return is_one_of(c, ";{}\"`$\\@");
}

/// Whether the line that ends here continues in the next one.
bool continues(std::string_view text, std::size_t line_end) {
  return goes_on(text, line_end, "+-*/(,?:<>&|=[^%", "+-*/),?:<>&|]^.");
}

bool is_assignment(std::string_view text, std::size_t at) {
  const char last = at > 0 ? text[at - 1] : ' ', next = at + 1 < text.size() ? text[at + 1] : ' ';
  return text[at] == '=' && next != '=' && !is_one_of(last, "=<>!");
}

/// "x *= .." multiplies what follows, so that is only a part of an expression.
bool is_behind_compound_assignment(std::string_view text, std::size_t begin) {
  return begin >= 2 && text[begin - 1] == '=' && is_one_of(text[begin - 2], "+-*/");
}

bool is_return(std::string_view text, std::size_t begin) {
  constexpr std::string_view word = "return";
  const std::string_view before = text.substr(0, begin);
  return before.ends_with(word) && (begin == word.size() || !is_of_name(before[begin - word.size() - 1]));
}

/// Where an expression around `begin` starts: after an opening parenthesis that closes after `begin`, after a
/// comma next to it, or at the start of the statement.
std::size_t begin_of(std::string_view text, std::size_t begin) {
  const std::size_t least = begin - std::min(begin, most_bytes);
  int depth = 0;
  while (begin > least) {
    const char c = text[begin - 1];
    if (ends_statement(c)) break;
    // "=>" stands between the parameters and the value of a function.
    if (is_assignment(text, begin - 1) || text.substr(0, begin).ends_with("=>")) break;
    if (c == '\n' && depth == 0 && !continues(text, begin - 1)) break;
    if (is_close(c)) ++depth;
    if (is_open(c) && depth-- == 0) break;
    if (c == ',' && depth == 0) break;
    if (is_return(text, begin) && !is_of_name(text[begin])) break;
    --begin;
  }
  return begin;
}

std::size_t end_of(std::string_view text, std::size_t end) {
  const std::size_t most = std::min(text.size(), end + most_bytes);
  int depth = 0;
  while (end < most) {
    const char c = text[end];
    if (ends_statement(c) || is_assignment(text, end)) break;
    if (c == '\n' && depth == 0 && !continues(text, end)) break;
    if (is_open(c)) ++depth;
    if (is_close(c) && depth-- == 0) break;
    if (c == ',' && depth == 0) break;
    ++end;
  }
  return end;
}

/// Where the name of a function begins that ends there, with what it is a member of.
std::size_t path_begin(std::string_view text, std::size_t end) {
  return begin_of_run(text, end, [](char c) { return is_of_name(c) || c == '.' || c == ':'; });
}

/// Extends [begin, end) until its parentheses are balanced. False if they cannot be.
bool balance(std::string_view text, std::size_t& begin, std::size_t& end) {
  int depth = 0, lowest = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (ends_statement(text[i])) return false;
    if (is_open(text[i])) ++depth;
    if (is_close(text[i])) lowest = std::min(lowest, --depth);
  }
  for (int opened = depth - lowest; opened > 0; --opened) {
    end = end_of(text, end);
    while (end < text.size() && text[end] == ',') end = end_of(text, end + 1);
    if (end >= text.size() || !is_close(text[end])) return false;
    ++end;
  }
  for (int closed = -lowest; closed > 0; --closed) {
    begin = begin_of(text, begin);
    while (begin > 0 && text[begin - 1] == ',') begin = begin_of(text, begin - 1);
    if (begin == 0 || !is_open(text[begin - 1])) return false;
    begin = path_begin(text, begin - 1);
  }
  return true;
}

}  // namespace

std::vector<std::string_view> expressions_around(std::string_view text, std::size_t begin, std::size_t end) {
  std::vector<std::string_view> found;
  constexpr int most_levels = 6;
  for (int level = 0; level < most_levels; ++level) {
    if (end - begin > most_bytes || !balance(text, begin, end)) break;
    begin = begin_of(text, begin);
    end = end_of(text, end);
    const std::string_view one = text.substr(begin, end - begin);
    if (one.size() > most_bytes || is_behind_compound_assignment(text, begin)) break;
    if (found.empty() || one.size() > found.back().size()) found.push_back(one);
    // The next expression goes beyond the parentheses around this one.
    const bool has_left = begin > 0 && (is_open(text[begin - 1]) || text[begin - 1] == ','),
               has_right = end < text.size() && (is_close(text[end]) || text[end] == ',');
    if (!has_left || !has_right) break;
    --begin;
    if (is_open(text[begin]) && is_close(text[end])) {
      ++end;
      begin = path_begin(text, begin);
    } else if (is_open(text[begin])) {
      ++begin;
      ++end;  // over the comma
    }
  }
  return found;
}

std::string comment_as_program(std::string_view text) {
  std::string out(text);
  bool is_at_start = true;  // of a line, or of a comment
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::string_view sign = text.substr(i, 2);
    if (out[i] == '\n') {
      is_at_start = true;
    } else if (sign == "//" || sign == "/*" || sign == "*/") {
      out[i] = ';';
      out[++i] = ' ';
      is_at_start = true;
    } else if (is_at_start && is_one_of(out[i], "*/#!<")) {
      out[i] = ' ';
    } else if (!is_blank(out[i])) {
      is_at_start = false;
    }
  }
  return out;
}

}  // namespace shadefit::lint
