#include "fit/rounding/round_family.hpp"

#include <algorithm>
#include <cmath>

#include "fit/bounds/family_subject.hpp"
#include "fit/scalars/narrow_result.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The exponent is a constant of the form and must be a number of the format.
template <class Format>
void require_exponent(double exponent, const NumberFormat& format) {
  const double rounded = static_cast<double>(NarrowResult<Format>::rounded(exponent));
  if (rounded == exponent) return;
  throw UserError("exponent " + to_text(exponent) + " is not a number of " + to_text(format) +
                  (std::isfinite(rounded) ? ": the nearest is " + to_text(rounded)
                                          : ": the largest is " + to_text(largest_of<Format>)));
}

void require_exponent(const Fit& fit, const NumberFormat& format) {
  if (!fit.exponent) return;
  if (format.kind == NumberFormat::Kind::half) require_exponent<HalfFormat>(*fit.exponent, format);
  if (format.kind == NumberFormat::Kind::bfloat16) require_exponent<Bfloat16Format>(*fit.exponent, format);
  if (format.kind == NumberFormat::Kind::single) require_exponent<FloatFormat>(*fit.exponent, format);
}

/// Refuses a weight: the search of a family has none.
void require_no_weight(const Metric& metric, const NumberFormat& format) {
  if (!metric.weight.empty())
    throw UserError("--round '" + to_text(format) +
                    "' does not apply with --weight: the largest error is searched without one");
}

}  // namespace

RoundedStudy round_fit(const Fit& fit, const NumberFormat& format, const std::vector<double>& published,
                       const Checkpoint& checkpoint) {
  require_exponent(fit, format);
  require_no_weight(fit.metric, format);
  const Family& family = *fit.family;
  StudyObjective objective{
      .study = plain_study_of(family, setting_of(fit), fit.metric.error, fit.metric.domain),
      .norm = Norm::minimax,
      .constraints = fit.metric.constraints};
  objective.study.held = objective.constraints.held;
  objective.constraints.held.clear();
  const auto is_held = [&](std::string_view name) {
    return std::ranges::any_of(objective.study.held, [&](const Held& h) { return h.parameter == name; });
  };
  StudyFit free;
  free.status = Status::converged;
  std::vector<double> free_published;
  for (std::size_t i = 0; i < family.parameters.size(); ++i) {
    if (is_held(family.parameters[i])) continue;
    free.names.emplace_back(family.parameters[i]);
    free.parameters.push_back(fit.parameters[i]);
    if (!published.empty()) free_published.push_back(published[i]);
  }
  RoundedStudy rounded = round_study(objective, free, format, free_published, checkpoint);
  const auto complete = [&](RoundedStudySet& set) {
    // With a surface the codes are those of its reflectance, which the study does not compute.
    if (fit.surface.is_named()) set.srgb_codes.reset();
    for (std::size_t i = 0; i < family.parameters.size(); ++i) {
      if (!is_held(family.parameters[i])) continue;
      set.values.insert(set.values.begin() + static_cast<std::ptrdiff_t>(i), fit.parameters[i]);
      set.texts.insert(set.texts.begin() + static_cast<std::ptrdiff_t>(i), to_text(fit.parameters[i]));
    }
  };
  complete(rounded.best);
  complete(rounded.naive);
  if (rounded.published) complete(*rounded.published);
  return rounded;
}

}  // namespace shadefit
