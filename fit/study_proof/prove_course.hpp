#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fit/proof/interval.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/study_proof/lowest_value.hpp"
#include "fit/study_proof/prove_shape.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// The inputs of a form in interval arithmetic.
struct FormInputs {
  /// A formula of these inputs, bounded from below.
  LowestValue lowest_of(const Symbolic& formula) const;
  /// Its slope along a variable.
  LowestValue slope_of(const Symbolic& formula, std::size_t variable) const;

  std::vector<std::string> names;  ///< the variables, one for each range, then the parameters
  std::vector<Domain> ranges;
  std::vector<Interval> parameters;
};

/// Proves that along every line of a variable all falls of a form add up to no more than the slack.
///
/// On a box it falls by no more than the width of the box times the wrong part of the slope; where it has no
/// slope, by no more than the width of its values. A form with one choice is several forms where the choice
/// may switch. If the condition rises or falls along the variable, it switches once: then the falls of both
/// sides count, and the step down between them. If the variable is not in the condition, the larger fall
/// counts.
ShapeProof prove_never_falls(const Symbolic& form, const FormInputs& inputs, std::size_t variable,
                             double slack, const Checkpoint& checkpoint);

}  // namespace shadefit
