#include "fit/stress/forms.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"

namespace shadefit {
namespace {

/// "c = 0x1p+0, k = 0x0p+0"
std::string text_of(const Input& input, const std::array<std::string_view, 2>& names) {
  std::string text = std::string(names[0]) + " = " + hex_text(input[0]);
  if (!names[1].empty()) text += ", " + std::string(names[1]) + " = " + hex_text(input[1]);
  return text;
}

FormTrial try_form(const Regime& regime, const StressedForm& form, std::size_t format_index,
                   const std::vector<Input>& inputs) {
  const BinaryFormat& format = stress_formats[format_index];
  FormTrial trial{regime.topic, form.name,  form.formula,      regime.domain,
                  format,       form.bound, std::ssize(inputs)};
  // No result is further from 0 than all e-folds of the format.
  const double most_folds = -std::log(least_subnormal(format)) + std::log(largest(format));
  std::vector<double> errors;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto [a, b] = inputs[i];
    const double result = form.evaluate[format_index](a, b);
    trial.nan += std::isnan(result);
    trial.infinite += std::isinf(result);
    trial.negative += result < 0;
    trial.above += result > 1;
    if (!(result >= 0 && result <= 1) && trial.first_bad.empty())
      trial.first_bad = text_of(inputs[i], regime.names);
    const double error = ulps_off(result, regime.truth(Decimal50(a), Decimal50(b)), format);
    errors.push_back(std::isfinite(error) ? error : 0);
    trial.worst_ulps = std::max(trial.worst_ulps, errors.back());
    const double folds = regime.folds == nullptr ? 0 : std::min(std::abs(regime.folds(a, b)), most_folds);
    const bool is_broken = form.bound && error > bound_ulps(*form.bound, format, folds);
    if (is_broken && trial.first_broken.empty()) trial.first_broken = text_of(inputs[i], regime.names);
  }
  const auto bad = std::ranges::find_if(errors, [&](double e) { return 2 * e > trial.worst_ulps; });
  if (bad != errors.end())
    trial.worst_at = text_of(inputs[static_cast<std::size_t>(bad - errors.begin())], regime.names);
  return trial;
}

/// The roundings of a function: one in half, two in float and double.
double of_function(const BinaryFormat& format) {
  return format.digits == half_format.digits ? 1 : 2;
}

}  // namespace

double Roundings::fixed(const BinaryFormat& format) const {
  return operations + functions * of_function(format);
}

double Roundings::per_fold(const BinaryFormat& format) const {
  return operations_per_fold + functions_per_fold * of_function(format);
}

std::string bound_text(const Roundings& roundings, const BinaryFormat& format) {
  const double per_fold = roundings.per_fold(format);
  const std::string fixed = to_text(roundings.fixed(format));
  return per_fold == 0 ? fixed : fixed + " + " + to_text(per_fold) + " L";
}

double bound_ulps(const Roundings& roundings, const BinaryFormat& format, double folds) {
  const double u = std::ldexp(1.0, -format.digits);
  return std::expm1((roundings.fixed(format) + roundings.per_fold(format) * folds) * u) / u;
}

std::vector<FormTrial> try_forms(const Regime& regime, std::size_t random) {
  std::vector<FormTrial> trials;
  for (const StressedForm& form : regime.forms) {
    for (std::size_t f = 0; f < stress_formats.size(); ++f)
      trials.push_back(try_form(regime, form, f, regime.inputs(stress_formats[f], random)));
  }
  return trials;
}

std::vector<FormTrial> forms_under_stress(const Checkpoint& checkpoint) {
  constexpr std::size_t random = 1500;
  std::vector<FormTrial> trials;
  for (const Regime& regime : stress_regimes()) {
    checkpoint();
    std::ranges::move(try_forms(regime, random), std::back_inserter(trials));
  }
  return trials;
}

}  // namespace shadefit
