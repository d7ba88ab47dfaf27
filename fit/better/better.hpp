#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "approx/cosine.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/support/checkpoint.hpp"

/// Alternatives to a published constant: the same form under other objectives, and other forms of the same
/// target, each with its cost and its proven error.
namespace shadefit {

/// max |error| lies in [lower, upper].
struct ErrorBounds {
  double lower = 0, upper = 0;
  bool is_reached = true;  ///< whether the requested width is reached
};

/// A curve with its constants, or the target itself.
struct Contender {
  enum class Kind { published, fitted, target };

  Kind kind;
  std::string_view family = {};     ///< the id; empty for Schlick's formula and for the target itself
  std::string_view published = {};  ///< the id of the first of the printed numbers, or "schlick"; else empty
  std::string form;                 ///< as text
  std::string origin = {};          ///< where the constants come from: a source, or the objective of a fit
  std::vector<std::pair<std::string, std::string>> parameters =
      {};                           ///< names and texts; hexadecimal for fits
  std::vector<double> values = {};  ///< the same as doubles
  Operations operations;            ///< with constants, as `emit` writes it
  ErrorBounds max_abs_error = {};   ///< proven
  std::optional<Cosine<double>> at =
      {};  ///< a place of the largest error; sampled; empty for the target itself
  std::optional<double> max_rel_error;  ///< sampled, relative to the family's `relative_to`
  double rms_error = 0;                 ///< uniform in the cosine
  /// The published curves of the same target that have a larger proven error at no fewer instructions. Empty
  /// for the target itself, which is not an approximation.
  std::vector<std::string_view> beats = {};
};

/// All contenders for one target: first the published ones, then the others, both by rising error.
struct Comparison {
  const Family* family;  ///< whose target it is
  Setting setting;       ///< exponent or surface
  Domain domain;
  std::vector<Contender> contenders = {};
  std::vector<std::string> left_out = {};  ///< fits that did not converge: form, objective and reason
};

/// The options of a comparison.
struct ComparisonOptions {
  Domain domain = {};
  double width;               ///< of the bounds, relative to the error
  bool only_minimax = false;  ///< only minimax fits of the absolute error, besides the published constants
};

/// Whether two families approximate the same function.
bool have_same_target(const Family& a, const Family& b);

/// Compares the published constants for the target of a family, the fits of every form of that target, and
/// the target by its own operations. The family's own form is fitted by least squares in each measure; all
/// forms are fitted by minimax of the absolute and of the relative error. On an exact surface Schlick's
/// formula is one of the published curves. Errors are those of the lobe, or of the reflectance F if a Fresnel
/// form has a surface.
///
/// At an exponent, all published numbers of a lobe are compared, even those printed for other exponents,
/// because that is how they are used.
Comparison compare_forms(const Family& family, const Setting& setting, const ComparisonOptions& options,
                         const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
