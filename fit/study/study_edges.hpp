#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "fit/formula/hinge_zeros.hpp"
#include "fit/study/study.hpp"

/// Where the formulas of a study are not smooth: the ends of the panels on which it is summed.
namespace shadefit {

class KnownZeros {
 public:
  /// A hinge and the range of its variable.
  using Of = std::tuple<std::string, bool, bool, double, double>;

  /// The edges that `find` gives for it, which is called where they are not known. Safe under threads.
  std::vector<StudyEdge> of(const Of& hinge, const std::function<std::vector<StudyEdge>()>& find);

 private:
  std::mutex lock_;
  std::map<Of, std::vector<StudyEdge>> found_;
};

/// The edges of an axis, rising: both ends of its range, and inside it the zeros of the hinges that depend on
/// this variable alone.
std::vector<StudyEdge> edges_of(const ReadStudy& study, std::size_t axis);
/// Those of each axis; none of measured rows.
std::vector<std::vector<StudyEdge>> edges_of(const ReadStudy& study);

/// The edges of an axis where the variables before it have given values: max(x, y) has its kink at y = x. One
/// thread uses it at a time.
class MovingEdges {
 public:
  /// `edges` are those of the axis.
  MovingEdges(const ReadStudy& study, std::size_t axis, std::vector<StudyEdge> edges);

  bool are_fixed() const { return mixed_.empty(); }
  std::vector<StudyEdge> at(std::span<const long double> before);

 private:
  const StudyAxis& axis_;
  std::vector<StudyEdge> edges_;   ///< and the ends where a root is zero in a corner
  std::vector<HingeCurve> mixed_;  ///< the hinges that depend on the axis and on axes before it alone
};

/// Edges with both sides of each jump in place of it: first the left one, which has `is_jump`. Of a jump at
/// an end they are the end and its side.
std::vector<StudyEdge> with_sides(const std::vector<StudyEdge>& edges);

/// The parts of the form at whose zeros it has a kink that parameters move: a x - b of max(a x, b).
std::vector<Symbolic> moving_kinks(const ReadStudy& study);
/// The denominators of the form, and the operands of its logarithms, that contain a parameter.
std::vector<Symbolic> moving_poles(const ReadStudy& study);

/// The edges of an axis and the zeros of formulas of its variable alone.
std::vector<StudyEdge> with_zeros(const StudyAxis& axis, std::vector<StudyEdge> edges,
                                  const std::vector<Symbolic>& formulas);

/// A formula of the study at given parameters.
Symbolic at_parameters(const ReadStudy& study, const Symbolic& formula,
                       const std::vector<double>& parameters);

/// The zeros of a formula of one variable, its ends included, as `HingeCurve` finds them.
std::vector<double> zeros_of(const Symbolic& formula, const StudyAxis& axis);

}  // namespace shadefit
