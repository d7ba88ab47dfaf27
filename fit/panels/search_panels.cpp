#include "fit/panels/search_panels.hpp"

#include <algorithm>

namespace shadefit {
namespace {

std::vector<PanelOf<double>> panels_between(const std::vector<StudyEdge>& edges) {
  std::vector<PanelOf<double>> panels;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const StudyEdge &left = edges[i - 1], &right = edges[i];
    const bool from_left = left.power > 1, from_right = right.power > 1;
    if (left.is_jump) {
      panels.push_back({left.at, right.at, false, false, true});
    } else if (from_left && from_right) {
      const double middle = left.at + (right.at - left.at) / 2;
      panels.push_back({left.at, middle, true, false});
      panels.push_back({middle, right.at, false, true});
    } else {
      panels.push_back({left.at, right.at, from_left, from_right});
    }
  }
  return panels;
}

/// The tape of a kink at a place and parameters. Its outputs: the formula, its slope, and its derivatives by
/// the parameters.
template <class T>
void run_kink(TapeProgram<T>& kink, T x, std::span<const T> parameters) {
  std::vector<T> inputs{x};
  inputs.insert(inputs.end(), parameters.begin(), parameters.end());
  kink.run(inputs);
}

/// Newton's method for the place of a kink. NaN if it does not settle.
template <class T>
T kink_from(TapeProgram<T>& kink, T x, std::span<const T> parameters) {
  constexpr int most = 60;
  for (int i = 0; i < most; ++i) {
    run_kink(kink, x, parameters);
    const T step = kink.output(0) / kink.output(1);
    x -= step;
    if (std::abs(step) <= 4 * std::numeric_limits<T>::epsilon() * std::abs(x)) return x;
  }
  return std::numeric_limits<T>::quiet_NaN();
}

}  // namespace

SearchPanels::SearchPanels(const ReadStudy& study, const std::vector<StudyEdge>& edges,
                           const std::vector<double>& parameters)
    : panels_(panels_between(with_sides(edges))) {
  for (const Symbolic& kink : moving_kinks(study)) {
    const Tape tape = tape_of(kink, formula_inputs(study), 1 + parameters.size());
    kinks_.push_back({TapeProgram<double>(tape, {}), TapeProgram<long double>(tape, {})});
  }
  for (const PanelOf<double>& panel : panels_) {
    lefts_.push_back(kink_at(panel.left, parameters));
    rights_.push_back(kink_at(panel.right, parameters));
  }
}

/// The kink that is at x. An end of the range stays where it is.
std::optional<std::size_t> SearchPanels::kink_at(double x, const std::vector<double>& parameters) {
  constexpr double here = 1e-9;
  if (x == panels_.front().left || x == panels_.back().right) return std::nullopt;
  const double length = panels_.back().right - panels_.front().left;
  for (std::size_t i = 0; i < kinks_.size(); ++i) {
    run_kink(kinks_[i].usual, x, std::span(parameters));
    const double distance = kinks_[i].usual.output(0) / kinks_[i].usual.output(1);
    if (std::abs(distance) <= here * std::min(length, std::abs(x))) return i;
  }
  return std::nullopt;
}

PanelOf<double> SearchPanels::at(std::size_t panel, std::span<const double> parameters) {
  PanelOf<double> moved = panels_[panel];
  if (lefts_[panel]) moved.left = kink_from(kinks_[*lefts_[panel]].usual, moved.left, parameters);
  if (rights_[panel]) moved.right = kink_from(kinks_[*rights_[panel]].usual, moved.right, parameters);
  if (moved.left < moved.right) return moved;
  return {NAN, NAN, moved.is_rooted_left, moved.is_rooted_right};
}

PanelOf<long double> SearchPanels::at(std::size_t panel, std::span<const long double> parameters) {
  const PanelOf<double>& first = panels_[panel];
  PanelOf<long double> moved{first.left, first.right, first.is_rooted_left, first.is_rooted_right,
                             first.is_jump};
  if (lefts_[panel]) moved.left = kink_from(kinks_[*lefts_[panel]].wide, moved.left, parameters);
  if (rights_[panel]) moved.right = kink_from(kinks_[*rights_[panel]].wide, moved.right, parameters);
  return moved;
}

std::vector<double> SearchPanels::speeds(std::size_t panel, double s, std::span<const double> parameters) {
  std::vector<double> result(parameters.size(), 0.0);
  const PanelOf<double> now = at(panel, parameters);
  const double share = now.share(s);
  if (lefts_[panel]) add_speeds(*lefts_[panel], now.left, 1 - share, parameters, result);
  if (rights_[panel]) add_speeds(*rights_[panel], now.right, share, parameters, result);
  return result;
}

/// Adds a share of the speeds of a kink at x, by the rule for implicit functions.
void SearchPanels::add_speeds(std::size_t kink, double x, double share, std::span<const double> parameters,
                              std::vector<double>& result) {
  TapeProgram<double>& program = kinks_[kink].usual;
  run_kink(program, x, parameters);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] -= share * program.output(2 + i) / program.output(1);
}

}  // namespace shadefit
