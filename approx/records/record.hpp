#pragma once

#include <span>
#include <string_view>

/// Records: what was published, where, and its meaning. Records are data; the formulas are separate.
namespace shadefit {

/// Where a number was published. `title` is quoted as it stands there.
struct Source {
  std::string_view author;
  int year;
  std::string_view title;
  std::string_view place;
  std::string_view address = {};  ///< on the web; empty where `place` is one, or where we know none
};

/// A mistyped copy of a published number that is in circulation, and where it was seen.
struct Variant {
  std::string_view printed;
  std::string_view seen_in;
};

/// The meaning of a published number: the computation that has to reproduce it.
enum class Statement {
  best_fit,       ///< the optimum of its family (at the single number in `exponents`, if the family has an
                  ///< exponent)
  mean_of_fits,   ///< the arithmetic mean of the optima over the sweep `exponents`
  limit_of_fits,  ///< the optimum as the exponent grows without bound
  fit_somewhere,  ///< the optimum at exponents that the source does not state
};

/// A closed form that gives a published number by convention instead of a fit.
struct Convention {
  std::string_view name = {};     ///< empty if the number has no convention
  std::string_view formula = {};  ///< as text
  double (*value)() = nullptr;
};

/// One published constant of a fitted family.
struct Published {
  std::string_view id;         ///< its name in the ledger, e.g. "sg-offset-k5"
  std::string_view family;     ///< the family that refits it, e.g. "sg-offset"
  std::string_view parameter;  ///< which parameter of that family
  std::string_view printed;    ///< the digits as printed: their number matters
  Statement statement;
  std::string_view exponents = {};  ///< "5", or a sweep "3:15:1"; empty where the family has none
  Convention convention = {};
  Source source;
  std::span<const Variant> variants = {};
};

/// The trend of a curve with the angle, that is from c = 1 down to c = 0.
enum class Trend {
  none,   ///< nothing is said
  falls,  ///< never rises
  rises,  ///< never falls
};

/// Properties that a form must have at its published and fitted parameters; an interval proof shows them
/// (fit/proof/curve_proof.hpp).
struct CurveShape {
  Trend trend = Trend::none;
  bool is_non_negative = false;
  bool is_at_most_one = false;
  bool operator==(const CurveShape&) const = default;
};

/// The description of a family of approximations for readers. Its target and form are templates that print
/// themselves.
struct Family {
  std::string_view id;
  std::string_view title;
  std::string_view variables;  ///< what each letter means
  /// Exponents to fit by default: numbers and A:B:STEP, separated by commas; empty: no exponent.
  std::string_view sweep = {};
  /// A form that no source names, for comparison: `fit` and `list` show it, a report only on request.
  bool is_comparison = false;
  CurveShape curve = {};
};

/// One published normalisation constant: a closed form that numerical integration has to confirm.
struct Normalisation {
  std::string_view id;
  std::string_view lobe;     ///< the function whose integral over the hemisphere is normalised
  std::string_view printed;  ///< the closed form as printed, a = alpha
  bool has_exponent;
  Source source;
  /// The relative difference that its source's claim allows: 0 for an exact closed form.
  double closeness = 0;
};

}  // namespace shadefit
