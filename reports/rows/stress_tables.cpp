#include "reports/rows/stress_tables.hpp"

#include <fmt/format.h>

#include <cmath>

#include "fit/quadrature/metric.hpp"

namespace shadefit {
namespace {

/// "2^24": the smallest power of two that is not exceeded.
std::string power_of_two_above(double ulps) {
  int exponent = 0;
  const double mantissa = std::frexp(ulps, &exponent);
  return fmt::format("2^{}", mantissa == 0.5 ? exponent - 1 : exponent);
}

}  // namespace

Table forms_stress_table(const std::vector<FormTrial>& trials) {
  Table table{{"topic", "name", "formula", "role", "format", "domain", "inputs", "worst_ulps", "worst_at",
               "bound", "kept", "nan", "infinite", "negative", "above", "first_bad"}};
  for (const FormTrial& t : trials) {
    constexpr double least_told = 16;  // below, the error of a naive form depends on rounding in the library
    const bool is_told = !t.bound && t.worst_ulps > least_told;
    table.rows.push_back(
        {std::string(t.topic), std::string(t.form), std::string(t.formula),
         std::string(t.bound ? "robust" : "naive"), std::string(t.format.name), std::string(t.domain),
         t.inputs, is_told ? Cell(power_of_two_above(t.worst_ulps)) : Cell(),
         is_told ? Cell(t.worst_at) : Cell(), t.bound ? Cell(bound_text(*t.bound, t.format)) : Cell(),
         t.bound ? Cell(std::string(t.is_kept() ? "yes" : "no")) : Cell(), t.nan, t.infinite, t.negative,
         t.above, t.first_bad.empty() ? t.first_broken : t.first_bad});
  }
  return table;
}

Table fits_stress_table(const std::vector<Fit>& fits) {
  Table table{{"constant", "exponent", "interval", "status", "digits"}};
  for (const Fit& fit : fits) {
    table.rows.push_back({std::string(fit.family->id),
                          fit.exponent ? Cell(Number{*fit.exponent, 10}) : Cell(), to_text(fit.metric.domain),
                          std::string(name(fit.status)),
                          fit.status == Status::converged ? Cell(static_cast<long>(fit.digits)) : Cell()});
  }
  return table;
}

std::string broken_lines(const std::vector<FormTrial>& trials) {
  std::string lines;
  for (const FormTrial& t : trials) {
    if (!t.bound || t.is_kept()) continue;
    lines += fmt::format("shadefit: {} in {} breaks its bound of {} ulps or has no usable value at {}\n",
                         t.form, t.format.name, bound_text(*t.bound, t.format),
                         t.first_broken.empty() ? t.first_bad : t.first_broken);
  }
  return lines;
}

}  // namespace shadefit
