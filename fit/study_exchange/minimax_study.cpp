#include "fit/study_exchange/minimax_study.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fit/minimax/minimax.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/search.hpp"
#include "fit/study_exchange/exchanged_study.hpp"
#include "fit/study_exchange/minimax_rows.hpp"
#include "fit/study_exchange/minimax_surface.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
StudyFit solve_minimax_study(const ReadStudy& study, const Constraints& constraints,
                             const std::vector<Held>& starts, const Checkpoint& checkpoint) {
  require_possible(study, constraints);
  if (study.rows) return solve_minimax_rows(study, starts, checkpoint);
  if (study.axes.size() > 1) return solve_minimax_surface(study, starts, checkpoint);
  const StudyError error(study);
  const SearchedStudy searched = search_study(study, error, {edges_of(study, 0)}, starts, checkpoint);
  checkpoint();
  const auto edges = resolved_edges(study, error, searched.candidates.front().parameters);
  const ExchangedStudy exchanged(study, error, edges, constraints);

  std::optional<MinimaxOptimum> best;
  for (const StudyCandidate& candidate : lowest_basins(searched)) {
    MinimaxParameters start{};
    std::copy(candidate.parameters.begin(), candidate.parameters.end(), start.begin());
    MinimaxOptimum optimum = solve_minimax(exchanged.problem(), start);
    checkpoint();
    const bool is_better = !best || (optimum.status == Status::converged &&
                                     (best->status != Status::converged || optimum.level < best->level));
    if (is_better) best = std::move(optimum);
  }
  StudyFit fit;
  fit.names = study.parameters;
  fit.parameters.assign(best->parameters.begin(),
                        best->parameters.begin() + static_cast<std::ptrdiff_t>(study.parameters.size()));
  fit.status = best->status;
  fit.why = with_variable(best->why, study.axes.front().variable);
  fit.digits = best->digits;
  fit.starts = searched.starts;
  fit.is_global = searched.is_linear;
  fit.level = best->level;
  fit.alternation = best->alternation;
  std::reverse(fit.alternation.begin(), fit.alternation.end());
  if (fit.status == Status::infeasible)
    throw UserError("the form cannot satisfy the constraints: " + fit.why);
  if (fit.status != Status::converged) return fit;
  fit.rms_error = rms_error(study, error, fit.parameters);
  fit.max_abs_error = largest_error(study, {edges}, fit.parameters);
  confirm_integrals(study, fit);
  return fit;
}

}  // namespace shadefit
