#pragma once

#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include "fit/catalogue/study_file.hpp"
#include "fit/errors/effect.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/support/memory.hpp"

/// Published constants that a source tree may contain.
namespace shadefit::lint {

struct KnownConstant {
  std::string name;     ///< of a parameter of the form
  std::string printed;  ///< the digits as published
  double value = 0;
  bool is_common = false;   ///< pi/2, 5/12: see is_common_number()
  bool is_of_form = false;  ///< a number in the text of the form: its name is its digits
};

/// A variable of a form and its range.
struct KnownAxis {
  std::string variable;
  double lower = 0, upper = 0;
};

/// A value that its own source or standard has replaced, or a mistyped copy.
struct KnownVariant {
  std::size_t constant = 0;  ///< index in `constants`
  std::string printed;
  std::string replaced;      ///< why it was replaced; empty: it is a mistyped copy
  bool is_borrowed = false;  ///< whether another set publishes these digits: then they tell nothing
  bool is_right = false;     ///< whether a source published it: see append_other_sources()
};

/// Whether a number is, to seven digits, a simple fraction, perhaps times pi, 1/pi, sqrt(2), ln 2 or 1/ln 2.
/// Such numbers occur in all kinds of code, so their digits tell little.
bool is_common_number(double value);

/// Constants that belong together: those of one published form.
struct KnownSet {
  std::string id;    ///< of a study or of a built-in family: "acos-linear"
  std::string form;  ///< the id of the form
  std::string source;
  std::vector<KnownAxis> axes;
  Symbolic formula;  ///< of the variables and the constants
  std::vector<KnownConstant> constants;
  std::vector<KnownVariant> variants = {};
  bool is_encoded = false;  ///< whether the values are signals for a display: see `StudyFile`
  /// The formula with one branch of its choice as another set of the study has it, numbers for its constants:
  /// programs mix u*s with pow((u + a)/b, p).
  std::vector<Symbolic> mixed = {};
};

/// The sets of all studies, and those of the built-in families.
std::vector<KnownSet> known_sets(const std::vector<StudyFile>& studies);

/// The constants of a set as published.
std::vector<double> published_values(const KnownSet& set);

/// The values with which a form compares a variable: 0.04045 for u in u <= t ? a : b. The constants are in
/// the order of the set. The result is NaN for a value that depends on other variables.
std::vector<double> thresholds_of(const KnownSet& set, const Symbolic& form,
                                  const std::vector<double>& constants, const std::string& variable);

/// The effect of this form and these constants, in the order of the set, instead of the published ones: over
/// an even grid of the ranges, and on both sides of each threshold.
Effect effect_of(const KnownSet& set, const Symbolic& form, const std::vector<double>& constants);

/// Whether the values of a set's form lie in [0, 1], as those of a colour do.
bool is_shown(const KnownSet& set);

/// What is computed once of sets that outlive this object: effect_of(), by the set, the text of the form and
/// the constants, and is_shown().
struct KnownEffects {
  Memory<std::tuple<const KnownSet*, std::string, std::vector<double>>, Effect> effects;
  Memory<const KnownSet*, bool> shown;
};

}  // namespace shadefit::lint
