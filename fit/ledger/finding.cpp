#include "fit/ledger/finding.hpp"

#include <algorithm>
#include <cmath>

#include "approx/encoding.hpp"
#include "approx/scalar.hpp"
#include "fit/decimal.hpp"
#include "fit/effect.hpp"

namespace shadefit {

Verdict worst(std::span<const Verdict> parts) {
  // The enumerators stand in the order of their distance from `confirmed`.
  return *std::max_element(parts.begin(), parts.end());
}

std::optional<Verdict> worst(std::span<const std::optional<Verdict>> parts) {
  if (std::any_of(parts.begin(), parts.end(), [](const auto& v) { return !v.has_value(); }))
    return std::nullopt;
  return *std::max_element(parts.begin(), parts.end());
}

std::string identity_if(const std::optional<Verdict>& verdict) {
  return verdict == Verdict::confirmed ? "identity" : "no identity";
}

std::optional<Verdict> judge_known_to(std::string_view printed, double value, double error) {
  const Verdict low = judge(printed, {"", value - error}, {}).verdict;
  const Verdict high = judge(printed, {"", value + error}, {}).verdict;
  return low == high ? std::optional(low) : std::nullopt;
}

double number_of(std::string_view text) {
  return constant<double>(text);
}

double codes_of_factor(double ratio) {
  double codes = 0;
  for (int i = 1; i <= 255; ++i) {
    const double colour = i / 255.0;
    codes = std::max(codes, std::abs(srgb_code(colour * ratio) - srgb_code(colour)));
  }
  return codes;
}

std::string effect_of_factor(double printed, double exact) {
  if (printed == exact) return "none";
  const double ratio = printed / exact;
  return "scales what it multiplies by 1 " + std::string(ratio < 1 ? "- " : "+ ") +
         decimal(std::abs(ratio - 1), 2) + ": at most " + decimal(codes_of_factor(ratio), 2) +
         " 8-bit sRGB codes, the constant itself off by " + decimal(std::abs(printed - exact), 2) + ", " +
         decimal(std::abs(printed - exact) / half_ulp(exact), 2) + " ulps of a half float";
}

}  // namespace shadefit
