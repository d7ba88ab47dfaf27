#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "fit/bounds/jumps.hpp"
#include "fit/bounds/study_box.hpp"
#include "fit/formula/graph.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/proof/interval.hpp"

namespace shadefit {

/// What is known of a function on a box.
struct LowestOnBox {
  Interval values;       ///< encloses all of them
  bool may_have_pole;    ///< whether an operation may be unbounded or have no value
  bool may_jump;         ///< whether a choice, sign, floor or atan2 may jump
  double lowest;         ///< no value is below; -infinity if no bound was found
  StudyBox place;        ///< one place, where the least value is likely
  std::size_t axis = 0;  ///< the variable at which to cut the box for a better bound
};

/// A function of the variables of a study in interval arithmetic, bounded from below on boxes.
class LowestValue {
 public:
  /// The function is a node of a graph whose inputs are the variables, one for each range, and then the
  /// parameters.
  LowestValue(Graph graph, int node, std::vector<Domain> ranges, std::span<const Interval> parameters);

  /// A bound by the values of the formula, or, without pole and jump, by the mean value theorem, f(x) = f(p)
  /// + sum of slope_i (x_i - p_i). p_i is the lower end of the box if f rises with x_i, the upper one if it
  /// falls, otherwise the middle. A variable without a bounded slope keeps its whole interval. Slopes are
  /// those on the face of these ends. Stops early if no value is below `enough`.
  LowestOnBox on(const StudyBox& box, double enough = -std::numeric_limits<double>::infinity());

 private:
  const Interval& values_on(const StudyBox& box);
  bool may_have_pole() const;  ///< on the box of the last values
  void improve_by_mean_value(const StudyBox& box, LowestOnBox& result);
  /// The face of a box on which the least value is, as far as slopes tell: on a face they are narrower, and
  /// may tell more. The last slopes are those on it, unless it is a single place.
  StudyBox least_face(StudyBox box);

  std::vector<Domain> ranges_;
  Jumps jumps_;
  std::size_t operations_;       ///< nodes of the function
  TapeProgram<Interval> value_;  ///< of the function, all operations, and the deciding nodes of the jumps
  TapeProgram<Interval> slopes_;
};

}  // namespace shadefit
