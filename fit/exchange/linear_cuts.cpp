#include "fit/exchange/linear_cuts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/exchange/constrained_study.hpp"
#include "fit/formula/graph.hpp"
#include "fit/squares/equal_candidates.hpp"
#include "fit/squares/row_descent.hpp"
#include "fit/study/even_grid.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {

namespace {

Tape tape_of_heights(const ReadStudy& study, const Symbolic& formula, bool is_slope) {
  Graph graph(formula_inputs(study));
  const int node = graph.add(formula);
  const std::vector<int> outputs{is_slope ? graph.derivative(node, 0) : node};
  return {graph, outputs};
}

/// The curves of the error that the level bounds, then those of the constraints. Of `exact_at` there are two,
/// the difference and its negative, which count at its places alone.
std::vector<LinearCurve> linear_curves(const ReadStudy& study, const Constraints& constraints) {
  std::vector<LinearCurve> curves;
  const auto add = [&](Touch touch, double share, const std::string& bound, const Symbolic& formula,
                       bool is_slope = false) {
    curves.push_back({touch, share,
                      bound.empty() ? "the form cannot be exact" : "no parameters keep the form " + bound,
                      tape_of_heights(study, formula, is_slope), CurveParts(study, formula, is_slope, true)});
  };
  const Symbolic error = error_formula(study);
  // The factor of a relative error has the sign of the target: a side is that of the form itself.
  const Symbolic difference = difference_of(study);
  add(Touch::highest, 1, "", error);
  add(Touch::lowest, 1, "", -error);
  if (constraints.one_sided == Side::above) add(Touch::lowest, 0, ">= target", -difference);
  if (constraints.one_sided == Side::below) add(Touch::highest, 0, "<= target", difference);
  if (constraints.at_most) {
    const std::string most = to_text(*constraints.at_most);
    add(Touch::at_most, 0, "<= " + most, study.form - Symbolic::number(most));
  }
  if (constraints.at_least) {
    const std::string least = to_text(*constraints.at_least);
    add(Touch::at_least, 0, ">= " + least, Symbolic::number(least) - study.form);
  }
  if (constraints.monotone == Course::falls) add(Touch::falls, 0, "falling", study.form, true);
  if (constraints.monotone == Course::rises) add(Touch::rises, 0, "rising", -study.form, true);
  if (!constraints.exact_at.empty()) {
    add(Touch::exact, 0, "", difference);
    add(Touch::exact, 0, "", -difference);
  }
  return curves;
}

}  // namespace

bool keeps_constraints(const ReadStudy& study, const Constraints& constraints) {
  constexpr double rounding = 1e-12;
  const double size = 1 + largest_error(study, {}).magnitude;
  const Edges edges = edges_of(study);
  for (LinearCurve& curve : linear_curves(study, constraints)) {
    if (curve.share > 0) continue;
    const auto keeps = [&](double height) { return height <= rounding * size; };
    if (curve.touch == Touch::exact) {
      for (const double x : constraints.exact_at)
        if (!keeps(static_cast<double>(curve.parts.at({x}, {}).front().value))) return false;
    } else {
      for (const StudyExtremum& top : tops_of(curve.heights, 0.0, edges, {}, 1))
        if (!keeps(top.magnitude)) return false;
    }
  }
  return true;
}

LinearCuts::LinearCuts(const LinearProblem& problem)
    : LinearProblem(problem),
      is_minimax(norm == Norm::minimax),
      start(wide(free)),
      curves(linear_curves(study, constraints)),
      parameters(start) {}

bool LinearCuts::begin(bool is_long) {
  if (!measure() || !cut_grid()) return false;
  double longest = 1;
  for (const Cut& cut : cuts)
    if (is_long && share_of(cut.of) == 0) longest = std::max(longest, -cut.condition.bound);
  unit *= longest;
  steps *= longest;
  return longest == 1 || cut_grid();
}

bool LinearCuts::measure() {
  VectorOf<double> errors;
  MatrixOf<double> slopes;
  sampled.errors(rounded(), errors, &slopes);
  constexpr double least = 1e-3;  // of the target: constraints alone move an exact form
  unit = errors.cwiseAbs().maxCoeff();
  if (unit <= 1e-14 * sampled.target_norm()) unit = least * sampled.target_norm();
  if (!(unit > 0) || !errors.allFinite())
    return fail(fit, Status::not_finite, "the error at the start is not finite");
  steps = row_directions(slopes, unit);
  if (steps.cols() == slopes.cols()) return true;
  const std::string names = flat_direction(study, sampled, rounded());
  return fail(fit, Status::degenerate,
              names.empty() ? "the parameters do not move the error independently" : names);
}

