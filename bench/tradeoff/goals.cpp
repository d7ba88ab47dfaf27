#include "bench/tradeoff/goals.hpp"

#include <fmt/format.h>

#include <functional>

namespace shadefit::bench {
namespace {

using Condition = std::function<bool(const TimedForm&)>;

/// The fastest row in float and in the first cache that satisfies a condition, or null.
const TimedForm* fastest(const Trade& trade, const std::string& target, const Condition& is_wanted) {
  const TimedForm* best = nullptr;
  for (const TimedForm& row : trade.forms) {
    if (row.target != target || row.is_double || row.place != DataPlace::first_cache || !is_wanted(row))
      continue;
    if (best == nullptr || row.ns.median < best->ns.median) best = &row;
  }
  return best;
}

Condition is_form(const std::string& form, int exp2_degree) {
  return [=](const TimedForm& row) { return row.form == form && row.exp2_degree == exp2_degree; };
}

Condition is_scalar(const Condition& also) {
  return [=](const TimedForm& row) { return row.width == forms::Width::scalar && also(row); };
}

Condition is_simd(const Condition& also) {
  return [=](const TimedForm& row) { return row.width != forms::Width::scalar && also(row); };
}

/// The error of a form with an exact exp2, with the published constants if there are any.
std::optional<double> error_with_exact_exp2(const Trade& trade, const std::string& target,
                                            const std::string& form, const std::string& constants) {
  const TimedForm* row = fastest(trade, target, [&](const TimedForm& other) {
    return other.form == form && other.exp2_degree == 0 && other.constants == constants;
  });
  return row != nullptr ? row->max_abs_error : std::nullopt;
}

/// The form with a polynomial for exp2 whose error is at most this.
Condition is_fitted(const std::string& form, const std::optional<double>& error) {
  return [=](const TimedForm& row) {
    return row.form == form && row.exp2_degree > 0 && error && row.max_abs_error &&
           *row.max_abs_error <= *error;
  };
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

std::optional<double> paired(const std::optional<double>& error) {
  return error ? std::optional(pairing * *error) : std::nullopt;
}

}  // namespace

std::vector<Goal> goals_of(const Trade& trade) {
  std::vector<Goal> goals;
  const TimedForm* schlick = fastest(trade, "schlick", is_form("schlick", 0));
  goals.push_back({"Schlick by multiplications, in copies" + by(schlick), 1.4, true,
                   schlick != nullptr ? schlick->copies : std::nullopt});

  const auto lobe_error = error_with_exact_exp2(trade, "lobe", "sg", "published-sg-offset-mean");
  const TimedForm* gaussian = fastest(trade, "lobe", is_fitted("sg", lobe_error));
  const TimedForm* pow = fastest(trade, "lobe", is_scalar(is_form("lobe-pow", 0)));
  const TimedForm* wide_pow = fastest(trade, "lobe", is_simd(is_form("lobe-pow", 0)));
  goals.push_back({"the SG lobe with a fitted exp2, as fast as a scalar loop over std::pow" + by(gaussian),
                   45, false, ratio(pow, gaussian)});
  goals.push_back({"the same, as fast as SIMD pow" + by(wide_pow), 10, false, ratio(wide_pow, gaussian)});

  const std::string pair = "fresnel-quadratic";
  const auto pair_error =
      paired(error_with_exact_exp2(trade, "schlick", pair, "published-fresnel-quadratic-a"));
  const TimedForm* fresnel = fastest(trade, "schlick", is_fitted(pair, pair_error));
  goals.push_back(
      {"the Fresnel pair with a fitted exp2, as fast as a scalar loop over std::exp2" + by(fresnel), 30,
       false, ratio(fastest(trade, "schlick", is_scalar(is_form(pair, 0))), fresnel)});
  goals.push_back({"the same, as fast as SIMD exp2", 2.5, false,
                   ratio(fastest(trade, "schlick", is_simd(is_form(pair, 0))), fresnel)});

  const auto light_error =
      paired(error_with_exact_exp2(trade, "phong-16", "phong-sg", "published-sg-offset-mean"));
  const TimedForm* lights = fastest(trade, "phong-16", is_fitted("phong-sg", light_error));
  goals.push_back({"Phong with 16 lights by DOT4 and EXP2, as fast as its SIMD pow" + by(lights), 8, false,
                   ratio(fastest(trade, "phong-16", is_simd(is_form("phong-pow", 0))), lights)});
  return goals;
}

}  // namespace shadefit::bench
