#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fit/quadrature/metric.hpp"
#include "fit/steps/alternation.hpp"
#include "fit/steps/status.hpp"
#include "fit/study/row_statistics.hpp"

/// What comes out of a fit of a study.
namespace shadefit {

/// The largest magnitude of an error, and its place: one number for each variable.
struct StudyExtremum {
  double magnitude = 0;
  std::vector<double> at;
  std::size_t row = 0;  ///< of measured rows: its number, from 1
};

/// A place, and the weighted error there.
struct StudyContact {
  std::vector<double> at;
  double error = 0;
};

/// A fit with fewer digits is not an answer.
inline constexpr int least_study_digits = 6;

struct StudyFit {
  std::vector<std::string> names;  ///< of all free parameters
  std::vector<double> parameters;  ///< an answer only if `status` is converged
  Status status = Status::not_converged;
  std::string why = {};  ///< of a fit that did not converge
  /// How many digits of the worst parameter another quadrature rule confirms in long double, at most 14.
  int digits = 0;
  double rms_error = 0;         ///< sqrt(integral of density * error^2 / integral of density), weighted
  StudyExtremum max_abs_error;  ///< of form - target, sampled and refined; of rows the largest residual
  std::optional<double> max_weighted_error =
      std::nullopt;                ///< the largest |weight * error|, of a study with a weight
  int starts = 0;                  ///< from how many starts the optimum was looked for
  std::size_t descents = 0;        ///< of least squares: how many went to an end
  std::size_t lowest = 0;          ///< and how many of them ended here
  bool is_global = false;          ///< proven to be the best of all: the form is linear in its parameters
  std::vector<double> other = {};  ///< of an ambiguous fit: the other curve, as good
  std::optional<double> level = std::nullopt;  ///< of a minimax fit: the largest |weighted error|
  /// Of a minimax fit. If not, other parameters have the level too, and these the least mean square of all.
  bool is_unique = true;
  std::vector<AlternationPoint> alternation = {};  ///< of a minimax fit, with x for the cosine; rising
  std::vector<StudyContact> touching = {};         ///< of one in several variables: where it is at its level
  std::optional<RowStatistics> statistics = std::nullopt;  ///< of measured rows, where they say enough
  std::vector<Held> at_bounds = {};                        ///< parameters that lie on a bound of theirs
  bool is_sampled = false;  ///< whether nothing but samples tells what happens between the nodes
};

/// Ends a fit without an answer. False.
inline bool fail(StudyFit& fit, Status status, std::string why) {
  fit.status = status;
  fit.why = std::move(why);
  return false;
}

}  // namespace shadefit
