#include "fit/verdicts/study_claims.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include "approx/scalar.hpp"
#include "fit/quadrature/fit_rules.hpp"
#include "fit/squares/rules.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/require_values.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

bool is_relative(StatedError error) {
  return error == StatedError::max_rel_error || error == StatedError::mean_rel_error;
}

Domain ends_of(const StudyRange& range) {
  const ReadStudy read = read_formulas({.target = range.variable, .form = "0", .over = {range}});
  return {read.axes.front().lower, read.axes.front().upper};
}

/// The rows whose variables lie in the ranges of a claim.
std::shared_ptr<const MeasuredRows> rows_within(const ErrorClaim& claim, const Study& study) {
  std::vector<Domain> ends(study.over.size(), Domain{-HUGE_VAL, HUGE_VAL});
  for (const StudyRange& range : claim.over) {
    for (std::size_t i = 0; i < study.over.size(); ++i)
      if (study.over[i].variable == range.variable) ends[i] = ends_of(range);
  }
  const MeasuredRows& all = *study.rows;
  std::vector<std::size_t> within;
  for (std::size_t row = 0; row < all.value.size(); ++row) {
    bool is_within = true;
    for (std::size_t i = 0; i < ends.size(); ++i)
      is_within = is_within && ends[i].lower <= all.places[i][row] && all.places[i][row] <= ends[i].upper;
    if (is_within) within.push_back(row);
  }
  if (within.empty())
    throw UserError("the table '" + all.file.unescaped() + "' has no rows in the range of the claim " +
                    claim.printed);
  return std::make_shared<const MeasuredRows>(some_of(all, within));
}

/// The nodes of a rule. Those of one variable are split where the error changes its sign: there its magnitude
/// has a kink.
StudyNodes nodes_for(const ReadStudy& study, const Symbolic& error) {
  std::vector<std::vector<StudyEdge>> edges = edges_of(study);
  if (edges.size() == 1) edges[0] = with_zeros(study.axes[0], edges[0], {error});
  return nodes_of(study, edges, fit_rules[6]);
}

double mean_error(const ReadStudy& study, const std::vector<double>& parameters) {
  const Symbolic error = at_parameters(study, error_formula(study), parameters);
  const StudyNodes nodes = nodes_for(study, error);
  const std::vector<double> errors = values_at_nodes(study, error, nodes);
  long double sum = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) sum += nodes.weight(i) * std::abs(errors[i]);
  return static_cast<double>(sum);
}

/// The error of a kind. Throws UserError where it does not exist.
double computed_error(StatedError error, const ReadStudy& study, const std::vector<double>& parameters) {
  require_values(study, nodes_of(study, edges_of(study), fit_rules.front()));
  switch (error) {
    case StatedError::max_abs_error:
    case StatedError::max_rel_error:
      return largest_weighted_error(study, parameters).magnitude;
    case StatedError::mean_abs_error:
    case StatedError::mean_rel_error:
      return mean_error(study, parameters);
    case StatedError::rms_error:
      return rms_error(study, StudyError(study), parameters);
    case StatedError::mean_square_error:
      const double rms = rms_error(study, StudyError(study), parameters);
      return rms * rms;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Study study_of(const ErrorClaim& claim, const Study& study) {
  Study asked = study;
  asked.weight = "1";
  asked.error = is_relative(claim.error) ? Error::relative : Error::absolute;
  if (asked.rows) {
    if (!claim.over.empty()) asked.rows = rows_within(claim, study);
    return asked;
  }
  for (const StudyRange& range : claim.over) {
    for (StudyRange& own : asked.over) {
      if (own.variable != range.variable) continue;
      own.lower = range.lower;
      own.upper = range.upper;
    }
  }
  return asked;
}

JudgedError judge_error(const ErrorClaim& claim, const Study& study, const std::vector<double>& parameters) {
  const Study asked = study_of(claim, study);
  JudgedError judged{claim, std::numeric_limits<double>::quiet_NaN(), Verdict::refuted};
  try {
    judged.computed = computed_error(claim.error, read_study(asked), parameters);
  } catch (const UserError&) {
    return judged;
  }
  judged.verdict = judged.computed <= constant<double>(claim.printed)
                       ? Verdict::confirmed
                       : judge(claim.printed, {"", judged.computed}, {}).verdict;
  return judged;
}

}  // namespace shadefit
