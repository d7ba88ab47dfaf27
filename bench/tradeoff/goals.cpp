#include <fmt/format.h>

#include "bench/tradeoff/trade.hpp"

namespace shadefit::bench {
namespace {

/// The fastest row in float and in the first cache that satisfies a condition, or null.
const TimedForm* fastest(const Trade& trade, const std::string& target, const auto& is_wanted) {
  const TimedForm* best = nullptr;
  for (const TimedForm& row : trade.forms) {
    if (row.target != target || row.is_double || row.place != DataPlace::first_cache || !is_wanted(row))
      continue;
    if (best == nullptr || row.ns.median < best->ns.median) best = &row;
  }
  return best;
}

/// The code of a form by the library's functions.
enum class Code { scalar, simd, any };

const TimedForm* by_library(const Trade& trade, const std::string& target, const std::string& form,
                            Code code) {
  return fastest(trade, target, [&](const TimedForm& row) {
    const bool is_scalar = row.width == forms::Width::scalar;
    return row.form == form && row.exp2_degree == 0 &&
           (code == Code::any || is_scalar == (code == Code::scalar));
  });
}

/// A form with a polynomial for exp2 whose error is at most this factor times that with an exact exp2 and
/// these constants.
const TimedForm* fitted(const Trade& trade, const std::string& target, const std::string& form,
                        const std::string& constants, double factor) {
  const TimedForm* exact = fastest(trade, target, [&](const TimedForm& row) {
    return row.form == form && row.exp2_degree == 0 && row.constants == constants;
  });
  if (exact == nullptr || !exact->max_abs_error) return nullptr;
  return fastest(trade, target, [&](const TimedForm& row) {
    return row.form == form && row.exp2_degree > 0 && row.max_abs_error &&
           *row.max_abs_error <= factor * *exact->max_abs_error;
  });
}

std::optional<double> ratio(const TimedForm* slow, const TimedForm* fast) {
  if (slow == nullptr || fast == nullptr) return std::nullopt;
  return slow->ns.median / fast->ns.median;
}

/// ", by `sg, one, exp2 of degree 3`".
std::string by(const TimedForm* row) {
  return row == nullptr ? "" : fmt::format(", by `{}` in {}", row->label, forms::name(row->width));
}

/// A form whose exp2 may add a hundredth to its own error.
constexpr double pairing = 1.01;

}  // namespace

std::vector<Goal> goals_of(const Trade& trade) {
  const TimedForm* schlick = by_library(trade, "schlick", "schlick", Code::any);
  const TimedForm* gaussian = fitted(trade, "lobe", "sg", "published-sg-offset-mean", 1);
  const TimedForm* pow = by_library(trade, "lobe", "lobe-pow", Code::scalar);
  const TimedForm* wide_pow = by_library(trade, "lobe", "lobe-pow", Code::simd);
  const std::string pair = "fresnel-quadratic";
  const TimedForm* fresnel = fitted(trade, "schlick", pair, "published-fresnel-quadratic-a", pairing);
  const TimedForm* lights = fitted(trade, "phong-16", "phong-sg", "published-sg-offset-mean", pairing);
  return {{"Schlick by multiplications, in copies" + by(schlick), 1.4, true,
           schlick != nullptr ? schlick->copies : std::nullopt},
          {"the SG lobe with a fitted exp2, as fast as a scalar loop over std::pow" + by(gaussian), 45, false,
           ratio(pow, gaussian)},
          {"the same, as fast as SIMD pow" + by(wide_pow), 10, false, ratio(wide_pow, gaussian)},
          {"the Fresnel pair with a fitted exp2, as fast as a scalar loop over std::exp2" + by(fresnel), 30,
           false, ratio(by_library(trade, "schlick", pair, Code::scalar), fresnel)},
          {"the same, as fast as SIMD exp2", 2.5, false,
           ratio(by_library(trade, "schlick", pair, Code::simd), fresnel)},
          {"Phong with 16 lights by DOT4 and EXP2, as fast as its SIMD pow" + by(lights), 8, false,
           ratio(by_library(trade, "phong-16", "phong-pow", Code::simd), lights)}};
}

}  // namespace shadefit::bench
