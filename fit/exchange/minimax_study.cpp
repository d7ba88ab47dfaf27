#include "fit/exchange/minimax_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fit/exchange/beyond_infinity.hpp"
#include "fit/exchange/constrained_study.hpp"
#include "fit/exchange/exchanged_study.hpp"
#include "fit/exchange/linear_fit.hpp"
#include "fit/exchange/minimax_surface.hpp"
#include "fit/panels/minimax.hpp"
#include "fit/squares/confirm_integrals.hpp"
#include "fit/squares/minimax_rows.hpp"
#include "fit/squares/rules.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/require_values.hpp"
#include "fit/study/search.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The end of an exchange, and the least of the largest errors that were seen on its way.
struct ExchangeEnd {
  StudyFit optimum;
  std::vector<StudyEdge> edges;
  double lowest;
};

/// The largest error at some parameters; infinite where it has no finite value.
double level_at(const ReadStudy& study, const std::vector<double>& parameters) {
  const double level = largest_weighted_error(study, parameters).magnitude;
  return std::isfinite(level) ? level : HUGE_VAL;
}

/// The exchange from one start. Its range is split at the kinks of the form. If parameters move them, it
/// begins again where it ended, until they stay or the level no longer falls.
ExchangeEnd exchanged_from(const ReadStudy& study, const StudyError& error, const Constraints& constraints,
                           const std::vector<StudyEdge>& first_edges, const ExchangedStudy& first_exchanged,
                           const std::vector<double>& start) {
  const bool has_moving_kinks = !moving_kinks(study).empty();
  const int most_passes = has_moving_kinks ? 20 : 1;
  constexpr double same = 1e-13;
  ExchangeEnd end{{}, first_edges, HUGE_VAL};
  std::vector<double> from = start;
  double distance = HUGE_VAL, reached = HUGE_VAL;
  for (int pass = 0; pass < most_passes && distance > same; ++pass) {
    if (has_moving_kinks) {
      end.edges = resolved_edges(study, error, from);
      const ExchangedStudy exchanged(study, error, end.edges, from, constraints);
      end.optimum = solve_minimax(exchanged.problem(), from);
    } else {
      end.optimum = solve_minimax(first_exchanged.problem(), from);
    }
    if (end.optimum.status != Status::converged) {
      // Far from where its kinks were the exchange sees them only roughly.
      const double level = has_moving_kinks ? level_at(study, end.optimum.parameters) : HUGE_VAL;
      if (!(level < reached)) break;
      reached = level;
    }
    distance = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
      distance = std::max(distance, std::abs(from[i] - end.optimum.parameters[i]) / std::abs(from[i]));
    from = end.optimum.parameters;
  }
  if (end.optimum.status == Status::converged && !has_moving_kinks) {
    end.lowest = *end.optimum.level;
    return end;
  }
  from = end.optimum.parameters;
  end.lowest = std::min(level_at(study, start), level_at(study, from));
  constexpr double equal = 1e-9;
  const bool is_lost =
      end.optimum.status == Status::converged && level_at(study, from) > *end.optimum.level * (1 + equal);
  if (is_lost || (has_moving_kinks && end.optimum.status == Status::converged && distance > same)) {
    fail(end.optimum, Status::not_converged,
         "the largest error is at a kink that the parameters move: the exchange does not settle there");
  }
  return end;
}

/// How far roundings of the parameters, of the form and of the target move the error at a place.
double rounding_at(const StudyError& error, const std::vector<double>& parameters,
                   const std::vector<double>& place) {
  const SampledStudy<double> sampled(error, {{{place.front()}}, {1}});
  VectorOf<double> errors;
  MatrixOf<double> slopes;
  sampled.errors(parameters, errors, &slopes);
  double rounding = 8 * sampled.target_norm();
  for (std::size_t i = 0; i < parameters.size(); ++i)
    rounding += std::abs(parameters[i] * slopes(0, static_cast<Eigen::Index>(i)));
  return rounding * std::numeric_limits<double>::epsilon();
}

/// The place of the largest error, if it is above the level: the exchange has not seen it.
std::optional<double> missed_place(const ReadStudy& study, const StudyError& error, double level,
                                   const std::vector<double>& parameters) {
  const StudyExtremum largest = largest_weighted_error(study, parameters);
  constexpr double same_level = 1e-6;
  const double most = level * (1 + same_level) + rounding_at(error, parameters, largest.at);
  return largest.magnitude > most ? std::optional(largest.at.front()) : std::nullopt;
}