bool LinearCuts::cut_grid() {
  constexpr std::array grid_steps{64, 10, 5};
  const std::vector<Place> grid = even_grid(study.axes, grid_steps[study.axes.size() - 1]);
  std::vector<Place> exact;
  for (const double x : constraints.exact_at) exact.push_back({x});
  cuts.clear();
  largest_.assign(curves.size(), 0);
  for (std::size_t curve = 0; curve < curves.size(); ++curve) {
    const bool is_exact = curves[curve].touch == Touch::exact;
    if (!is_exact && !is_searched(curve)) continue;
    for (const Place& place : is_exact ? exact : grid) {
      if (!cut(curve, place)) return false;
    }
  }
  return true;
}

bool LinearCuts::cut(std::size_t curve, const Place& place) {
  const double share = curves[curve].share;
  const CurvePart part = curves[curve].parts.at(place, start).front();
  const double slope = along(part.slope).norm();
  if (!std::isfinite(slope) || !std::isfinite(part.value)) return true;
  largest_[curve] = std::max(largest_[curve], slope);
  constexpr double unmoved = 1e-13;  // of the largest slope of the curve
  if (share == 0 && !(slope > unmoved * largest_[curve])) {
    const double rounding = 1e-12 * std::max(sampled.target_norm(), largest_[curve]);
    return part.value <= rounding || end_impossible(curve, place);
  }
  const Bounded of{curve, place, 0, share > 0 ? unit : slope};
  cuts.push_back({of, condition(of)});
  return true;
}

Condition LinearCuts::condition(const Bounded& of) {
  const CurvePart part = curves[of.curve].parts.at(of.place, start)[of.part];
  Condition result{{}, -static_cast<double>(part.value / static_cast<long double>(of.unit))};
  const VectorOf<double> slope = along(part.slope) / of.unit;
  std::copy(slope.begin(), slope.end(), result.slope.begin());
  result.slope[static_cast<std::size_t>(size())] = -share_of(of);
  return result;
}

double LinearCuts::excess(std::size_t curve, const CurvePart& part) const {
  const double share = curves[curve].share, of_condition = share > 0 ? unit : along(part.slope).norm();
  return static_cast<double>(part.value / static_cast<long double>(of_condition)) - share * level;
}

std::vector<Place> LinearCuts::tops(std::size_t curve) {
  // Between places of a grid a constraint may be violated by little, where both are below its bound.
  const double ground = curves[curve].share > 0 ? 0 : -largest_[curve];
  const double share = curves[curve].share > 0 ? 0.9 : 0.3;  // of the highest
  std::vector<Place> result;
  for (const StudyExtremum& found : tops_of(curves[curve].heights, ground, edges, rounded(), share))
    result.push_back(top_near(curves[curve].parts, found.at, parameters, edges));
  return result;
}

double LinearCuts::add_tops() {
  checkpoint();
  constexpr double same = 1e-12;  // of the range
  double highest = 0;
  for (std::size_t curve = 0; curve < curves.size(); ++curve) {
    if (!is_searched(curve)) continue;
    for (const Place& place : tops(curve)) {
      const CurvePart part = curves[curve].parts.at(place, parameters).front();
      const double over = excess(curve, part);
      if (!(over > least_excess) || !part.slope.allFinite()) continue;
      highest = std::max(highest, over);
      const bool is_known = std::any_of(cuts.begin(), cuts.end(), [&](const Cut& cut) {
        return cut.of.curve == curve && are_near(cut.of.place, place, study.axes, same);
      });
      if (!is_known) cut(curve, place);
    }
  }
  return highest;
}

bool LinearCuts::end_violated() {
  const Cut* worst = nullptr;
  double most = 0;
  for (const Cut& cut : cuts) {
    if (curves[cut.of.curve].share > 0) continue;
    const double over = excess(cut.of.curve, parts(cut.of).front());
    if (!(over > most)) continue;
    most = over;
    worst = &cut;
  }
  if (worst == nullptr)
    return fail(fit, Status::not_converged, "the programme has no answer up to its rounding");
  return end_impossible(worst->of.curve, worst->of.place);
}

bool LinearCuts::end_impossible(std::size_t curve, const Place& place) {
  return fail(fit, Status::infeasible,
              curves[curve].broken + " at " + study.axes.front().variable + " = " + to_text(place.front()));
}

}  // namespace shadefit
