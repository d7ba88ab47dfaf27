#include "fit/panels/features.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string>

#include "fit/panels/enclosed_curve.hpp"
#include "fit/quadrature/gauss.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

/// The polynomial through a curve at the Gauss nodes of a panel, in the root of the distance in which the
/// curve is smooth.
class Interpolant {
 public:
  Interpolant(EnclosedCurve& curve, StudyEdge left, StudyEdge right)
      : root_(right.power > 1 ? right.at : left.at),
        length_((right.power > 1 ? left.at : right.at) - root_),
        power_(std::max(left.power, right.power)) {
    visit_gauss_rule<double>(nodes, [&](double u, double weight) {
      const double sign = places_.size() % 2 == 0 ? 1 : -1;
      places_.push_back(u);
      weights_.push_back(sign * std::sqrt(u * (1 - u) * weight));
      values_.push_back(curve.at(root_ + length_ * std::pow(u, power_)).value);
    });
  }

  double operator()(double x) const {
    const double u = std::pow((x - root_) / length_, 1.0 / power_);
    double above = 0, below = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (u == places_[i]) return values_[i];
      const double share = weights_[i] / (u - places_[i]);
      above += share * values_[i];
      below += share;
    }
    return above / below;
  }

 private:
  static constexpr unsigned nodes = 30;  // those of a search: `search_rule`

  double root_, length_;
  int power_;
  std::vector<double> places_, weights_, values_;
};

/// Whether the nodes of a panel see the curve in the middle of each box and at its ends.
bool is_seen(EnclosedCurve& curve, StudyEdge left, StudyEdge right, std::span<const CurveBox> boxes,
             double tolerance) {
  const Interpolant interpolant(curve, left, right);
  // So near to a root a panel is not cut: the nodes are dense there, and it has no end.
  const double near = std::ldexp(right.at - left.at, -20);
  const auto is_seen_at = [&](double x) {
    if (left.power > 1 && x - left.at < near) return true;
    if (right.power > 1 && right.at - x < near) return true;
    const EnclosedCurve::Value value = curve.at(x);
    return !std::isfinite(value.rounding) ||
           std::abs(interpolant(x) - value.value) <= tolerance + 4 * value.rounding;
  };
  return std::ranges::all_of(boxes, [&](const CurveBox& box) {
    return is_seen_at(box.middle()) && (box.right == right.at || is_seen_at(box.right));
  });
}

/// How many of the boxes from a pole, or from where the curve has no value, become narrower towards it as
/// they do at any pole.
std::size_t graded(std::span<const CurveBox> boxes, double pole) {
  constexpr double least = 1.0 / 16;  // of the distance; at a pole of order 1 boxes have about half of it
  const auto is_narrow = [&](const CurveBox& box) {
    const double distance = std::min(std::abs(box.left - pole), std::abs(box.right - pole));
    return box.right - box.left < least * distance;
  };
  return static_cast<std::size_t>(std::ranges::find_if(boxes, is_narrow) - boxes.begin());
}

/// Cuts a panel whose nodes do not see the curve. Each part is as long as it can be, by halves of the boxes
/// that are left.
void cut_panel(EnclosedCurve& curve, StudyEdge left, StudyEdge right, std::span<const CurveBox> boxes,
               double range, double share, std::vector<double>& cuts) {
  if (!std::isfinite(curve.at(left.at).value)) {
    boxes = boxes.subspan(graded(boxes, left.at));
    if (boxes.empty()) return;
    cuts.push_back(boxes.front().left);
    left = {boxes.front().left};
  }
  if (!std::isfinite(curve.at(right.at).value)) {
    const std::vector<CurveBox> from_right(boxes.rbegin(), boxes.rend());
    boxes = boxes.first(boxes.size() - graded(from_right, right.at));
    if (boxes.empty()) return;
    cuts.push_back(boxes.back().right);
    right = {boxes.back().right};
  }
  if (is_seen(curve, left, right, boxes, share * range)) return;
  // The flanks of a feature belong to its panels: what a long panel has of them its rules would not see.
  constexpr double flank = 1e-13;
  const double tolerance = flank * range;
  while (!boxes.empty()) {
    std::size_t count = boxes.size();
    for (; count > 1; count = (count + 1) / 2) {
      const StudyEdge end = count == boxes.size() ? right : StudyEdge{boxes[count - 1].right};
      if (is_seen(curve, left, end, boxes.first(count), tolerance)) break;
    }
    if (count == boxes.size()) return;
    boxes = boxes.subspan(count);
    cuts.push_back(boxes.front().left);
    left = {boxes.front().left};
  }
}

