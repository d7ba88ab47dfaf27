#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fit/errors/binary_format.hpp"
#include "fit/support/checkpoint.hpp"

/// How a form of a quantity fares under stress.
namespace shadefit {

/// The bound on the error of a robust form, as a count of its roundings. With p digits an operation is off by
/// u = 2^-p of its result at most, and so is a function of half, which is rounded once; a function of float
/// or double by an ulp, 2 u (the manual of the GNU C library, "Errors in Math Functions", x86_64). n of them
/// are off by (1 + u)^n - 1 < e^(n u) - 1 of the result, and u times a number is at most an ulp of it: n
/// roundings are n ulps, slightly more if n u is not small.
///
/// An error in the exponent of an exponential is multiplied by that exponent: each e-fold by which the
/// exponential has fallen (or risen) adds `per_fold`.
struct Roundings {
  double operations = 0, functions = 0;
  double operations_per_fold = 0, functions_per_fold = 0;

  double fixed(const BinaryFormat& format) const;
  double per_fold(const BinaryFormat& format) const;
};

/// "2 + 3 L", L the e-folds.
std::string bound_text(const Roundings& roundings, const BinaryFormat& format);

/// The bound in ulps after so many e-folds.
double bound_ulps(const Roundings& roundings, const BinaryFormat& format, double folds);

/// The result of one form in one format.
struct FormTrial {
  std::string_view topic, form, formula, domain;
  BinaryFormat format = double_format;
  std::optional<Roundings> bound = {};
  long inputs = 0;
  double worst_ulps = 0;      ///< of the results that are numbers
  std::string worst_at = {};  ///< the first input with more than half of the worst error
  long nan = 0, infinite = 0, negative = 0, above = 0;  ///< unusable results; above 1
  std::string first_bad = {};                           ///< the first input of these results
  std::string first_broken = {};  ///< of a robust form: the first input beyond its bound

  /// Whether the form keeps its bound and has no unusable result.
  bool is_kept() const { return first_broken.empty() && first_bad.empty(); }
};

/// The forms of all regimes.
std::vector<FormTrial> forms_under_stress(const Checkpoint& checkpoint);

}  // namespace shadefit
