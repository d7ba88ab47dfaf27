#pragma once

#include <optional>
#include <span>
#include <vector>

#include "approx/records/record.hpp"
#include "fit/verdicts/verdict.hpp"

/// Published normalisation constants against numeric integration over the hemisphere.
namespace shadefit {

struct NormalisationCheck {
  const Normalisation* record;
  std::optional<double> exponent;
  double closed_form;          ///< the constant as published
  double integral;             ///< 1 over the numerical integral
  double relative_difference;  ///< |closed_form / integral - 1|
  double
      estimated_error;  ///< relative, of `integral`: both rules' estimates, their difference and the cut tail
  std::optional<Verdict> verdict;  ///< empty if the integral is not accurate enough
};

/// The largest relative difference that confirms a constant, and the largest estimated error of a check with
/// a verdict. The integrands have errors of a few 1e-15; 1e-12 is promised.
inline constexpr double normalisation_tolerance = 1e-12;

/// The exponents checked by default.
inline constexpr double normalisation_exponents[] = {0.1, 1, 2, 8, 64, 2048, 1e5, 1e6};

/// Checks the constant of that id at each exponent, all greater than 0; once if the constant has no exponent.
std::vector<NormalisationCheck> check_normalisation(
    const Normalisation& record, std::span<const double> exponents = normalisation_exponents);

/// The verdict on a closed form: confirmed if the integral agrees within the tolerance, or within the
/// tolerance of the record; else refuted. Empty if the estimated error of the integral exceeds the tolerance.
std::optional<Verdict> judge_normalisation(double relative_difference, double estimated_error,
                                           double closeness = 0);

/// The place where a cheap constant is furthest above the exact one.
struct LargestRatio {
  double exponent;
  double ratio;  ///< cheap over exact
};

/// The largest ratio of the cheap Blinn-Phong constant to the exact one over all exponents: a root of the
/// ratio's slope, searched on a grid with steps of 2^(1/8) from 2^-10 to 2^20.
LargestRatio largest_cheap_ratio();

}  // namespace shadefit
