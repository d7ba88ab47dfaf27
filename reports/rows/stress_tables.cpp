#include "reports/rows/stress_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fit/quadrature/metric.hpp"
#include "reports/table/writers.hpp"

namespace shadefit {
namespace {

/// Below this, the error of a naive form depends on rounding in the library.
constexpr double least_told = 16;

/// "2^24": the smallest power of two that is not exceeded.
std::string power_of_two_above(double ulps) {
  int exponent = 0;
  const double mantissa = std::frexp(ulps, &exponent);
  return fmt::format("2^{}", mantissa == 0.5 ? exponent - 1 : exponent);
}

std::string yes_or_no(bool is_so) {
  return is_so ? "yes" : "no";
}

/// In words, see fits_stress_table.
std::string share(const StartsTrial& t) {
  if (t.reached == t.fits) return "all";
  return 10 * t.reached >= 9 * t.fits ? "most" : t.reached > 0 ? "some" : "none";
}

bool is_told(const FormTrial& trial) {
  return !trial.is_robust() && trial.worst_ulps > least_told;
}

/// The order of rows, by unusable results first, then by error.
auto badness(const FormTrial& trial) {
  return std::pair(trial.nan + trial.infinite + trial.negative + trial.above.value_or(0), trial.worst_ulps);
}

}  // namespace

Table forms_stress_table(const std::vector<FormTrial>& trials) {
  Table table{{"topic", "name", "formula", "role", "format", "domain", "inputs", "worst_ulps", "worst_at",
               "bound", "kept", "nan", "infinite", "negative", "above", "first_bad"}};
  for (const FormTrial& t : trials) {
    table.rows.push_back(
        {std::string(t.topic), std::string(t.form), t.formula,
         std::string(t.is_robust() ? "robust" : "naive"), std::string(t.format.name), t.domain, t.inputs,
         is_told(t) ? Cell(power_of_two_above(t.worst_ulps)) : Cell(), is_told(t) ? Cell(t.worst_at) : Cell(),
         t.is_robust() ? Cell(bound_text(*t.bound, t.format)) : Cell(),
         t.is_robust() ? Cell(yes_or_no(t.is_kept())) : Cell(), t.nan, t.infinite, t.negative,
         t.above ? Cell(*t.above) : Cell(), t.first_bad.empty() ? t.first_broken : t.first_bad});
  }
  return table;
}

Table fits_stress_table(const std::vector<StartsTrial>& trials) {
  Table table{{"constant", "exponent", "interval", "status", "starts", "fits", "reached", "right", "digits"}};
  for (const StartsTrial& t : trials) {
    const bool has_answer = t.reached > 0;
    table.rows.push_back({std::string(t.family), t.exponent ? Cell(Number{*t.exponent, 10}) : Cell(),
                          to_text(t.domain), std::string(name(t.status)), t.starts, t.fits, share(t),
                          yes_or_no(t.is_right()), has_answer ? Cell(static_cast<long>(t.digits)) : Cell()});
  }
  return table;
}

Table forms_stress_summary(const std::vector<FormTrial>& trials) {
  Table table{{"topic", "format", "form", "worst ulps", "nan", "inf", "< 0", "> max", "robust form",
               "worst ulps", "bound", "kept"}};
  for (std::size_t i = 0; i < trials.size();) {
    std::size_t end = i;
    while (end < trials.size() && trials[end].topic == trials[i].topic &&
           trials[end].domain == trials[i].domain)
      ++end;
    for (const BinaryFormat& format : stress_formats) {
      const FormTrial* naive = nullptr;
      const FormTrial* robust = nullptr;
      for (std::size_t j = i; j < end; ++j) {
        const FormTrial& t = trials[j];
        if (t.format.name != format.name) continue;
        const FormTrial*& worst = t.is_robust() ? robust : naive;
        if (worst == nullptr || badness(*worst) < badness(t)) worst = &t;
      }
      std::vector<Cell> row{std::string(trials[i].topic), std::string(format.name)};
      if (naive != nullptr)
        row.insert(row.end(),
                   {std::string(naive->form), Number{naive->worst_ulps, 2}, naive->nan, naive->infinite,
                    naive->negative, naive->above ? Cell(*naive->above) : Cell()});
      row.resize(8);  // up to the columns of the robust form
      if (robust != nullptr)
        row.insert(row.end(), {std::string(robust->form), Number{robust->worst_ulps, 2},
                               bound_text(*robust->bound, format), yes_or_no(robust->is_kept())});
      row.resize(table.columns.size());
      table.rows.push_back(row);
    }
    i = end;
  }
  return table;
}

Table fits_stress_summary(const std::vector<StartsTrial>& trials) {
  Table table{{"family", "starts", "fits", "reached", "said they failed", "wrong", "fewest digits"}};
  for (std::size_t i = 0; i < trials.size();) {
    long fits = 0, starts = 0, reached = 0, failed = 0, wrong = 0, digits = 99;
    const auto family = trials[i].family;
    for (; i < trials.size() && trials[i].family == family; ++i) {
      const StartsTrial& t = trials[i];
      fits += t.fits;
      starts += t.starts;
      reached += t.reached;
      failed += t.failed;
      wrong += t.elsewhere + t.returned;
      if (t.reached > 0) digits = std::min<long>(digits, t.digits);
    }
    table.rows.push_back({std::string(family), starts, fits, reached, failed, wrong, digits});
  }
  return table;
}

std::string broken_lines(const std::vector<FormTrial>& trials, const std::vector<StartsTrial>& fits) {
  std::string lines;
  for (const FormTrial& t : trials) {
    if (!t.is_robust() || t.is_kept()) continue;
    if (!t.first_broken.empty())
      lines +=
          fmt::format("shadefit: {} in {} breaks its bound of {} ulps at {}: up to {:.3g} times the bound\n",
                      t.form, t.format.name, bound_text(*t.bound, t.format), t.first_broken, t.worst_share);
    if (!t.first_bad.empty())
      lines += fmt::format(
          "shadefit: {} in {} has no usable value at {}: {} NaN, {} infinite, {} negative, {} above\n",
          t.form, t.format.name, t.first_bad, t.nan, t.infinite, t.negative, t.above.value_or(0));
  }
  for (const StartsTrial& t : fits) {
    if (t.is_right()) continue;
    lines += fmt::format(
        "shadefit: {}{} on {}: {} of {} fits converged elsewhere, {} at themselves; {} digits of {} claimed\n",
        t.family, t.exponent ? fmt::format(" at exponent {}", *t.exponent) : "", to_text(t.domain),
        t.elsewhere, t.fits, t.returned, t.digits, t.claimed);
  }
  return lines;
}

std::vector<File> stress_files(const std::vector<FormTrial>& trials, const std::vector<StartsTrial>& fits) {
  return {{forms_stress_file, write_csv(forms_stress_table(trials), Precision::report)},
          {fits_stress_file, write_csv(fits_stress_table(fits), Precision::report)}};
}

}  // namespace shadefit
