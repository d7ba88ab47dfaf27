#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/fit.hpp"
#include "fit/proof/certificate.hpp"
#include "fit/rounding/lattice.hpp"
#include "fit/support/checkpoint.hpp"

/// Constants that survive rounding: the best that a format can hold, for a form that is evaluated in it.
namespace shadefit {

/// One set of constants in a format, and how wrong the form is there when every operation is rounded.
///
/// In half and bfloat16 `max_error` is that: the largest error over every number of the format in the domain,
/// the target in double. In float, and for decimals, which are evaluated in double, it is a bound: that of
/// the real form, proven by intervals, and that of the evaluation's rounding.
struct RoundedConstants {
  std::vector<double> parameters;
  std::vector<std::string> texts;  ///< the shortest decimals that read back as these in the format
  double max_error = 0;
  double at = 0;                                     ///< the cosine of the largest error
  std::optional<double> real_error, rounding_error;  ///< the parts of a bound
  std::optional<double> srgb_codes;  ///< the largest error in 8-bit sRGB codes, where each input was tried
  std::optional<double> gpu_bound;   ///< of the error on a GPU as `GpuModel` says; none for decimals
};

struct Rounded {
  NumberFormat format;
  Error error = Error::absolute;
  RoundedConstants best = {};
  RoundedConstants naive = {};                     ///< each parameter of the fit rounded by itself
  std::optional<RoundedConstants> published = {};  ///< the published values rounded
  bool is_proven = false;                          ///< no other constants of the format have a smaller error
  std::string searched = {};                       ///< among which
  long boxes = 0;                                  ///< that the search bounded
  long evaluated = 0;                              ///< constants whose error was computed
};

/// Boxes after which a search is given up: a few seconds.
inline constexpr long most_lattice_boxes = 1000000;

/// Searches all numbers of the format for the parameters whose largest error over the fit's domain is least:
/// of the kind, absolute or relative, that the fit's metric names, whatever its norm. Given parameters stay,
/// rounded. The fit has to have converged; `published` are the parameters' published values or empty. Gives
/// up after `limit` boxes. Throws UserError where a parameter overflows the format, the exponent is no number
/// of it, or the metric has a weight, or a constraint on the form, which rounding breaks.
Rounded round_fit(const Fit& fit, const NumberFormat& format, const std::vector<double>& published,
                  const Checkpoint& checkpoint = keep_going, long limit = most_lattice_boxes);

}  // namespace shadefit
