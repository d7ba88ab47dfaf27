#pragma once

#include <vector>

#include "fit/minimax/minimax_problem.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/tape/tape.hpp"

namespace shadefit {

/// A part of the range between two edges, from left to right. The variable runs as a square from an end where
/// a formula has a root: there its error may have an infinite slope.
struct SearchPanel {
  double left, right;
  bool is_rooted_left, is_rooted_right;

  template <class T>
  T at(const T& s) const {
    const T low = lift<T>(left), high = lift<T>(right), length = high - low;
    const T rest = integer<T>(1) - s;
    if (is_rooted_left) return low + length * (s * s);
    if (is_rooted_right) return high - length * (rest * rest);
    return low + length * s;
  }
};

/// A formula of the variable and the parameters, or its slope along the variable.
class StudyFormula {
 public:
  enum class Of { value, slope };

  StudyFormula(const ReadStudy& study, const Symbolic& formula, Of of);

  template <class T, class P>
  P operator()(const SearchPanel& panel, const T& s, const std::array<P, most_parameters>& p) const {
    std::vector<P> inputs{lift<P>(panel.at(s))};
    inputs.insert(inputs.end(), p.begin(), p.begin() + static_cast<std::ptrdiff_t>(count_));
    return tape_(std::span<const P>(inputs))[output_];
  }

 private:
  std::size_t count_;
  std::size_t output_;  ///< of the tape: the formula, then its slope if that is asked for
  Tape tape_;
};

/// A study of one variable as the exchange takes it: the curves of its error, of its form and of the form's
/// slope, and its constraints. It must not move while its `problem()` is in use.
class ExchangedStudy {
 public:
  /// `edges` are those of the range, with cuts where the form needs them (`resolved_edges`).
  ExchangedStudy(const ReadStudy& study, const StudyError& error, const std::vector<StudyEdge>& edges,
                 const Constraints& constraints);

  const MinimaxProblem& problem() const { return problem_; }

 private:
  MinimaxCurve curve_of(const StudyFormula& formula) const;

  std::vector<SearchPanel> panels_;
  StudyFormula error_, form_, slope_;
  SampledStudy<double> sampled_;  ///< tells poles
  std::vector<SearchPlace> places_;
  MinimaxProblem problem_;
};

/// Throws UserError for constraints that do not go with a study: measured rows, several variables, and a
/// place of `exact_at` that is not an end of the range.
void require_possible(const ReadStudy& study, const Constraints& constraints);

/// Whether there is a constraint other than held parameters.
bool has_constraints(const Constraints& constraints);

/// A text of the exchange, which speaks of c, with the variable of a study.
std::string with_variable(std::string text, const std::string& variable);

}  // namespace shadefit
