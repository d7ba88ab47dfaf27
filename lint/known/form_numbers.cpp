#include "lint/known/form_numbers.hpp"

#include <algorithm>
#include <utility>

#include "fit/support/decimal.hpp"
#include "lint/known/closed_form.hpp"

namespace shadefit::lint {
namespace {

/// Where the parts begin that are searched. The condition of a choice is left out: a program that has its
/// variable in other units, such as kelvin, has other numbers there and the same constants.
std::size_t first_searched(const Symbolic& formula) {
  return formula.kind() == Symbolic::Kind::choice ? 2 : 0;
}

/// The names and numbers of a formula, in the order of its text.
void append_leaves(const Symbolic& formula, std::vector<Symbolic>& leaves) {
  if (formula.parts().empty()) leaves.push_back(formula);
  for (std::size_t i = first_searched(formula); i < formula.parts().size(); ++i)
    append_leaves(formula.part(i), leaves);
}

/// Whether a number has at least three digits and is no simple fraction.
bool is_telling(const Symbolic& leaf) {
  constexpr int few_digits = 2;
  if (leaf.kind() != Symbolic::Kind::number) return false;
  const double value = constant<double>(leaf.name());
  return parse_number(decimal(value, few_digits)) != value && !is_common_number(value);
}

/// The formula with a variable in place of each telling number; its name is the number.
Symbolic with_names(const Symbolic& formula) {
  if (is_telling(formula)) return Symbolic::variable(formula.name());
  if (formula.parts().empty()) return formula;
  std::vector<Symbolic> parts = formula.parts();
  for (std::size_t i = first_searched(formula); i < parts.size(); ++i) parts[i] = with_names(parts[i]);
  return formula.with_parts(std::move(parts));
}

}  // namespace

void name_form_numbers(KnownSet& set) {
  std::vector<Symbolic> leaves;
  append_leaves(set.formula, leaves);
  auto next = set.constants.end();
  for (auto leaf = leaves.rbegin(); leaf != leaves.rend(); ++leaf) {
    const auto known = std::find_if(set.constants.begin(), set.constants.end(),
                                    [&](const auto& constant) { return constant.name == leaf->name(); });
    if (known != set.constants.end()) {
      next = known;
    } else if (is_telling(*leaf)) {
      next = set.constants.insert(next,
                                  {leaf->name(), leaf->name(), constant<double>(leaf->name()), false, true});
    }
  }
  set.formula = with_names(set.formula);
}

}  // namespace shadefit::lint
