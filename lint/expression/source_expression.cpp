#include "lint/expression/source_expression.hpp"

#include <algorithm>
#include <stdexcept>

#include "fit/formula/parse_formula.hpp"
#include "lint/expression/rewriter.hpp"

namespace shadefit::lint {
namespace {

/// The text without comments.
std::string without_comments(std::string_view text, CommentStyle style) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_line = (style == CommentStyle::c && text.substr(i, 2) == "//") ||
                         (style == CommentStyle::hash && text[i] == '#');
    if (is_line) {
      i = std::min(text.find('\n', i), text.size());
    } else if (style == CommentStyle::c && text.substr(i, 2) == "/*") {
      i = std::min(text.find("*/", i + 2), text.size()) + 1;
    } else {
      out += text[i];
      continue;
    }
    out += ' ';
  }
  return out;
}

}  // namespace

bool is_number(const Symbolic& formula) {
  if (formula.kind() == Symbolic::Kind::variable) return false;
  return std::all_of(formula.parts().begin(), formula.parts().end(), is_number);
}

std::optional<Symbolic> read_expression(std::string_view text, CommentStyle style) {
  const auto source = in_formula_notation(without_comments(text, style));
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
