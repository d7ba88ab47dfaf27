#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "fit/formula/tape_program.hpp"
#include "fit/panels/minimax.hpp"
#include "fit/panels/search_panels.hpp"
#include "fit/study/study.hpp"

/// Formulas of a study along its variable, as curves of the exchange.
namespace shadefit {

enum class CurveOf { formula, slope };

namespace detail {

/// The graph nodes of a curve.
struct CurveNodes {
  CurveNodes(const ReadStudy& study, const Symbolic& formula, CurveOf of)
      : graph(formula_inputs(study)), inputs(graph.input_nodes()) {
    value = graph.add(formula);
    if (of == CurveOf::slope) value = graph.derivative(value, 0);
    slope = graph.derivative(value, 0);
  }

  /// A node and its derivatives by the parameters.
  std::vector<int> with_gradient(int node) {
    std::vector<int> result{node};
    for (std::size_t i = 1; i < inputs.size(); ++i) result.push_back(graph.derivative(node, i));
    return result;
  }

  template <class T>
  TapeProgram<T> program(const std::vector<int>& outputs) const {
    return TapeProgram<T>(Tape(graph, outputs, inputs), {});
  }

  Graph graph;
  std::vector<int> inputs;
  int value, slope;
};

/// A formula and its slope on a panel. Each may be followed by its derivatives by the parameters.
template <class T>
class CurveTapes {
 public:
  /// `size` is that of the terms whose difference the formula is, if it is known.
  CurveTapes(TapeProgram<T> value, TapeProgram<T> slope, std::size_t outputs, std::size_t parameters, T size)
      : value_(std::move(value)),
        slope_(std::move(slope)),
        outputs_(outputs),
        inputs_(1 + parameters),
        rounding_(64 * std::numeric_limits<T>::epsilon() * size) {}

  /// The outputs at s. At an end where one has no value, such as 0/0 at a zero of the target, its limit along
  /// the panel; NaN if the extrapolation does not settle.
  std::vector<T> at(const PanelOf<T>& panel, double s, const std::vector<T>& parameters) {
    std::vector<T> result = run(value_, panel, s, parameters);
    const auto has_none = [](T value) { return std::isnan(value); };
    if ((s != 0 && s != 1) || std::none_of(result.begin(), result.end(), has_none)) return result;
    std::vector<std::vector<T>> beside;
    for (const double distance : distances())
      beside.push_back(run(value_, panel, s == 0 ? distance : 1 - distance, parameters));
    const std::vector<T> limit = extrapolated(beside);
    for (std::size_t i = 0; i < result.size(); ++i) {
      // Of the last two orders; the better one is closer by another factor of 1000.
      constexpr T same = T(1e-10);
      const T before = beside[beside.size() - 2][i];
      const bool is_settled =
          std::abs(limit[i] - before) <= rounding_ + same * (std::abs(limit[i]) + std::abs(beside[0][i]));
      if (has_none(result[i]) && is_settled) result[i] = limit[i];
    }
    return result;
  }

  /// The slope by s of the first output at an end where it has no value, to a few digits.
  T limit_slope(const PanelOf<T>& panel, double s, const std::vector<T>& parameters) {
    const T end = at(panel, s, parameters)[0];
    const double distance = distances().back();
    const T beside = run(value_, panel, s == 0 ? distance : 1 - distance, parameters)[0];
    return (beside - end) / T(s == 0 ? distance : -distance);
  }

  /// The slopes of the outputs by the distance from an end, s = 0 or 1. At an end with a root the formula has
  /// no derivative, though it is smooth in s: there difference quotients are extrapolated to the distance 0,
  /// and what is left is rounding.
  std::vector<T> inward(const PanelOf<T>& panel, double s, const std::vector<T>& parameters) {
    const bool is_left = s == 0;
    if (!(is_left ? panel.is_rooted_left : panel.is_rooted_right)) {
      const T direction = is_left ? panel.slope(0) : -panel.slope(1);
      return combined(run(slope_, panel, s, parameters), direction, std::vector<T>(outputs_), T(0));
    }
    const std::vector<T> end = at(panel, s, parameters);
    std::vector<std::vector<T>> quotients;
    for (const double distance : distances()) {
      const T per_distance = 1 / T(distance);
      const auto beside = at(panel, is_left ? distance : 1 - distance, parameters);
      quotients.push_back(combined(beside, per_distance, end, -per_distance));
    }
    return extrapolated(quotients);
  }

 private:
  /// The distances of an extrapolation from an end of a panel: from 1/16 down in seven halvings.
  static constexpr int count = 8;
  static std::array<double, count> distances() {
    std::array<double, count> result{};
    for (int i = 0; i < count; ++i) result[static_cast<std::size_t>(i)] = std::ldexp(1.0, -4 - i);
    return result;
  }

  /// What is at the distance 0 of values at these distances (Neville's scheme). The value before the last
  /// becomes that of one order less.
  static std::vector<T> extrapolated(std::vector<std::vector<T>>& values) {
    for (int order = 1; order < count; ++order) {
      const T ratio = T(1 << order);
      for (std::size_t i = count - 1; i >= static_cast<std::size_t>(order); --i)
        values[i] = combined(values[i], ratio / (ratio - 1), values[i - 1], -1 / (ratio - 1));
    }
    return values.back();
  }

  std::vector<T> run(TapeProgram<T>& program, const PanelOf<T>& panel, double s,
                     const std::vector<T>& parameters) {
    inputs_[0] = panel.at(T(s));
    std::ranges::copy(parameters, inputs_.begin() + 1);
    program.run(inputs_);
    std::vector<T> result(outputs_);
    for (std::size_t i = 0; i < outputs_; ++i) result[i] = program.output(i);
    return result;
  }