/// The panels between edges: roots at both ends of one are in two.
std::vector<StudyEdge> with_middles(const std::vector<StudyEdge>& edges) {
  std::vector<StudyEdge> result{edges.front()};
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i - 1].power > 1 && edges[i].power > 1)
      result.push_back({edges[i - 1].at + (edges[i].at - edges[i - 1].at) / 2});
    result.push_back(edges[i]);
  }
  return result;
}

/// The parts of a formula that have no parameter, as large as possible: of a + b exp(-x^2) the last factor.
void collect_fixed_parts(const Symbolic& formula, const StudyAxis& axis, std::vector<Symbolic>& parts) {
  const std::set<std::string> names = free_variables(formula);
  if (names.empty() || formula.parts().empty()) return;
  if (names.size() == 1 && names.contains(axis.variable)) return parts.push_back(formula);
  for (const Symbolic& part : formula.parts()) collect_fixed_parts(part, axis, parts);
}

void collect_summands(const Symbolic& e, std::vector<Symbolic>& summands) {
  const bool is_sum = e.kind() == Symbolic::Kind::add || e.kind() == Symbolic::Kind::subtract ||
                      e.kind() == Symbolic::Kind::negate;
  if (!is_sum) return summands.push_back(e);
  for (const Symbolic& part : e.parts()) collect_summands(part, summands);
}

/// The common parts of the boxes of all summands of a formula whose values have this range.
CurveBoxes boxes_of_summands(const Symbolic& formula, const StudyAxis& axis,
                             const std::vector<StudyEdge>& panels, double share, double range) {
  std::vector<Symbolic> summands;
  collect_summands(formula, summands);
  CurveBoxes result{{}, range, {}};
  std::vector<double> ends{panels.front().at};
  for (const Symbolic& summand : summands) {
    EnclosedCurve curve(summand, axis.variable);
    const CurveBoxes of_summand = boxes_of(curve, panels, share, range);
    for (const CurveBox& box : of_summand.boxes) ends.push_back(box.right);
    if (!result.unresolved) result.unresolved = of_summand.unresolved;
  }
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (std::size_t i = 1; i < ends.size(); ++i) result.boxes.push_back({ends[i - 1], ends[i], 0});
  return result;
}

}  // namespace

Features features_of(const Symbolic& formula, const StudyAxis& axis, const std::vector<StudyEdge>& edges,
                     double share) {
  EnclosedCurve curve(formula, axis.variable);
  const std::vector<StudyEdge> panels = with_middles(edges);
  CurveBoxes found = boxes_of(curve, panels, share);
  // Where one summand has overflowed, such as the denominator of 1/cosh(1e5 x), the series of all is lost.
  if (found.unresolved) found = boxes_of_summands(formula, axis, panels, share, found.range);
  Features features{{}, found.unresolved};
  for (std::size_t i = 1; i < panels.size(); ++i) {
    const auto first = std::ranges::lower_bound(found.boxes, panels[i - 1].at, {}, &CurveBox::left),
               last = std::ranges::lower_bound(found.boxes, panels[i].at, {}, &CurveBox::left);
    cut_panel(curve, panels[i - 1], panels[i], {first, last}, found.range, share, features.cuts);
  }
  return features;
}

bool is_enclosed(const ReadStudy& study) {
  // A rule's sum of an integral has hundreds of terms, and an albedo has no enclosure.
  return study.axes.size() == 1 && integral_depth(error_formula(study)) == 0;
}

std::optional<double> cut_at_features(ReadStudy& study) {
  if (study.rows || !is_enclosed(study)) return std::nullopt;
  StudyAxis& axis = study.axes.front();
  // What is unexplained is below a thousandth of the range of a formula.
  constexpr double share = 1e-3;
  std::vector<Symbolic> formulas{study.target, study.weight, axis.density};
  collect_fixed_parts(study.form, axis, formulas);
  std::optional<double> unresolved;
  const std::vector<StudyEdge> edges = edges_of(study, 0);
  for (const Symbolic& formula : formulas) {
    if (free_variables(formula).empty() || formula.parts().empty()) continue;
    const Features features = features_of(formula, axis, edges, share);
    axis.cuts.insert(axis.cuts.end(), features.cuts.begin(), features.cuts.end());
    if (!unresolved) unresolved = features.unresolved;
  }
  return unresolved;
}

Features features_of_error(const ReadStudy& study, const std::vector<double>& parameters) {
  if (study.rows || !is_enclosed(study)) return {};
  // A tenth of the level, of a curve between -level and level.
  constexpr double share = 0.05;
  ReadStudy at = study;
  at.form = at_parameters(study, study.form, parameters);
  if (study.residual) at.residual = at_parameters(study, *study.residual, parameters);
  return features_of(error_formula(at), at.axes.front(), edges_of(at, 0), share);
}

std::string why_unresolved(const ReadStudy& study, double place) {
  return "more happens near " + study.axes.front().variable + " = " + decimal(place, 6) +
         " than samples explain";
}

}  // namespace shadefit
