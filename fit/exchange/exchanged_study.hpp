#pragma once

#include <memory>
#include <vector>

#include "fit/panels/minimax.hpp"
#include "fit/panels/panel_curve.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {

/// A study of one variable as a problem of the exchange: the curves of its error, of its form and of the
/// form's slope, and its constraints. It must not move while its `problem()` is in use.
class ExchangedStudy {
 public:
  /// `edges` are those of the range at these parameters, with cuts where the form needs them
  /// (`resolved_edges`).
  ExchangedStudy(const ReadStudy& study, const StudyError& error, const std::vector<StudyEdge>& edges,
                 const std::vector<double>& parameters, const Constraints& constraints);

  const MinimaxProblem& problem() const { return problem_; }

 private:
  std::shared_ptr<SearchPanels> panels_;
  SampledStudy<double> sampled_;  ///< detects poles
  MinimaxProblem problem_;
};

/// Throws UserError for constraints that a study cannot have: any on measured rows or several variables, and
/// an `exact_at` that is not an end of the range.
void require_possible(const ReadStudy& study, const Constraints& constraints);

}  // namespace shadefit
