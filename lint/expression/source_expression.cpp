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

}  // namespace
bool is_number(const Symbolic& formula) {
  if (formula.kind() == Symbolic::Kind::variable) return false;
  return std::all_of(formula.parts().begin(), formula.parts().end(), is_number);
}

std::optional<Symbolic> read_expression(std::string_view text, CommentStyle style) {
  std::string plain = without_comments(text, style);
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
