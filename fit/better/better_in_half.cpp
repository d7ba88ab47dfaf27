#include "fit/better/better_in_half.hpp"

#include "fit/support/user_error.hpp"

namespace shadefit {

std::vector<CurveInHalf> curves_in_half(const Comparison& comparison, const Checkpoint& checkpoint) {
  std::vector<CurveInHalf> curves;
  for (const Contender& contender : comparison.contenders) {
    if (contender.kind != Contender::Kind::published || contender.family.empty()) continue;
    checkpoint();
    CurveInHalf& curve = curves.emplace_back(CurveInHalf{contender.family, contender.published});
    const Fit fit = find_family(contender.family)->fit(comparison.setting, {.domain = comparison.domain});
    if (fit.status != Status::converged) {
      curve.reason = "its fit did not converge";
      continue;
    }
    try {
      curve.rounded = round_fit(fit, {.kind = NumberFormat::Kind::half}, contender.values, checkpoint);
    } catch (const UserError& error) {  // a constant or an exponent beyond half
      curve.reason = error.what();
    }
  }
  return curves;
}

}  // namespace shadefit
