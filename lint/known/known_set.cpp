#include "lint/known/known_set.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "approx/ledger/catalogue.hpp"
#include "fit/fit.hpp"
#include "fit/support/decimal.hpp"
#include "lint/known/closed_form.hpp"
#include "lint/known/form_numbers.hpp"

namespace shadefit::lint {
namespace {

std::vector<KnownAxis> axes_of(const ReadStudy& study) {
  std::vector<KnownAxis> axes;
  for (const StudyAxis& axis : study.axes) axes.push_back({axis.variable, axis.lower, axis.upper});
  return axes;
}

std::size_t place_of(const std::vector<KnownConstant>& constants, const std::string& name) {
  const auto found = std::find_if(constants.begin(), constants.end(),
                                  [&](const KnownConstant& constant) { return constant.name == name; });
  return static_cast<std::size_t>(found - constants.begin());
}

KnownConstant constant_of(std::string_view name, std::string_view printed) {
  const double value = *parse_number(printed);
  return {std::string(name), std::string(printed), value, is_common_number(value)};
}

KnownSet set_of(const StudyFile& file, const ReadStudy& read, const PublishedSet& published) {
  KnownSet set{file.id, published.form, published.source, axes_of(read), read.form, {}};
  for (const auto& [name, printed] : published.values) set.constants.push_back(constant_of(name, printed));
  name_form_numbers(set);
  for (const MistypedCopy& copy : published.variants)
    for (const auto& [name, printed] : copy.values)
      set.variants.push_back({place_of(set.constants, name), printed, copy.replaced, false});
  return set;
}

void append_sets(const StudyFile& file, std::vector<KnownSet>& sets) {
  const std::vector<Study> studies = combinations(file.study, file.given);
  for (const PublishedSet& published : file.published) {
    // Without the given constants of a set, the study does not have its form.
    const auto given = std::find_if(studies.begin(), studies.end(),
                                    [&](const Study& one) { return is_for(published, one); });
    if (given == studies.end()) continue;
    Study study = *given;
    const auto form = std::find_if(file.forms.begin(), file.forms.end(),
                                   [&](const StudyForm& one) { return one.id == published.form; });
    study.form = form->formula;
    sets.push_back(set_of(file, read_formulas(study), published));
  }
}

/// The exponents for which the effect of a family's constants is computed. A lobe of a smaller exponent is
/// not Gaussian; one of a far larger exponent is a point.
KnownAxis family_exponents() {
  return {"k", 3, 30};
}

/// The published constants of the built-in families, one set for each family and source.
void append_families(std::vector<KnownSet>& sets) {
  std::map<std::tuple<std::string_view, std::string_view, int, std::string_view>, std::size_t> places;
  for (const Published& record : published_constants) {
    const FittableFamily& family = *find_family(record.family);
    // Two records of one parameter are two sets: 0.775 and 0.788.
    const auto same = std::tuple(record.family, record.source.author, record.source.year,
                                 family.parameters.size() == 1 ? record.id : "");
    const auto [place, is_new] = places.emplace(same, sets.size());
    if (is_new) {
      KnownSet set{std::string(record.family),
                   "",
                   std::string(record.source.author),
                   {{"c", 0, 1}},
                   family.form(),
                   {}};
      if (family.has_exponent()) set.axes.push_back(family_exponents());
      sets.push_back(std::move(set));
    }
    KnownSet& set = sets[place->second];
    for (const Variant& variant : record.variants)
      set.variants.push_back({set.constants.size(), std::string(variant.printed), "", false});
    set.constants.push_back(constant_of(record.parameter, record.printed));
  }
}

std::size_t count_places(const Symbolic& formula, const std::string& name) {
  std::size_t count = formula.kind() == Symbolic::Kind::variable && formula.name() == name ? 1 : 0;
  for (const Symbolic& part : formula.parts()) count += count_places(part, name);
  return count;
}

void mark_repeated(std::vector<KnownSet>& sets) {
  for (KnownSet& set : sets)
    for (KnownConstant& constant : set.constants)
      constant.is_repeated = count_places(set.formula, constant.name) > 1;
}

void mark_borrowed(std::vector<KnownSet>& sets) {
  std::set<std::string> published;
  for (const KnownSet& set : sets)
    for (const KnownConstant& constant : set.constants) published.insert(constant.printed);
  for (KnownSet& set : sets)
    for (KnownVariant& variant : set.variants) variant.is_borrowed = published.count(variant.printed) > 0;
}

}  // namespace

std::vector<KnownSet> known_sets(const std::vector<StudyFile>& studies) {
  std::vector<KnownSet> sets;
  append_families(sets);
  for (const StudyFile& study : studies) append_sets(study, sets);
  for (KnownSet& folded : folded_powers_of(sets)) sets.push_back(std::move(folded));
  mark_borrowed(sets);
  mark_repeated(sets);
  return sets;
}

}  // namespace shadefit::lint
