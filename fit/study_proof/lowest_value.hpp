#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "fit/proof/interval.hpp"
#include "fit/study_proof/jumps.hpp"
#include "fit/study_proof/study_box.hpp"
#include "fit/tape/graph.hpp"
#include "fit/tape/tape_program.hpp"

namespace shadefit {

/// What is known of a function on a box.
struct LowestOnBox {
  Interval values;       ///< encloses all of them; NaN or unbounded near a pole
  bool may_jump;         ///< whether it may be discontinuous by a choice, sign, floor or atan2
  double lowest;         ///< no value is below; -infinity if no bound was found
  std::size_t axis = 0;  ///< the variable at which to cut the box for a better bound
};

/// A function of the variables of a study in interval arithmetic, bounded from below on boxes.
class LowestValue {
 public:
  /// The function is a node of a graph whose inputs are the variables, one for each range, and then the
  /// parameters.
  LowestValue(Graph graph, int node, std::vector<Domain> ranges, std::span<const Interval> parameters);

  /// By the values of the formula, or by the mean value theorem, f(x) = f(p) + sum of slope_i (x_i - p_i),
  /// where slopes exist and are bounded. p_i is the lower end of the box where f rises with x_i, the upper
  /// one where it falls, else the middle. Does no more work once no value is below `enough`.
  LowestOnBox on(const StudyBox& box, double enough = -std::numeric_limits<double>::infinity());

 private:
  struct Programs;
  LowestValue(Programs programs, std::vector<Domain> ranges, std::span<const Interval> parameters);

  const Interval& values_on(const StudyBox& box);
  double by_mean_value(const StudyBox& box, std::size_t& axis);

  std::vector<Domain> ranges_;
  Jumps jumps_;  ///< the outputs of `value_` after the function are those of their deciding nodes
  TapeProgram<Interval> value_, slopes_;
};

}  // namespace shadefit
