#include "fit/verdicts/family_file.hpp"

#include "fit/catalogue/family.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/study/study.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/sweep.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/refit.hpp"

namespace shadefit {
namespace {

/// The curve that a number was published with.
PublishedSet set_of(const Family& family, const Published& number) {
  PublishedSet set{
      .form = family.id,
      .values = *number.curve,
      .source = fmt::format("{} {}, {}", number.source.author, number.source.year, number.source.title)};
  set.is_stated_fit = number.statement == Statement::best_fit;
  if (family.has_exponent()) set.given = {{"k", number.exponents}};
  return set;
}

/// The curves that were published; each is named by its first number.
template <class Rule>
void add_sets(StudyFile& file, const Family& family, const Rule& is_wanted) {
  for (const Published* number : numbers_of(family)) {
    if (number->parameter == family.parameters.front() && is_wanted(*number))
      file.published.push_back(set_of(family, *number));
  }
}

/// The points from which the form is fitted. Those of a lobe are formulas of k.
std::vector<PrintedValues> starts_of(const Family& family, const Surface& surface) {
  std::vector<PrintedValues> starts;
  for (const std::vector<Held>& point : family.starts_of({0, surface})) {
    PrintedValues& start = starts.emplace_back();
    for (const Held& value : point)
      start.emplace_back(value.parameter, family.has_exponent()
                                              ? to_text(family.starts[starts.size() - 1][start.size()])
                                              : to_text(value.value));
  }
  return starts;
}

StudyForm form_of(const Family& family, const Surface& surface) {
  return {.id = family.id,
          .formula = to_text(family.form),
          .error = family.study.residual,
          .near_peak = family.study.near_peak.form,
          .starts = starts_of(family, surface)};
}

void take_exponents(StudyFile& file, const Family& family, const Published* published) {
  std::vector<std::string> exponents;
  for (const double exponent :
       published != nullptr ? exponents_needed_by(*published, family) : parse_sweep(family.sweep))
    exponents.push_back(to_text(exponent));
  file.given = {{"k", exponents}};
}

}  // namespace

StudyFile family_file(const Family& family, const Published* published, const Surface& surface, Error error,
                      const std::string& weight) {
  StudyFile file{.id = family.id, .about = family.variables, .study = family.study, .forms = {}};
  if (family.is_fresnel) {
    file.study = fresnel_study(surface, error);
  } else {
    file.study.given.clear();
    file.study.target = to_text(family.target);
    file.study.error = error;
    take_exponents(file, family, published);
  }
  file.study.over = {{"c", "0", "1"}};
  multiply_weight(file.study, weight);
  if (!weight.empty()) file.study.cuts.reset();  // the weight may ask for others
  file.study.parameters = family.parameters;
  file.forms = {form_of(family, surface)};
  if (published != nullptr && published->statement != Statement::best_fit) {
    file.published = {set_of(family, *published)};
    file.published.front().given.clear();
  } else {
    add_sets(file, family, [](const Published& number) { return number.statement == Statement::best_fit; });
  }
  return file;
}

void take_rivals(StudyFile& file, const Family& family, const Published* published, const Surface& surface) {
  file.study.parameters.clear();
  file.forms.clear();
  file.published.clear();
  // A curve of several numbers has the ids of all.
  const auto is_another = [&](const Published& number) {
    return published == nullptr || number.family != published->family || *number.curve != *published->curve;
  };
  const auto add = [&](const Family& rival) {
    file.forms.push_back(form_of(rival, surface));
    add_sets(file, rival, is_another);
  };
  if (published != nullptr) file.published.push_back(set_of(family, *published));
  add(family);
  for (const Family& other : families())
    if (other.id != family.id && have_same_target(family, other)) add(other);
  if (family.is_fresnel && surface.is_exact()) {
    file.forms.push_back({.id = "schlick", .formula = to_text(family.target)});
    file.published.push_back({.form = "schlick", .values = {}, .source = std::string("Schlick 1994")});
  }
  for (PublishedSet& set : file.published) set.given.clear();
}

bool have_same_target(const Family& a, const Family& b) {
  return to_text(a.target) == to_text(b.target);
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
