#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "approx/cosine.hpp"
#include "fit/fit.hpp"
#include "fit/proof/error_bounds.hpp"
#include "fit/support/checkpoint.hpp"

/// What else there is for a published constant: the same form under other objectives, and other forms of the
/// same target, each with what it costs and how wrong it is, proven.
namespace shadefit {

/// A curve with its constants, or the target itself.
struct Contender {
  enum class Kind { published, fitted, target };

  Kind kind;
  std::string_view family;     ///< the id; empty of Schlick's formula and of the target itself
  std::string_view published;  ///< the id of the first of the printed numbers, or "schlick"; else empty
  std::string form;            ///< as text
  std::string origin;          ///< whose constants they are: a source, or the objective of a fit
  std::vector<std::pair<std::string, std::string>> parameters;  ///< names and texts, of fits hexadecimal
  std::vector<double> values;                                   ///< the same as doubles
  Operations operations;                ///< with its constants in, as `emit` writes it
  ErrorBounds max_abs_error;            ///< proven
  std::optional<Cosine<double>> at;     ///< a place where it is largest; sampled; empty of the target itself
  std::optional<double> max_rel_error;  ///< sampled, of what the family's `relative_to` says
  double rms_error;                     ///< uniform in the cosine
  /// The published curves of the same target whose proven error is larger at no fewer instructions; of the
  /// target itself, which is no approximation, empty.
  std::vector<std::string_view> beats = {};
};

/// All contenders for one target: the published ones first, each part by rising error.
struct Comparison {
  const FittableFamily* family;  ///< whose target it is
  Setting setting;               ///< exponent or surface
  Domain domain;
  std::vector<Contender> contenders = {};
  std::vector<std::string> left_out = {};  ///< fits that did not converge: form, objective and why
};

/// How a comparison is made.
struct Contest {
  Domain domain = {};
  double width;               ///< of the bounds, relative to the error
  bool only_minimax = false;  ///< only the fits of least absolute error beside what is published
};

/// Whether two families approximate the same function.
bool have_same_target(const FittableFamily& a, const FittableFamily& b);

/// What is published for the target of a family, every form of that target fitted to it, the family's own
/// under least squares in each measure and all under minimax of the absolute and of the relative error; and
/// the target by its own operations. On an exact surface Schlick's formula is one of the published curves.
/// Errors are of the lobe, or of the reflectance F where a Fresnel form has a surface.
///
/// At an exponent a lobe's published numbers are all held up, whatever exponents they were printed for: that
/// is how they are used.
Comparison compare_forms(const FittableFamily& family, const Setting& setting, const Contest& contest,
                         const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