  /// a * u + b * v.
  static std::vector<T> combined(const std::vector<T>& u, T a, const std::vector<T>& v, T b) {
    std::vector<T> result(u.size());
    for (std::size_t i = 0; i < u.size(); ++i) result[i] = a * u[i] + b * v[i];
    return result;
  }

  TapeProgram<T> value_, slope_;
  std::size_t outputs_;
  std::vector<T> inputs_;
  T rounding_;  ///< of an extrapolated value: it is larger than that of each of its values
};

}  // namespace detail

/// A formula of the variable and the parameters, or its slope along the variable, over panels: all
/// evaluations that the exchange needs. Panels that end at a kink move with it, and the derivatives by the
/// parameters are those at a place that moves with its panel. One thread uses the curve and its panels at a
/// time.
class PanelCurve {
 public:
  PanelCurve(const ReadStudy& study, const Symbolic& formula, CurveOf of,
             std::shared_ptr<SearchPanels> panels)
      // A relative error is form/target - 1.
      : PanelCurve(detail::CurveNodes(study, formula, of), std::move(panels),
                   study.error == Error::relative ? 1 : 0) {}

  double value(const SearchPlace& place, const MinimaxParameters& p) {
    value_.run(inputs_at(place, p));
    const double value = value_.output(0);
    return std::isnan(value) ? across_.at(panel_at(place, p), place.s, p)[0] : value;
  }
  Along along(const SearchPlace& place, const MinimaxParameters& p) {
    const PanelOf<double> panel = panel_at(place, p);
    const bool has_kink = panels_->has_kink(place.panel);
    curvature_.run(inputs_at(has_kink ? off_kink(place) : place, p));
    const double slope = panel.slope(place.s), by_x = curvature_.output(1);
    const bool is_end = place.s == 0 || place.s == 1;
    if (is_end && std::isnan(curvature_.output(0))) {
      const double towards = across_.limit_slope(panel, place.s, p);
      return {value(place, p), towards, 0};
    }
    const double value_here = has_kink ? value(place, p) : curvature_.output(0);
    return {value_here, by_x * slope, curvature_.output(2) * slope * slope + by_x * panel.curvature()};
  }
  /// The value, and its derivatives by the parameters; if `is_tangent` those of the slope into the domain, at
  /// s = 0 or 1.
  double across(const SearchPlace& place, const MinimaxParameters& p, bool is_tangent, Unknowns& gradient) {
    if (is_tangent) return split(across_.inward(panel_at(place, p), place.s, p), gradient);
    const double value = split(across_.at(panel_at(place, p), place.s, p), gradient);
    if (panels_->has_kink(place.panel)) move_with_panel(place, p, gradient);
    return value;
  }
  long double wide(const SearchPlace& place, const WideParameters& p, bool is_tangent = false) {
    const PanelOf<long double> panel = panel_at(place, p);
    return (is_tangent ? wide_.inward(panel, place.s, p) : wide_.at(panel, place.s, p))[0];
  }

 private:
  PanelCurve(detail::CurveNodes nodes, std::shared_ptr<SearchPanels> panels, double size)
      : panels_(std::move(panels)),
        count_(nodes.inputs.size() - 1),
        curvature_(nodes.program<double>({nodes.value, nodes.slope, nodes.graph.derivative(nodes.slope, 0)})),
        value_(nodes.program<double>({nodes.value})),
        across_(nodes.program<double>(nodes.with_gradient(nodes.value)),
                nodes.program<double>(nodes.with_gradient(nodes.slope)), 1 + count_, count_, size),
        wide_(nodes.program<long double>({nodes.value}), nodes.program<long double>({nodes.slope}), 1, count_,
              static_cast<long double>(size)),
        inputs_(1 + count_) {}

  template <class T>
  PanelOf<T> panel_at(const SearchPlace& place, const std::vector<T>& p) {
    return panels_->at(place.panel, std::span(p));
  }
  /// A place beside a kink at the end of a panel, on the panel's side of it. At the kink itself rounding
  /// chooses the side whose slope a formula has.
  static SearchPlace off_kink(const SearchPlace& place) {
    constexpr double beside = 1e-9;
    return {place.panel, std::clamp(place.s, beside, 1 - beside)};
  }
  /// The place moves with its panel, and the value changes by its slope there. At a kink the slopes of either
  /// side give the same.
  void move_with_panel(const SearchPlace& place, const MinimaxParameters& p, Unknowns& gradient) {
    const std::vector<double> speeds = panels_->speeds(place.panel, place.s, p);
    curvature_.run(inputs_at(place, p));
    for (std::size_t i = 0; i < count_; ++i) gradient[i] += curvature_.output(1) * speeds[i];
  }
  const std::vector<double>& inputs_at(const SearchPlace& place, const MinimaxParameters& p) {
    inputs_[0] = panel_at(place, p).at(place.s);
    std::ranges::copy(p, inputs_.begin() + 1);
    return inputs_;
  }
  double split(const std::vector<double>& outputs, Unknowns& gradient) const {
    for (std::size_t i = 0; i < count_; ++i) gradient[i] = outputs[1 + i];
    return outputs[0];
  }

  std::shared_ptr<SearchPanels> panels_;
  std::size_t count_;
  TapeProgram<double> curvature_, value_;
  detail::CurveTapes<double> across_;
  detail::CurveTapes<long double> wide_;
  std::vector<double> inputs_;
};

}  // namespace shadefit
