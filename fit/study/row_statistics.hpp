#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "fit/study/study_problem.hpp"
#include "fit/support/checkpoint.hpp"

/// How well measured rows determine the parameters of a fit.
namespace shadefit {

/// The values of a parameter with which the rows still agree. An end is empty if the interval is open there.
struct ProfileInterval {
  std::optional<double> lower, upper;
};

struct RowStatistics {
  std::size_t freedom;  ///< rows - parameters, at least 1
  /// Whether sigma gives the size of the noise: the weight is 1/sigma in every row, and the error is
  /// absolute. Otherwise weights only compare rows, and the residuals give the size of the noise.
  bool is_absolute;
  /// (sum of squares)/freedom. If absolute, this is the reduced chi-square; otherwise the variance s^2 of a
  /// row of weight 1.
  double variance;
  std::vector<std::vector<double>> covariance;  ///< of the free parameters
  std::vector<double> standard_errors;          ///< the roots of its diagonal
  std::vector<ProfileInterval> profiles;        ///< one for each free parameter
};

/// The statistics of a fit of rows at its optimum. Let J be the derivatives of the weighted errors, a row for
/// each measurement. The covariance is
///   inverse(J^T J)        where sigma is absolute (`absolute_sigma=True` of SciPy's curve_fit),
///   s^2 inverse(J^T J)    otherwise.
/// A profile interval has the values of one parameter for which the sum of squares, minimised again over all
/// other parameters, is above its minimum by at most 1 (absolute) or s^2: 68.27 % if the form is linear and
/// the noise normal (Bates, Watts 1988, "Nonlinear Regression Analysis and Its Applications", chapter 6). Its
/// ends are searched up to a thousand standard errors from the optimum; an interval without an end there is
/// open. Empty if there is nothing to compute from: as many rows as parameters, or residuals that are
/// rounding without an absolute sigma.
std::optional<RowStatistics> row_statistics(const ReadStudy& study, const StudyError& error,
                                            const SampledStudy<double>& sampled,
                                            const std::vector<double>& parameters,
                                            const Checkpoint& checkpoint);

}  // namespace shadefit
