#include "approx/von_mises_fisher.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fit/ledger/topics.hpp"
#include "fit/quadrature/integrate.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/scalars/half.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/root.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {
namespace {

/// The bound on the error of an integral that is 1, absolute: both rules, their estimates and the cut-off
/// tail. The rules agree to 1e-14.
constexpr double integral_tolerance = 1e-12;

/// The integral of the density over the sphere: 2 pi dy over y = 1 - c in [0, 2], in t = k y.
Integral integral_over_sphere(double concentration) {
  const auto density = [&](double t) {
    return 2 * pi<double>() * von_mises_fisher_near_peak(t / concentration, concentration) / concentration;
  };
  const double whole = 2 * concentration, end = std::min(whole, Substitution::decay);
  const Integral one = gauss_kronrod(density, 0, end, 1e-14), other = tanh_sinh(density, 0, end, 1e-14);
  // The rest is e^(-end) (1 - e^(end - 2k))/(1 - e^(-2k)), where there is one.
  const double rest = end < whole ? std::exp(-end) : 0;
  return {one.value, one.error + other.error + std::abs(one.value - other.value) + rest};
}

/// The largest k at which the printed formula is a finite number at its peak, halved down to a double.
template <class T>
double last_finite_concentration() {
  return last_by_halving(1, 2048, 60, [](double k) {
    return std::isfinite(static_cast<double>(von_mises_fisher(integer<T>(1), static_cast<T>(k))));
  });
}

Finding normalisation(const Claim& claim) {
  const double printed = number_of(claim.printed[0].value);
  const auto concentrations = parse_sweep(claim.inputs.at("exponents"));
  double furthest = printed, apart = 0, uncertainty = 0;
  for (const double k : concentrations) {
    const Integral integral = integral_over_sphere(k);
    uncertainty = std::max(uncertainty, integral.error);
    if (std::abs(integral.value - printed) >= apart) {
      apart = std::abs(integral.value - printed);
      furthest = integral.value;
    }
  }
  const bool is_known = uncertainty <= integral_tolerance;
  const bool is_equal = apart <= 2 * integral_tolerance;
  return {
      is_known ? std::optional(verdict_of(is_equal)) : std::nullopt, decimal(furthest, 10),
      fmt::format(
          "the integral over the sphere is {:.10g} by two rules, each to {:.1g}, at {} from k = {:.6g} to "
          "{:.6g}{}. As printed the formula overflows in half, float and double beyond k = {:.4g}, {:.4g} "
          "and {:.4g}. The form k/(2 pi (1 - e^(-2k))) e^(-k(1-c)), which is equal, does not overflow",
          furthest, integral_tolerance, counted(std::ssize(concentrations), "concentration"),
          concentrations.front(), concentrations.back(), is_equal ? "" : ", which is not the printed number",
          last_finite_concentration<Eigen::half>(), last_finite_concentration<float>(),
          last_finite_concentration<double>()),
      effect_of_factor(printed, is_equal ? printed : furthest)};
}

/// The k from which on the relative error of the sharp form is at most `share`: e^(-2k) = share.
double concentration_of_error(double share) {
  return -std::log(share) / 2;
}

/// The largest relative error that shifts no colour by more than one 8-bit sRGB code.
double share_of_one_code() {
  return last_by_halving(0, 1, 53, [](double share) { return codes_of_factor(1 - share) <= 1; });
}

Finding sharp_density(const Claim& claim) {
  const double k = number_of(claim.printed[0].value), about = given(claim, "about");
  const double law = von_mises_fisher_sharp_error(k);
  double apart = 0;  // the difference of the two densities' ratio from the law
  for (const double y : parse_sweep(claim.inputs.at("y"))) {
    const double ratio = von_mises_fisher_sharp(y, k) / von_mises_fisher(1 - y, k);
    apart = std::max(apart, std::abs(ratio - 1 - law));
  }
  // Two exponentials and a few products, each rounded: about ten epsilons.
  constexpr double rounding = 1e-14;
  const double from = concentration_of_error(about), from_code = concentration_of_error(share_of_one_code());
  // Of all k of the claim, the error is largest at the printed k.
  const double least = concentration_of_error(given(claim, "no longer about"));
  const Verdict verdict = k >= from    ? Verdict::confirmed
                          : k >= least ? Verdict::conditional
                                       : Verdict::refuted;
  return {
      apart <= rounding ? std::optional(verdict) : std::nullopt,
      fmt::format("relative error {:.4g} at k = {}", law, claim.printed[0].value),
      fmt::format(
          "the relative error is -e^(-2k) at every angle; at 1 - c = {} the quotient of both densities "
          "confirms it to {:.1g}. It is {:.4g} at k = {}. Its size is at most {} from k = {:.4g} on, and at "
          "most {}, "
          "the most that still counts as about equal, from k = {:.4g} on. It is at most one 8-bit sRGB code "
          "from k = {:.4g} on",
          claim.inputs.at("y"), rounding, law, claim.printed[0].value, claim.inputs.at("about"), from,
          claim.inputs.at("no longer about"), least, from_code),
      effect_of_factor(1 + law, 1, fmt::format("at k = {:.4g} and any c it", k))};
}

}  // namespace

std::vector<Evaluator> von_mises_fisher_evaluators() {
  return {{"vmf-normalisation", normalisation}, {"vmf-large-k", sharp_density}};
}

}  // namespace shadefit
