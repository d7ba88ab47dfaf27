#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/fit.hpp"
#include "fit/rounding/lattice.hpp"
#include "fit/support/checkpoint.hpp"

/// The best constants of a number format, for a form that is evaluated in that format.
namespace shadefit {

/// One set of constants in a format, and the error of the form when every operation is rounded.
///
/// In half and bfloat16 `max_error` is the largest error over every number of the format in the domain, with
/// the target in double. In float, and for decimals (evaluated in double), it is an upper bound: the error of
/// the real form, proven by intervals, plus a bound of the rounding of the evaluation.
struct RoundedConstants {
  std::vector<double> parameters;
  std::vector<std::string> texts;  ///< the shortest decimals that read back as these numbers of the format
  double max_error = 0;
  double at = 0;                                     ///< the cosine of the largest error
  std::optional<double> real_error, rounding_error;  ///< the parts of a bound
  std::optional<double> srgb_codes;  ///< the largest error in 8-bit sRGB codes, if every input was tried
  std::optional<double> gpu_bound;   ///< bounds the error on a GPU, by `usual_gpu`; none for decimals
};

struct Rounded {
  NumberFormat format;
  Error error = Error::absolute;
  RoundedConstants best = {};
  RoundedConstants naive = {};                     ///< each parameter of the fit rounded separately
  std::optional<RoundedConstants> published = {};  ///< the published values rounded
  bool is_proven = false;                          ///< no other constants of the format have a smaller error
  std::string searched = {};                       ///< the set of constants that was searched
  long boxes = 0;                                  ///< number of bounded boxes
  long evaluated = 0;                              ///< constants whose error was computed
};

/// The most boxes of a search: a few seconds.
inline constexpr long most_lattice_boxes = 1000000;

/// Searches the format for the parameters with the smallest largest error over the fit's domain. The error is
/// absolute or relative as in the fit's metric; its norm does not matter. Given parameters are only rounded.
/// The fit must have converged; `published` are the parameters' published values or empty. Gives up after
/// `limit` boxes. Throws UserError if a parameter overflows the format, if the exponent is not a number of
/// the format, or if the metric has a weight or a constraint on the form, which rounding breaks.
Rounded round_fit(const Fit& fit, const NumberFormat& format, const std::vector<double>& published,
                  const Checkpoint& checkpoint = keep_going, long limit = most_lattice_boxes);

}  // namespace shadefit
