#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/certificate.hpp"
#include "fit/checkpoint.hpp"
#include "fit/fit.hpp"

/// What else there is for a published constant: the same form under other objectives, and other forms of the
/// same target, each with what it costs and how wrong it is, proven.
namespace shadefit {

/// A form with its constants.
struct Contender {
  const FittableFamily* family;
  std::string_view published;  ///< the id of the first of the printed numbers; empty where they were fitted
  std::string origin;          ///< whose constants they are: a source, or the objective of a fit
  std::vector<std::pair<std::string, std::string>> parameters;  ///< names and texts, of fits hexadecimal
  std::vector<double> values;                                   ///< the same as doubles
  Operations operations;
  double rms_error;      ///< uniform in the cosine
  double max_rel_error;  ///< of what the family's `relative_to` says; not a number where that has no meaning
  Certified max_abs_error;
  /// The published constants of the same target whose proven error is larger at no fewer instructions.
  std::vector<std::string_view> beats = {};
};

/// All contenders for one target; the published ones first.
struct Comparison {
  Setting setting;  ///< exponent or surface
  std::vector<Contender> contenders;
};

/// Whether two families approximate the same function.
bool have_same_target(const FittableFamily& a, const FittableFamily& b);

/// What is published for the target of a family, and every form of that target fitted to it: the family's own
/// under least squares in each measure, all under minimax of the absolute and the relative error. A fit that
/// does not converge is left out. Errors are enclosed to a relative `width`.
///
/// At an exponent a lobe's published numbers are all held up, whatever exponents they were printed for: that
/// is how they are used.
Comparison compare_forms(const FittableFamily& family, const Setting& setting, double width,
                         const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
