#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "fit/ledger/finding.hpp"
#include "fit/quadrature/integrate.hpp"

/// An identity, judged by its closed form against two quadrature rules.
namespace shadefit {

/// The largest differences of a closed form and two rules over all compared places, relative to the closed
/// form.
struct Agreement {
  double gap = 0;    ///< between the closed form and the rule further from it
  double error = 0;  ///< of the rules: their own estimates and their difference

  void compare(double closed_form, const Integral& first, const Integral& second) {
    const auto relative = [&](double difference) { return std::abs(difference / closed_form); };
    gap = std::max({gap, relative(first.value - closed_form), relative(second.value - closed_form)});
    error = std::max(
        {error, relative(first.error), relative(second.error), relative(first.value - second.value)});
  }

  /// Empty if the rules themselves are not accurate to the tolerance.
  std::optional<Verdict> verdict(double tolerance) const {
    if (!(error <= tolerance)) return std::nullopt;
    return verdict_of(gap <= tolerance);
  }
};

/// "within 1e-12", or the difference. Below the tolerance it is the bound, not rounding noise.
std::string within(double gap, std::string_view tolerance);

/// The effect of replacing a lobe c^from by c^to, after a lead; both powers are above 0.
std::string effect_of_power(double from, double to, std::string_view lead = {});

}  // namespace shadefit
