#include "fit/study_squares/prepared_study.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "fit/study/require_values.hpp"
#include "fit/study/search.hpp"
#include "fit/study_panels/features.hpp"
#include "fit/study_panels/limits.hpp"
#include "fit/study_squares/settle.hpp"
#include "fit/study_squares/solve_in_units.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

ReadStudy with_limits(ReadStudy study) {
  take_limits(study);
  if (needs_units(study))
    throw UserError("--over '" + study.axes.front().variable +
                    "': its range, the target or a parameter is too far from 1; write them in other units");
  return study;
}

}  // namespace

PreparedStudy::PreparedStudy(const Study& study)
    : study_(with_limits(read_study(study))),
      unresolved_(cut_at_features(study_)),
      error_(study_),
      rules_(study_, error_) {
  require_values(study_, rules_.nodes(rules_.first()));
  require_dependence(study_, error_.is_open());
}

StudyFit PreparedStudy::fit(const std::vector<double>& start) {
  StudyFit fit;
  // Between kinks that move, sums over few nodes have basins of their own.
  const SampledStudy<double>& scan =
      rules_.sampled<double>(rules_.has_moving_kinks() ? rules_.last() : rules_.first());
  const auto ends = search_basins(error_, scan, scan, {.count = 0, .octaves = 0, .given = {start}});
  if (ends.empty()) {
    fit.why = "the way down from the start leads to a pole, or the form has no finite value there";
  } else if (rules_.has_moving_kinks()) {
    fit = settle_kinks(rules_, ends.front());
  } else {
    // The panels of one optimum serve the others: where they do not, larger rules do.
    if (!has_cut_panels_) rules_.cut_panels(ends.front().parameters);
    has_cut_panels_ = true;
    fit = settle(rules_, ends.front(), nullptr);
    const bool is_linear = std::ranges::all_of(error_.is_linear(), std::identity{});
    fit = with_all_digits(study_, rules_, rules_.sampled<double>(rules_.first()), is_linear, std::move(fit));
  }
  if (fit.status == Status::converged && unresolved_) {
    fit.status = Status::unresolved;
    fit.why = why_unresolved(study_, *unresolved_);
  }
  fit.names = study_.parameters;
  return fit;
}

}  // namespace shadefit
