#pragma once

#include <vector>

#include "fit/catalogue/study_file.hpp"
#include "fit/study/study.hpp"
#include "fit/verdicts/verdict.hpp"

/// Verdicts on what sources say about the errors of their constants.
namespace shadefit {

/// A stated error and the verdict on it: `confirmed` if the computed error has the same digits or is smaller,
/// `rounding` if its last digit is off by one, otherwise `refuted`.
struct JudgedError {
  ErrorClaim claim;
  double computed;  ///< infinite or NaN if the error does not exist: no relative error where the target is 0
  Verdict verdict;
};

/// What a claim is about: a study with the ranges and the kind of error of the claim, without a weight. It
/// keeps the measured rows inside the ranges. Throws UserError if no row is inside.
Study study_of(const ErrorClaim& claim, const Study& study);

/// Judges a stated error of a form with these parameters. A mean is even over the ranges, or has the density
/// of the study. Throws as `study_of` does.
JudgedError judge_error(const ErrorClaim& claim, const Study& study, const std::vector<double>& parameters);

}  // namespace shadefit
