#include "fit/squares/prepared_study.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "fit/panels/features.hpp"
#include "fit/panels/limits.hpp"
#include "fit/squares/equal_candidates.hpp"
#include "fit/squares/settle.hpp"
#include "fit/squares/solve_in_units.hpp"
#include "fit/study/require_values.hpp"
#include "fit/study/search.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// Who knows the cuts of a study knows that it has a value everywhere, and its units.
ReadStudy prepared(const Study& study) {
  ReadStudy read = read_study(study);
  if (study.cuts) return read;
  take_limits(read);
  if (needs_units(read))
    throw UserError("--over '" + read.axes.front().variable +
                    "': its range, the target or a parameter is too far from 1; write them in other units");
  return read;
}

}  // namespace

PreparedStudy::PreparedStudy(const Study& study)
    : study_(prepared(study)),
      unresolved_(study.cuts ? std::nullopt : cut_at_features(study_)),
      error_(study_),
      rules_(study_, error_),
      has_cut_panels_(study.cuts.has_value()) {
  require_values(study_, rules_.nodes(rules_.first()));
  require_dependence(study_, error_.is_open());
}

StudyFit PreparedStudy::fit_from(const std::vector<std::vector<double>>& starts) {
  StudyFit fit;
  fit.names = study_.parameters;
  // Between kinks that move, sums over few nodes have basins of their own.
  const SampledStudy<double>& scan =
      rules_.sampled<double>(rules_.has_moving_kinks() ? rules_.last() : rules_.first());
  const auto ends = search_basins(error_, scan, scan, {.count = 0, .octaves = 0, .given = starts});
  const auto is_other = [&](const StudyCandidate& end) { return !is_same_curve(scan, end, ends.front()); };
  if (ends.empty()) {
    fit.why = "the way down from the start leads to a pole, or the form has no finite value there";
    return fit;
  }
  if (ends.size() < starts.size() || std::ranges::any_of(ends, is_other)) {
    fail(fit, Status::ambiguous, "the starts lead to different curves");
    return fit;
  }
  if (std::string flat = flat_direction(study_, scan, ends.front().parameters); !flat.empty()) {
    fail(fit, Status::degenerate, std::move(flat));
    return fit;
  }
  if (rules_.has_moving_kinks()) {
    fit = settle_kinks(rules_, ends.front());
  } else {
    cut_panels(ends.front().parameters);
    fit = settle(rules_, ends.front(), nullptr);
    const bool is_linear = std::ranges::all_of(error_.is_linear(), std::identity{});
    fit = with_all_digits(study_, rules_, rules_.sampled<double>(rules_.first()), is_linear, std::move(fit));
  }
  if (fit.status == Status::converged && unresolved_)
    fail(fit, Status::unresolved, why_unresolved(study_, *unresolved_));
  fit.names = study_.parameters;
  return fit;
}

/// The panels of one optimum serve the others: where they do not, larger rules do.
void PreparedStudy::cut_panels(const std::vector<double>& parameters) {
  if (!has_cut_panels_) rules_.cut_panels(parameters);
  has_cut_panels_ = true;
}

double PreparedStudy::rms_error(const std::vector<double>& parameters) {
  rules_.move_kinks(parameters);
  cut_panels(parameters);
  return shadefit::rms_error(rules_, parameters);
}

}  // namespace shadefit
