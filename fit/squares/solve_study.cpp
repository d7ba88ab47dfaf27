#include "fit/squares/solve_study.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fit/squares/confirm_integrals.hpp"
#include "fit/squares/equal_candidates.hpp"
#include "fit/squares/rules.hpp"
#include "fit/squares/settle.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/require_values.hpp"
#include "fit/study/row_statistics.hpp"
#include "fit/study/search.hpp"
#include "fit/study/study_problem.hpp"

namespace shadefit {
namespace {

/// The lowest basins, settled with the kinks where they are, best first. Those that do not settle come last.
std::vector<StudyCandidate> settled_basins(Rules& rules, const SearchedStudy& searched) {
  // The search sums over nodes that miss the kinks by a part of a panel: that far its squares may be wrong.
  constexpr double near = 1.5;
  std::vector<StudyCandidate> result, others;
  for (const StudyCandidate& basin : lowest_basins(searched)) {
    if (basin.square > near * searched.candidates.front().square) break;
    const StudyFit fit = settle_kinks(rules, basin);
    if (fit.status == Status::converged) {
      result.push_back({fit.parameters, fit.rms_error * fit.rms_error});
    } else {
      others.push_back(basin);
    }
  }
  std::ranges::stable_sort(result, {}, &StudyCandidate::square);
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

/// The chosen candidate at the bottom of its basin, by what its form needs. `flat` says why the place is
/// flat.
StudyFit settled_fit(const ReadStudy& study, Rules& rules, const SearchedStudy& searched,
                     const StudyCandidate& chosen, const std::string& flat) {
  StudyFit fit;
  if (!flat.empty()) {
    fit.parameters = chosen.parameters;
    fail(fit, Status::degenerate, flat);
  } else if (rules.has_moving_kinks()) {
    fit = settle_kinks(rules, chosen);
  }
  // Near a root the first rule is not enough for the kinks; panels that are cut are, and rules tell the
  // digits.
  if (flat.empty() && fit.status != Status::converged) {
    const bool has_same_panels = !rules.cut_panels(chosen.parameters) && !rules.has_moving_kinks();
    fit = settle(rules, chosen, has_same_panels ? &searched.sampled : nullptr);
  }
  return with_all_digits(study, rules, searched.sampled, searched.is_linear, std::move(fit));
}

}  // namespace

StudyFit solve_study(const ReadStudy& study, const std::vector<Held>& starts, const Checkpoint& checkpoint) {
  const StudyError error(study);
  Rules rules(study, error);
  require_finite(study, study.target, "--target", Norm::least_squares, rules.edges());
  SearchedStudy searched = search_study(study, error, rules.edges(), starts, checkpoint);
  const SampledStudy<double>& sampled = searched.sampled;
  checkpoint();
  if (rules.has_moving_kinks()) searched.candidates = settled_basins(rules, searched);

  const auto best = best_of(searched.candidates, sampled.target_norm());
  const StudyCandidate chosen = canonical(study, sampled, best);
  const std::string flat = flat_direction(study, sampled, chosen.parameters);
  StudyFit fit = settled_fit(study, rules, searched, chosen, flat);
  fit.names = study.parameters;
  fit.starts = searched.starts;
  fit.descents = searched.candidates.size();
  fit.lowest = best.size();
  fit.is_global = searched.is_linear;
  if (fit.status == Status::not_converged) require_finite_form(study, Norm::least_squares);
  if (fit.status != Status::converged) return fit;
  for (const StudyCandidate& candidate : best) {
    if (is_same_curve(sampled, candidate, chosen)) continue;
    fail(fit, Status::ambiguous, "another curve is as good");
    fit.other = candidate.parameters;
    return fit;
  }
  if (study.rows) {
    checkpoint();
    fit.max_abs_error = largest_residual(study, fit.parameters);
    if (!study.has_only_starts)
      fit.statistics = row_statistics(study, error, sampled, fit.parameters, checkpoint);
  } else {
    fit.max_abs_error = largest_error(study, rules.edges(), fit.parameters);
    // The square of log(x) has an integral, that of 1/x has none. Rules fit a factor of 1/x that is rounding.
    if (std::isinf(fit.max_abs_error.magnitude) || std::ranges::count(fit.parameters, 0.0) > 0)
      require_finite_form(study, Norm::least_squares);
  }
  confirm_integrals(study, fit);
  return fit;
}

}  // namespace shadefit
