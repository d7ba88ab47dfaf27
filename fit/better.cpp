#include "fit/better.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/published_curve.hpp"
#include "fit/symbolic.hpp"

namespace shadefit {
namespace {

Contender contender(const FittableFamily& family, const Subject& subject, std::vector<double> values,
                    double width) {
  const Metric metric{.domain = subject.domain};
  const auto relative = family.max_rel_error(subject.setting, subject.domain, values);
  const double rms = family.objective(subject.setting, metric, values);
  return {.family = &family,
          .published = "",
          .origin = "",
          .parameters = subject.parameters,
          .values = std::move(values),
          .operations = count_operations(family.form()),
          .rms_error = rms,
          .max_rel_error = relative ? relative->magnitude : std::numeric_limits<double>::quiet_NaN(),
          .max_abs_error = certify(subject, width)};
}

/// The printed constants of a family, each set once.
void append_published(std::vector<Contender>& contenders, const FittableFamily& family,
                      const Setting& setting, double width) {
  for (const Published* number : numbers_of(family.info)) {
    if (number->parameter != family.parameters.front()) continue;  // a set is named by its first
    Subject subject{.family = std::string(family.info.id), .parameters = {}, .setting = setting};
    for (const auto& [parameter, printed] : printed_parameters(family, *number))
      subject.parameters.emplace_back(parameter, printed);
    const bool is_known = std::any_of(contenders.begin(), contenders.end(), [&](const Contender& other) {
      return other.family == &family && other.parameters == subject.parameters;
    });
    if (is_known) continue;
    Contender found = contender(family, subject, published_parameters(family, *number), width);
    found.published = number->id;
    found.origin = std::string(number->source.author) + " " + std::to_string(number->source.year);
    contenders.push_back(std::move(found));
  }
}

void append_fit(std::vector<Contender>& contenders, const FittableFamily& family, const Setting& setting,
                const Metric& metric, std::string origin, double width) {
  const Fit fit = family.fit(setting, metric);
  if (fit.status != Status::converged) return;
  Contender found = contender(family, subject_of(fit), fit.parameters, width);
  found.origin = std::move(origin);
  contenders.push_back(std::move(found));
}

void append_fits(std::vector<Contender>& contenders, const FittableFamily& family, const Setting& setting,
                 bool under_every_measure, double width) {
  if (under_every_measure) {
    for (const Measure measure : measures)
      append_fit(contenders, family, setting, {.measure = measure},
                 "least squares, " + std::string(name(measure)), width);
  }
  for (const Error error : {Error::absolute, Error::relative})
    append_fit(contenders, family, setting, {.norm = Norm::minimax, .error = error},
               "minimax, " + std::string(name(error)), width);
}

/// Less error, proven, at no more instructions.
bool is_better(const Contender& contender, const Contender& published) {
  return contender.max_abs_error.certificate.upper < published.max_abs_error.certificate.lower &&
         contender.operations.total() <= published.operations.total();
}

}  // namespace

bool have_same_target(const FittableFamily& a, const FittableFamily& b) {
  return to_text(a.target()) == to_text(b.target());
}

Comparison compare_forms(const FittableFamily& family, const Setting& setting, double width,
                         const Checkpoint& checkpoint) {
  Comparison comparison{setting, {}};
  auto& contenders = comparison.contenders;
  for (const FittableFamily& other : fittable_families()) {
    checkpoint();
    if (have_same_target(family, other)) append_published(contenders, other, setting, width);
  }
  const std::size_t published = contenders.size();
  for (const FittableFamily& other : fittable_families()) {
    checkpoint();
    if (have_same_target(family, other))
      append_fits(contenders, other, setting, other.info.id == family.info.id, width);
  }
  for (std::size_t i = published; i < contenders.size(); ++i) {
    for (std::size_t j = 0; j < published; ++j) {
      if (is_better(contenders[i], contenders[j])) contenders[i].beats.push_back(contenders[j].published);
    }
  }
  return comparison;
}

}  // namespace shadefit
