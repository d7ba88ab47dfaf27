#include "fit/better/fit_extras.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The first published value of each parameter; empty if one has none.
std::vector<double> published_values(const FitReport& report) {
  std::vector<double> values;
  for (const std::string_view parameter : find_family(report.fit.family->id)->parameters) {
    const auto found = std::ranges::find_if(
        report.assessments, [&](const Assessment& a) { return a.published->parameter == parameter; });
    if (found == report.assessments.end()) return {};
    values.push_back(constant<double>(found->published->printed));
  }
  return values;
}

RoundedFit round_one(const FitReport& report, const NumberFormat& format, const Checkpoint& checkpoint) {
  if (report.fit.status != Status::converged) return {.reason = "the fit did not converge"};
  RoundedFit fit{.rounded = round_fit(report.fit, format, published_values(report), checkpoint)};
  if (!std::isfinite(fit.rounded->best.max_error))
    throw CheckFailed(std::string(report.fit.family->id) + " rounded to " + to_text(format) +
                      ": no finite bound of its error was proven");
  return fit;
}

}  // namespace

std::vector<RoundedFit> round_fits(const Refit& refit, const NumberFormat& format, bool is_record,
                                   const Checkpoint& next, const Checkpoint& checkpoint) {
  std::vector<RoundedFit> fits;
  for (const FitReport& report : refit.fits) {
    next();
    try {
      fits.push_back(round_one(report, format, checkpoint));
    } catch (const UserError& error) {
      if (!is_record || refit.fits.size() == 1) throw;
      fits.push_back({.reason = error.what()});
    }
  }
  return fits;
}

}  // namespace shadefit
