#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fit/bounds/prove_shape.hpp"
#include "fit/bounds/study_box.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/checkpoint.hpp"

/// Proofs on boxes, which are cut until a rule holds.
namespace shadefit {

/// How far a form may violate a constraint on a box.
struct Violation {
  double amount;
  std::size_t axis = 0;                           ///< the variable at which to cut the box
  std::optional<std::vector<double>> place = {};  ///< where it is proven to violate it by more than the slack
};

/// A constraint on a box.
using ShapeRule = std::function<Violation(const StudyBox&)>;

/// A box and how far the form may violate the constraint there.
struct JudgedBox {
  StudyBox box;
  double amount;
  std::size_t axis;  ///< the variable at which to cut the box
};

/// Which boxes have to be cut. No box: the constraint holds.
using BoxesToCut = std::function<std::vector<bool>(std::span<const JudgedBox>)>;

/// Those on which the violation is above the slack.
BoxesToCut each_above(double slack);

/// Those that lie on a line along a variable on which the violations add up to more than the slack. A line
/// that was within it once is done with.
BoxesToCut lines_above(double slack, std::size_t variable, std::span<const Domain> ranges);

/// Proves a constraint on boxes that cover the ranges. They are judged by the rule and cut, until none has to
/// be cut, or there are more than `most`. Then the answer is `open`, with a place in the box of the largest
/// violation.
ShapeProof prove_on_boxes(std::span<const Domain> ranges, const ShapeRule& rule, const BoxesToCut& to_cut,
                          const Checkpoint& checkpoint, std::size_t most = most_shape_boxes);

}  // namespace shadefit
