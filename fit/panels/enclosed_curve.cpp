#include "fit/panels/enclosed_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <span>

namespace shadefit {
namespace {

/// A smooth formula needs some tens; the curve of ACES, many functions inside one another, 16 000.
constexpr std::size_t most_curve_boxes = 32768;

bool is_explained_more(const CurveBox& a, const CurveBox& b) {
  return a.remainder < b.remainder;
}

}  // namespace

EnclosedCurve::EnclosedCurve(const Symbolic& formula, const std::string& variable)
    : value_(tape_of(formula, std::span(&variable, 1)), {}), series_(value_.tape(), {}) {}

EnclosedCurve::Value EnclosedCurve::at(double x) {
  const Number place(x);
  value_.run(std::span(&place, 1));
  const Number& value = value_.output(0);
  const double half = (value.upper() - value.lower()) / 2;
  return {value.lower() + half, half};
}

CurveBox EnclosedCurve::box(double left, double right) {
  const Series place = Series::variable(Number(left, right));
  series_.run(std::span(&place, 1));
  const Series& series = series_.output(0);
  const double half = (right - left) / 2;
  double remainder = (series[0].upper() - series[0].lower()) / 2, half_to_n = 1;
  for (int n = 1; n <= order; ++n) {
    half_to_n *= half;
    remainder = std::min(remainder, std::max(-series[n].lower(), series[n].upper()) * half_to_n);
  }
  return {left, right, remainder};
}

CurveBoxes boxes_of(EnclosedCurve& curve, const std::vector<StudyEdge>& edges, double share,
                    double least_range) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  const auto seen = [&](double value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  };
  const auto range = [&] { return std::max(most - least, least_range); };
  constexpr int samples = 32;  // enough for the size of the values
  const double lower = edges.front().at, length = edges.back().at - lower;
  for (int i = 0; i <= samples; ++i) seen(curve.at(lower + length * i / samples).value);

  std::priority_queue open(is_explained_more, std::vector<CurveBox>{});
  std::size_t count = edges.size() - 1;
  for (std::size_t i = 1; i < edges.size(); ++i) open.push(curve.box(edges[i - 1].at, edges[i].at));
  const double narrowest = std::ldexp(length, -60);
  CurveBoxes result;
  while (!open.empty() && count < most_curve_boxes) {
    const CurveBox box = open.top();
    open.pop();
    const double middle = box.middle();
    const EnclosedCurve::Value value = curve.at(middle);
    seen(value.value);
    const bool is_rounding = box.remainder <= 4 * value.rounding && std::isfinite(value.rounding);
    const bool is_whole = box.right - box.left <= narrowest || !(box.left < middle && middle < box.right);
    if (is_rounding || is_whole || box.remainder <= share * range()) {
      result.boxes.push_back(box);
      continue;
    }
    open.push(curve.box(box.left, middle));
    open.push(curve.box(middle, box.right));
    count += 2;
  }
  std::ranges::sort(result.boxes, {}, &CurveBox::left);
  result.range = range();
  if (!open.empty()) result.unresolved = open.top().middle();
  return result;
}

}  // namespace shadefit
