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

/// How far a closed form and two rules are apart, all relative to the closed form, the worst of all places
/// compared so far.
struct Agreement {
  double gap = 0;    ///< between the closed form and the rule further from it
  double error = 0;  ///< of the rules: their own estimates and their distance from each other

  void compare(double closed_form, const Integral& first, const Integral& second) {
    const auto relative = [&](double difference) { return std::abs(difference / closed_form); };
    gap = std::max({gap, relative(first.value - closed_form), relative(second.value - closed_form)});
    error = std::max(
        {error, relative(first.error), relative(second.error), relative(first.value - second.value)});
  }

  /// Empty where the rules are not good to the tolerance themselves.
  std::optional<Verdict> verdict(double tolerance) const {
    if (!(error <= tolerance)) return std::nullopt;
    return verdict_of(gap <= tolerance);
  }
};

/// "within 1e-12", or how far off: below the tolerance, a bound and not its rounding noise.
std::string within(double gap, std::string_view tolerance);

/// What replacing a lobe c^from by c^to does to a picture, after a lead; both powers above 0.
std::string effect_of_power(double from, double to, std::string_view lead = {});

}  // namespace shadefit
