#pragma once

#include <vector>

#include "fit/minimax/minimax_problem.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/study_exchange/panel_curve.hpp"

namespace shadefit {

/// A study of one variable as the exchange takes it: the curves of its error, of its form and of the form's
/// slope, and its constraints. It must not move while its `problem()` is in use.
class ExchangedStudy {
 public:
  /// `edges` are those of the range, with cuts where the form needs them (`resolved_edges`).
  ExchangedStudy(const ReadStudy& study, const StudyError& error, const std::vector<StudyEdge>& edges,
                 const Constraints& constraints);

  const MinimaxProblem& problem() const { return problem_; }

 private:
  std::vector<SearchPanel> panels_;
  SampledStudy<double> sampled_;  ///< tells poles
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
