#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fit/support/decimal.hpp"
#include "lint/known/known_set.hpp"

namespace shadefit::lint {
namespace {

/// The n of a number 10^n other than 1.
std::optional<int> power_of_ten(const Symbolic& formula) {
  if (formula.kind() != Symbolic::Kind::number) return std::nullopt;
  const double value = constant<double>(formula.name());
  if (!(value > 0) || value == 1) return std::nullopt;
  const int exponent = static_cast<int>(std::lround(std::log10(value)));
  return parse_number("1e" + std::to_string(exponent)) == value ? std::optional(exponent) : std::nullopt;
}

/// Whether a product has this factor: v in 2 pi v.
bool has_factor(const Symbolic& product, const std::string& name) {
  const Symbolic::Kind kind = product.kind();
  if (kind == Symbolic::Kind::variable) return product.name() == name;
  return (kind == Symbolic::Kind::multiply || kind == Symbolic::Kind::negate) &&
         std::ranges::any_of(product.parts(), [&](const Symbolic& part) { return has_factor(part, name); });
}

/// A formula without the power of ten that multiplies a constant. `exponents` gets that of each place of the
/// constant; 0: it has none.
Symbolic without_power(const Symbolic& formula, const std::string& constant, std::set<int>& exponents) {
  if (formula.kind() == Symbolic::Kind::variable && formula.name() == constant) exponents.insert(0);
  std::vector<Symbolic> parts = formula.parts();
  if (formula.kind() == Symbolic::Kind::multiply)
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
      if (const auto power = power_of_ten(parts[1 - side]); power && has_factor(parts[side], constant)) {
        exponents.insert(*power);
        return parts[side];
      }
  for (Symbolic& part : parts) part = without_power(part, constant, exponents);
  return formula.with_parts(std::move(parts));
}

/// Makes one number of a constant and the power of ten that multiplies it at each place. True if there is
/// one.
bool fold_power(KnownSet& set, std::size_t place) {
  KnownConstant& constant = set.constants[place];
  std::set<int> exponents;
  const Symbolic formula = without_power(set.formula, constant.name, exponents);
  if (exponents.size() != 1 || exponents.contains(0)) return false;
  if (constant.printed.find_first_of("eE") != std::string::npos) return false;
  set.formula = formula;
  const std::string power = "e" + std::to_string(*exponents.begin());  // 5.4856e-13
  constant.printed += power;
  constant.value = *parse_number(constant.printed);
  for (KnownVariant& variant : set.variants)
    if (variant.constant == place) variant.printed += power;
  return true;
}

}  // namespace

std::vector<KnownSet> folded_powers_of(const std::vector<KnownSet>& sets) {
  std::vector<KnownSet> folded;
  for (KnownSet set : sets) {
    bool has_power = false;
    for (std::size_t i = 0; i < set.constants.size(); ++i) has_power = fold_power(set, i) || has_power;
    if (has_power) folded.push_back(std::move(set));
  }
  return folded;
}

}  // namespace shadefit::lint
