#include "app/studies/family_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fit/catalogue/catalogue_study.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/study/study.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/sweep.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/refit.hpp"

namespace shadefit {
namespace {

/// The curve that a number was published with.
PublishedSet set_of(const Family& family, const Published& number) {
  PublishedSet set{
      .form = family.id,
      .values = {},
      .source = fmt::format("{} {}, {}", number.source.author, number.source.year, number.source.title)};
  set.is_stated_fit = number.statement == Statement::best_fit;
  if (family.has_exponent()) set.given = {{"k", std::string(number.exponents)}};
  for (const auto& [parameter, printed] : printed_parameters(family, number))
    set.values.emplace_back(parameter, printed);
  return set;
}

/// The sets that are the best of their form; a set is named by its first number.
std::vector<PublishedSet> best_sets(const Family& family) {
  std::vector<PublishedSet> sets;
  for (const Published* number : numbers_of(family)) {
    if (number->parameter == family.parameters.front() && number->statement == Statement::best_fit)
      sets.push_back(set_of(family, *number));
  }
  return sets;
}

/// The points from which the form is fitted. Those of a lobe are formulas of k.
std::vector<PrintedValues> starts_of(const Family& family, const Surface& surface) {
  std::vector<PrintedValues> starts;
  const auto add = [&](const auto& points) {
    for (const auto& point : points) {
      PrintedValues& start = starts.emplace_back();
      for (std::size_t i = 0; i < point.size(); ++i)
        start.emplace_back(family.parameters[i], to_text(point[i]));
    }
  };
  if (family.has_exponent()) {
    add(family.starts);
  } else {
    add(family.starts_of({0, surface}));
  }
  return starts;
}

void take_exponents(StudyFile& file, const NamedFit& named) {
  std::vector<std::string> exponents;
  const Family& family = *named.family;
  const std::vector<double> usual =
      named.published != nullptr ? exponents_needed_by(*named.published, family) : parse_sweep(family.sweep);
  for (const double exponent : usual) exponents.push_back(to_text(exponent));
  file.given = {{"k", exponents}};
}

}  // namespace

StudyFile family_file(const NamedFit& named, const FitOptions& options) {
  const Family& family = *named.family;
  const Surface surface = surface_for(family, options);
  StudyFile file{.id = family.id, .about = family.variables, .study = family.study, .forms = {}};
  if (family.is_fresnel) {
    file.study = fresnel_study_to_fit(surface, options.metric.error);
  } else {
    file.study.given.clear();
    file.study.target = to_text(family.target);
    file.study.error = options.metric.error;
    take_exponents(file, named);
  }
  file.study.over = {{"c", "0", "1"}};
  multiply_weight(file.study, options.metric.weight);
  if (!options.metric.weight.empty()) file.study.cuts.reset();  // the weight may ask for others
  file.study.parameters = family.parameters;
  file.forms = {{.id = family.id,
                 .formula = to_text(family.form),
                 .error = family.study.residual,
                 .near_peak = family.study.near_peak.form,
                 .starts = starts_of(family, surface)}};
  file.published = best_sets(family);
  if (named.published != nullptr && named.published->statement != Statement::best_fit) {
    file.published = {set_of(family, *named.published)};
    file.published.front().given.clear();
  }
  return file;
}

void narrow_to_visible(StudyFile& file) {
  StudyRange& range = file.study.over.front();
  const double upper = number_in(file.study, {"--over", range.variable}, range.upper);
  for (const std::string& exponent : file.given.front().second) {
    const auto visible_end = where_lobe_is_visible(number_in(file.study, {"--exponent"}, exponent));
    if (!visible_end || visible_end->cos_theta >= upper)
      throw UserError(fmt::format(
          "--error 'relative' has no meaning for {} at exponent {} on {}:{}: its target is below 1/255, or "
          "that is below any double",
          file.id, exponent, range.lower, range.upper));
  }
  const std::string end = "exp(-log(255)/k)";
  range.lower = range.lower == "0" ? end : fmt::format("max({}, {})", range.lower, end);
}

}  // namespace shadefit
