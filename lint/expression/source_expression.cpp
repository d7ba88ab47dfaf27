#include "lint/expression/source_expression.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "fit/formula/parse_formula.hpp"
#include "lint/expression/rewriter.hpp"
#include "lint/expression/statements.hpp"

namespace shadefit::lint {
namespace {

/// The position of a word outside of parentheses, or npos.
std::size_t word_outside(std::string_view text, std::string_view word) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(' || text[i] == '[') ++depth;
    if (text[i] == ')' || text[i] == ']') --depth;
    if (depth == 0 && text.substr(i).starts_with(word)) return i;
  }
  return std::string_view::npos;
}

/// Python's "a if x < t else b" as x < t ? a : b.
std::string with_sign_of_choice(std::string text) {
  constexpr std::string_view condition = " if ", other = " else ";
  const std::size_t first = word_outside(text, condition), second = word_outside(text, other);
  if (first == std::string::npos || second == std::string::npos || second < first) return text;
  const std::size_t begin = first + condition.size();
  return "(" + text.substr(begin, second - begin) + ") ? (" + text.substr(0, first) + ") : (" +
         with_sign_of_choice(text.substr(second + other.size())) + ")";
}

/// What stands before the value of a function without a name ends here: behind "c =>", "(float c) ->",
/// "lambda c:" or "|c: f32|". 0 for any other text.
std::size_t value_begin(std::string_view text) {
  constexpr std::string_view lambda = "lambda ";
  if (text.starts_with(lambda)) return std::min(word_outside(text, ":"), text.size() - 1) + 1;
  if (text.starts_with('|') && !text.starts_with("||"))
    return std::min(text.find('|', 1), text.size() - 1) + 1;
  if (const std::size_t arrow = word_outside(text, "=>"); arrow != std::string_view::npos) return arrow + 2;
  // Elsewhere "p->x" is a member.
  const std::size_t arrow = word_outside(text, "-> ");
  return arrow == std::string_view::npos ? 0 : arrow + 2;
}

/// The value of a function without a name, whose head may be there: "c => a * c" is a * c.
std::string_view function_value(std::string_view text) {
  text = trimmed(text);
  for (std::size_t begin = value_begin(text); begin > 0; begin = value_begin(text))
    text = trimmed(text.substr(begin));
  return text;
}

}  // namespace

bool is_number(const Symbolic& formula) {
  if (formula.kind() == Symbolic::Kind::variable) return false;
  return std::all_of(formula.parts().begin(), formula.parts().end(), is_number);
}

std::optional<Symbolic> read_expression(std::string_view text, CommentStyle style) {
  std::string plain(function_value(without_comments(text, style)));
  if (style == CommentStyle::hash) plain = with_sign_of_choice(std::move(plain));
  const auto source = in_formula_notation(plain);
  if (!source) return std::nullopt;
  FormulaNames names;
  for (std::size_t i = 0; i < source->names.size(); ++i) names.variables.push_back("v" + std::to_string(i));
  try {
    const Symbolic formula = read_formula(source->formula, names).formula;
    return evaluate<Symbolic>(formula, [&](const std::string& name) {
      return Symbolic::variable(source->names[std::stoul(name.substr(1))]);
    });
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace shadefit::lint
