#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "fit/formula/tape_program.hpp"
#include "fit/study/study.hpp"
#include "fit/study/study_edges.hpp"

/// The parts of a study's range between its edges, where an exchange searches.
namespace shadefit {

/// The search places of a panel: the 41 extrema of Chebyshev's polynomial of degree 40, ends included. They
/// are enough: the error of a form with four parameters has five to seven extrema.
inline const std::array<double, 41>& chebyshev_places() {
  static const std::array<double, 41> places = [] {
    std::array<double, 41> s{};
    for (std::size_t i = 0; i < s.size(); ++i) {
      const double sine = std::sin(std::numbers::pi * static_cast<double>(i) / 80);
      s[i] = sine * sine;
    }
    return s;
  }();
  return places;
}

/// A part of the range between two edges. At an end where a formula has a root, the variable is the square of
/// s: the error may have an infinite slope there.
template <class T>
struct PanelOf {
  T left, right;
  bool is_rooted_left, is_rooted_right;
  bool is_jump = false;  ///< its ends are the sides of a jump, and nothing is between them

  /// How far s in [0, 1] is from the left end, as a share of the panel.
  T share(T s) const {
    const T rest = 1 - s;
    return is_rooted_left ? s * s : is_rooted_right ? 1 - rest * rest : s;
  }
  /// The variable at s. Computed from the end that has the root, whose distance keeps its digits.
  T at(T s) const {
    const T rest = 1 - s;
    if (is_rooted_left) return left + (right - left) * (s * s);
    if (is_rooted_right) return right - (right - left) * (rest * rest);
    if (is_jump) return s < rest ? left : right;
    return left + (right - left) * s;
  }
  /// The derivative of the variable by s.
  T slope(T s) const {
    const T length = is_jump ? 0 : right - left;
    return is_rooted_left ? 2 * length * s : is_rooted_right ? 2 * length * (1 - s) : length;
  }
  T curvature() const { return T(is_rooted_left ? 2 : is_rooted_right ? -2 : 0) * (right - left); }
};

/// The panels of a range. Those that end at a kink of the form move with it when parameters move it: then an
/// extremum at the kink stays at the end of its panels, and its value has a derivative by the parameters.
class SearchPanels {
 public:
  /// `edges` are those at some parameters.
  SearchPanels(const ReadStudy& study, const std::vector<StudyEdge>& edges,
               const std::vector<double>& parameters);

  std::size_t size() const { return panels_.size(); }
  /// At the parameters of the edges.
  const PanelOf<double>& first(std::size_t panel) const { return panels_[panel]; }

  /// At other parameters. NaN where a kink has left the range or has passed another edge.
  PanelOf<double> at(std::size_t panel, std::span<const double> parameters);
  PanelOf<long double> at(std::size_t panel, std::span<const long double> parameters);

  /// Whether an end of a panel is a kink that parameters move.
  bool has_kink(std::size_t panel) const { return lefts_[panel] || rights_[panel]; }

  /// How fast the place at s on a panel moves with each parameter.
  std::vector<double> speeds(std::size_t panel, double s, std::span<const double> parameters);

 private:
  /// A formula that is 0 at the kink, its slope there, and its derivatives by the parameters.
  struct Kink {
    TapeProgram<double> usual;
    TapeProgram<long double> wide;
  };

  std::optional<std::size_t> kink_at(double x, const std::vector<double>& parameters);
  void add_speeds(std::size_t kink, double x, double share, std::span<const double> parameters,
                  std::vector<double>& result);

  std::vector<PanelOf<double>> panels_;
  std::vector<Kink> kinks_;
  std::vector<std::optional<std::size_t>> lefts_, rights_;  ///< of each panel the kink at its end
};

}  // namespace shadefit
