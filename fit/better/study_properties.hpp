#pragma once

#include <string>
#include <vector>

#include "fit/better/sampled_curve.hpp"
#include "fit/quadrature/metric.hpp"

/// What a renderer relies on beside a small error.
namespace shadefit {

/// A property that a form shares with its target.
struct StudyProperty {
  std::string words;        ///< "exact at x = 0", "rises", "falls", "not negative", "at most 1"
  Constraints constraints;  ///< under which a fit has it; none if there are no such
  /// Of a form that is exact at an end only to its printed digits: how far they may move it there. Else 0.
  double digits = 0;
  bool is_proven = false;  ///< by `prove_properties`, on the whole range; else it is sampled
};

/// The size of a target: the largest magnitude of its finite samples.
double size_of(const SampledCurve& curve);

/// An error that may as well have any other value up to the largest one is below this share of it in one of a
/// hundred cases.
inline constexpr double share_by_chance = 0.01;

/// The properties of a curve that its target has too, sampled at its places. In one variable: that it is
/// exact at an end, and that it never falls or never rises. In several: that it is exact at an end of one of
/// them, which no fit can be asked for and is not proven. Always: that it is not negative, and at most 1.
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

/// The same with what is known of each: "exact at x = 0 (proven), rises (sampled)".
std::string text_with_proofs(const std::vector<StudyProperty>& properties);

/// All constraints together.
Constraints constraints_of(const std::vector<StudyProperty>& properties);

}  // namespace shadefit
