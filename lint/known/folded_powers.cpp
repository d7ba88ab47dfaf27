#include <cmath>
#include <optional>
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

/// Takes the powers of ten that multiply a constant out of a formula.
class PowerFolder {
 public:
  explicit PowerFolder(std::string constant) : constant_(std::move(constant)) {}

  /// The formula without them. Empty unless the constant has the same power at each place.
  std::optional<Symbolic> folded(const Symbolic& formula) {
    const Product whole = fold(formula);
    return whole.is_bare || !is_uniform_ ? std::nullopt : std::optional(whole.formula);
  }

  /// The exponent of the power of ten that was folded; 0 if the formula has no such power.
  int exponent() const { return exponent_; }

 private:
  struct Product {
    Symbolic formula;
    bool is_bare = false;  ///< whether the constant is a factor of it, so far without a power of ten
  };

  Product fold(const Symbolic& formula) {
    if (formula.kind() == Symbolic::Kind::variable) return {formula, formula.name() == constant_};
    std::vector<Symbolic> parts;
    bool is_bare = false;
    for (const Symbolic& part : formula.parts()) {
      const Product inner = fold(part);
      parts.push_back(inner.formula);
      is_bare = is_bare || inner.is_bare;
    }
    const bool is_product = formula.kind() == Symbolic::Kind::multiply;
    if (is_bare && is_product) {
      for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        const auto power = power_of_ten(parts[side]);
        if (!power) continue;
        is_uniform_ = is_uniform_ && (exponent_ == 0 || exponent_ == *power);
        exponent_ = *power;
        return {parts[1 - side], false};
      }
    }
    if (is_bare && !is_product && formula.kind() != Symbolic::Kind::negate) is_uniform_ = false;
    return {formula.with_parts(std::move(parts)), is_bare && is_uniform_};
  }

  std::string constant_;
  int exponent_ = 0;
  bool is_uniform_ = true;
};

/// Makes one number of a constant and the power of ten that multiplies it. True if there is one.
bool fold_power(KnownSet& set, std::size_t place) {
  KnownConstant& constant = set.constants[place];
  PowerFolder folder(constant.name);
  const auto formula = folder.folded(set.formula);
  if (!formula || folder.exponent() == 0) return false;
  if (constant.printed.find_first_of("eE") != std::string::npos) return false;
  set.formula = *formula;
  const std::string power = "e" + std::to_string(folder.exponent());  // 5.4856e-13
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
