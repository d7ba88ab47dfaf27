#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <cmath>

#include "approx/lobe.hpp"
#include "approx/scalar.hpp"
#include "fit/ledger/finding.hpp"
#include "fit/support/format.hpp"

namespace shadefit {

std::string effect_of_power(double from, double to, std::string_view lead) {
  const auto lobe = [](double exponent) {
    return [exponent]<class T>(const Cosine<T>& c) { return power_lobe(c.cos_theta, lift<T>(exponent)); };
  };
  const double blunter = std::min(from, to);
  const Substitution domain({.measure = Measure::cosine},
                            {.concentration = blunter, .end_power = std::min(blunter, 1.0)});
  return sentence(effect_between(lobe(from), lobe(to), domain), "the curve", lead);
}

namespace {

/// The effect of multiplying every linear grey by that ratio; white first, because the ratio is the same for
/// all.
Effect effect_on_greys(double ratio) {
  Effect effect;
  for (int i = 255; i >= 1; --i) {
    const double grey = i / 255.0;
    effect.show(grey, grey * ratio, {{"grey ", static_cast<double>(i), "/255"}});
  }
  return effect;
}

}  // namespace

Verdict worst(std::span<const Verdict> parts) {
  // The enumerators are ordered from `confirmed` to the worst.
  return *std::ranges::max_element(parts);
}

std::optional<Verdict> worst(std::span<const std::optional<Verdict>> parts) {
  if (std::ranges::any_of(parts, [](const auto& verdict) { return !verdict; })) return std::nullopt;
  return *std::ranges::max_element(parts);
}

double number_of(std::string_view text) {
  return constant<double>(text);
}

double given(const Claim& claim, std::string_view name) {
  return number_of(claim.inputs.at(name));
}

std::vector<std::string> items_of(std::string_view text, char separator) {
  std::vector<std::string> items;
  boost::split(items, text, [=](char c) { return c == separator; });
  for (std::string& item : items) boost::trim(item);
  return items;
}

std::vector<double> numbers_of(std::string_view text, char separator) {
  std::vector<double> numbers;
  for (const std::string& item : items_of(text, separator)) numbers.push_back(number_of(item));
  return numbers;
}

std::string effect_of_factor(double printed, double exact, std::string_view lead) {
  if (printed == exact) return "none";
  const double ratio = printed / exact;
  // nothing to add for a ratio to 1
  const std::string itself = exact == 1 ? "" : fmt::format(", or by {:.2g}", std::abs(printed - exact));
  return sentence(
      effect_on_greys(ratio), "a linear grey",
      fmt::format("{}{}makes a factor too {} by {:.2g} of its value{}, which", lead, lead.empty() ? "" : " ",
                  ratio < 1 ? "small" : "large", std::abs(ratio - 1), itself));
}

}  // namespace shadefit
