#pragma once

#include <memory>
#include <vector>

#include "fit/minimax/minimax.hpp"
#include "fit/study/study.hpp"
#include "fit/study/study_nodes.hpp"

/// Formulas of a study along its variable, as curves of the exchange.
namespace shadefit {

/// A part of the range between two edges. At an end where a formula has a root, the variable is the square of
/// s: the error may have an infinite slope there.
struct SearchPanel {
  double left, right;
  bool is_rooted_left, is_rooted_right;

  /// The variable at s in [0, 1].
  template <class T>
  T at(T s) const {
    const T low = left, high = right, rest = 1 - s;
    if (is_rooted_left) return low + (high - low) * (s * s);
    if (is_rooted_right) return high - (high - low) * (rest * rest);
    return low + (high - low) * s;
  }
  /// The derivative of the variable by s.
  template <class T>
  T slope(T s) const {
    const T length = T(right) - T(left);
    return is_rooted_left ? 2 * length * s : is_rooted_right ? 2 * length * (1 - s) : length;
  }
  double curvature() const { return (is_rooted_left ? 2 : is_rooted_right ? -2 : 0) * (right - left); }
};

/// The panels between edges.
std::vector<SearchPanel> panels_between(const std::vector<StudyEdge>& edges);

enum class CurveOf { formula, slope };

/// A formula of the variable and the parameters, or its slope along the variable, over panels. The search
/// visits `places`. One thread uses the curve at a time.
MinimaxCurve panel_curve(const ReadStudy& study, const Symbolic& formula, CurveOf of,
                         const std::vector<SearchPanel>& panels, const std::vector<SearchPlace>& places);

}  // namespace shadefit