/// Goes on from an end with panels that meet where its error is largest, until it has seen that place.
void go_on_where_missed(const ReadStudy& study, const StudyError& error, const Constraints& constraints,
                        ExchangeEnd& end) {
  constexpr int most_rounds = 4;
  for (int round = 0; round < most_rounds && end.optimum.status == Status::converged; ++round) {
    const std::vector<double> parameters = end.optimum.parameters;
    const auto missed = missed_place(study, error, *end.optimum.level, parameters);
    const auto next =
        missed ? std::ranges::lower_bound(end.edges, *missed, {}, &StudyEdge::at) : end.edges.end();
    if (next == end.edges.end() || next->at == *missed) return;
    end.edges.insert(next, {*missed});
    const ExchangedStudy exchanged(study, error, end.edges, parameters, constraints);
    end.optimum = solve_minimax(exchanged.problem(), parameters);
  }
}

/// Whether the first end is the better answer. A level that is higher than one that was seen is no answer,
/// though the exchange settled there. Under constraints the lower one may violate them.
bool is_better(const ExchangeEnd& a, const ExchangeEnd& b, bool is_constrained) {
  const bool has_a = a.optimum.status == Status::converged, has_b = b.optimum.status == Status::converged;
  if (is_constrained) return has_a && (!has_b || a.optimum.level < b.optimum.level);
  constexpr double equal = 1e-9;
  if (has_a != has_b) return has_a ? a.lowest <= b.lowest * (1 + equal) : a.lowest * (1 + equal) < b.lowest;
  return a.lowest < b.lowest;
}

/// Parameters on the other side of infinity, if the exchange from a start ran there.
std::optional<std::vector<double>> other_side(const ReadStudy& study, const ExchangedStudy& exchanged,
                                              const std::vector<double>& start, const ExchangeEnd& end) {
  if (end.optimum.status == Status::converged) return std::nullopt;
  return beyond_infinity(start, end.optimum.parameters, [&](const std::vector<double>& parameters) {
    return exchanged.problem().is_admissible(parameters) ? level_at(study, parameters) : HUGE_VAL;
  });
}

}  // namespace

StudyFit solve_minimax_study(const ReadStudy& study, const Constraints& constraints,
                             const std::vector<Held>& starts, const Checkpoint& checkpoint) {
  require_possible(study, constraints);
  const std::vector<std::vector<StudyEdge>> fixed = edges_of(study);
  require_finite(study, study.target, "--target", Norm::minimax, fixed);
  if (study.rows) return solve_minimax_rows(study, starts, checkpoint);
  if (study.axes.size() > 1) return solve_minimax_surface(study, starts, checkpoint);
  const StudyError error(study);
  const SearchedStudy searched = search_study(study, error, fixed, starts, checkpoint);
  checkpoint();
  const std::vector<double>& first = searched.candidates.front().parameters;
  const auto edges = resolved_edges(study, error, first);
  const ExchangedStudy exchanged(study, error, edges, first, constraints);

  constexpr std::size_t most_basins = 8;  // as many as a search has: the lowest level may be in any
  std::optional<ExchangeEnd> found;
  for (const StudyCandidate& candidate : lowest_basins(searched, most_basins)) {
    const auto from = [&](const std::vector<double>& start) {
      ExchangeEnd end = exchanged_from(study, error, constraints, edges, exchanged, start);
      checkpoint();
      if (!found || is_better(end, *found, has_constraints(constraints))) found = end;
      return end;
    };
    const ExchangeEnd end = from(candidate.parameters);
    if (const auto start = other_side(study, exchanged, candidate.parameters, end)) from(*start);
  }
  if (moving_kinks(study).empty()) go_on_where_missed(study, error, constraints, *found);
  StudyFit fit = found->optimum;
  fit.names = study.parameters;
  fit.starts = searched.starts;
  fit.is_global = searched.is_linear;
  std::reverse(fit.alternation.begin(), fit.alternation.end());
  if (fit.status == Status::infeasible || fit.status == Status::not_finite ||
      (fit.status != Status::converged && searched.is_linear))
    require_finite_form(study, Norm::minimax);
  // The exchange counts small slopes as rounding, whatever the units of the study.
  const Edges all_edges{edges};
  const LinearProblem linear_problem{
      study, error, Norm::minimax, constraints, all_edges, searched.sampled, first, checkpoint};
  const bool is_answer =
      fit.status == Status::converged && (!searched.is_linear || !has_constraints(constraints) ||
                                          keeps_constraints(linear_problem, fit.parameters));
  if (searched.is_linear && !is_answer) {
    StudyFit linear = solve_linear_fit(linear_problem);
    linear.names = fit.names;
    linear.starts = fit.starts;
    linear.is_global = true;
    fit = std::move(linear);
  }
  if (fit.status == Status::infeasible) throw Infeasible(fit.why);
  if (fit.status != Status::converged) return fit;
  fit.rms_error = rms_error(study, error, fit.parameters);
  fit.max_abs_error = largest_error(study, {found->edges}, fit.parameters);
  if (missed_place(study, error, *fit.level, fit.parameters))
    fail(fit, Status::not_converged, "the largest error is above the level of the alternation");
  confirm_integrals(study, fit);
  return fit;
}

}  // namespace shadefit
