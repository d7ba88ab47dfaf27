#pragma once

#include <string>
#include <vector>

#include "fit/better/sampled_curve.hpp"
#include "fit/quadrature/metric.hpp"

/// What a renderer relies on beside a small error.
namespace shadefit {

/// A property that a form shares with its target.
struct StudyProperty {
  /// "exact at x = 0", "rises", "falls", "not negative", "at most 1"; of several variables "rises in x".
  std::string words;
  Constraints constraints;   ///< that the form keeps; none if there are no such
  std::size_t variable = 0;  ///< along which it rises or falls, or at whose end it is exact
  /// Of a form that is exact at an end only to its printed digits: how far they may move it there, of several
  /// variables at most. Else 0.
  double digits = 0;
  bool is_proven = false;     ///< by `prove_properties`, on the whole range; else it is sampled
  std::string unproven = {};  ///< why there is no proof
};

/// The size of a target: the largest magnitude of its finite samples.
double size_of(const SampledCurve& curve);

/// An error that may as well have any other value up to the largest one is below this share of it in one of a
/// hundred cases.
inline constexpr double share_by_chance = 0.01;

/// The properties of a curve that its target has too, sampled at its places: that it is exact at an end of a
/// variable, that it never falls or never rises along one, that it is not negative, and at most 1. Of
/// measured rows the ends are not looked at, and rows count as a line along a variable if they differ in it
/// alone. In several variables no fit can be asked to be exact or monotone.
///
/// Exact is an error of at most 2^-24 of the largest target, the last place of a float. Published
/// constants, `printed`, have another limit: half a unit of each last digit moves the form by so much. The
/// error also has to be at most `share_by_chance` of the largest one.
std::vector<StudyProperty> properties_of(const ReadStudy& study, const SampledCurve& curve,
                                         const std::vector<std::string>& printed = {});

/// Those of `wanted` that `found` lacks. Of an end that is exact to printed digits, `found` has to be exact.
std::vector<StudyProperty> lost_properties(const std::vector<StudyProperty>& wanted,
                                           const std::vector<StudyProperty>& found);

/// "exact at x = 0 to its digits, rises"; "none" without any.
std::string to_text(const std::vector<StudyProperty>& properties);

/// The same with what is known of each: "exact at x = 0 (proven), rises (sampled: the form has an
/// integral)".
std::string text_with_proofs(const std::vector<StudyProperty>& properties);

/// All constraints together.
Constraints constraints_of(const std::vector<StudyProperty>& properties);

}  // namespace shadefit
