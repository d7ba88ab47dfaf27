#include "fit/stress/regime.hpp"

#include <algorithm>
#include <cmath>

#include "fit/support/hex_float.hpp"

namespace shadefit {
namespace {

/// The value of the exact formula at an input.
struct Exact {
  Decimal50 value;
  double folds = 0;
  bool is_infinite = false;  ///< after rounding to the format
};

/// "c = 0x1p+0, k = 0x0p+0"
std::string text_of(const Input& input, const std::array<std::string_view, 2>& names) {
  std::string text = std::string(names[0]) + " = " + hex_text(input[0]);
  if (!names[1].empty()) text += ", " + std::string(names[1]) + " = " + hex_text(input[1]);
  return text;
}

std::vector<Exact> exact_values(const Regime& regime, const BinaryFormat& format,
                                const std::vector<Input>& inputs, const Checkpoint& checkpoint) {
  std::vector<Exact> values;
  values.reserve(inputs.size());
  for (const Input& input : inputs) {
    // A few milliseconds of arithmetic in 50 digits.
    if (values.size() % 64 == 0) checkpoint();
    Exact exact{regime.truth(Decimal50(input[0]), Decimal50(input[1]))};
    exact.is_infinite = overflows(exact.value, format);
    if (regime.folds != nullptr) {
      // No result is further from 0 or infinity than all e-folds of the format.
      const double all = -std::log(least_subnormal(format)) + std::log(largest(format));
      exact.folds = std::min(std::abs(regime.folds(input[0], input[1])), all);
    }
    values.push_back(exact);
  }
  return values;
}

FormTrial try_form(const Regime& regime, const StressedForm& form, std::size_t format_index,
                   const std::vector<Input>& inputs, const std::vector<Exact>& exact) {
  const BinaryFormat& format = stress_formats[format_index];
  FormTrial trial{regime.topic, form.name,  form.formula,      regime.domain,
                  format,       form.bound, std::ssize(inputs)};
  if (regime.at_most) trial.above = 0;
  std::vector<double> errors;
  errors.reserve(inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const double result = form.evaluate[format_index](inputs[i][0], inputs[i][1]);
    const bool is_nan = std::isnan(result);
    const bool is_infinite = std::isinf(result) && !exact[i].is_infinite;
    const bool is_negative = regime.is_positive && result < 0;
    const bool is_above = regime.at_most && result > *regime.at_most;
    trial.nan += is_nan;
    trial.infinite += is_infinite;
    trial.negative += is_negative;
    if (regime.at_most) *trial.above += is_above;
    if ((is_nan || is_infinite || is_negative || is_above) && trial.first_bad.empty())
      trial.first_bad = text_of(inputs[i], regime.names);
    const double error = ulps_off(result, exact[i].value, format);
    errors.push_back(std::isfinite(error) ? error : 0);
    trial.worst_ulps = std::max(trial.worst_ulps, errors.back());
    if (!form.bound) continue;
    const double share = error / bound_ulps(*form.bound, format, exact[i].folds);
    trial.worst_share = std::max(trial.worst_share, std::isnan(share) ? 0 : share);
    if (share > 1 && trial.first_broken.empty()) trial.first_broken = text_of(inputs[i], regime.names);
  }
  const auto bad = std::ranges::find_if(errors, [&](double e) { return 2 * e > trial.worst_ulps; });
  if (bad != errors.end())
    trial.worst_at = text_of(inputs[static_cast<std::size_t>(bad - errors.begin())], regime.names);
  return trial;
}

}  // namespace

std::vector<FormTrial> try_forms(const Regime& regime, std::size_t random, const Checkpoint& checkpoint) {
  std::vector<FormTrial> trials(regime.forms.size() * stress_formats.size());
  for (std::size_t f = 0; f < stress_formats.size(); ++f) {
    const auto inputs = regime.inputs(stress_formats[f], random);
    const auto exact = exact_values(regime, stress_formats[f], inputs, checkpoint);
    for (std::size_t i = 0; i < regime.forms.size(); ++i)
      trials[i * stress_formats.size() + f] = try_form(regime, regime.forms[i], f, inputs, exact);
  }
  return trials;
}

}  // namespace shadefit
