#include "lint/scan/known_set.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <tuple>

#include "fit/catalogue/family.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit::lint {
namespace {

bool is_simple_fraction(double value, double slack) {
  constexpr int largest_denominator = 16, largest_numerator = 64;
  for (int denominator = 1; denominator <= largest_denominator; ++denominator) {
    const double numerator = value * denominator, whole = std::round(numerator);
    if (whole > largest_numerator) return false;
    if (whole >= 1 && std::abs(numerator - whole) <= slack * whole) return true;
  }
  return false;
}

KnownConstant constant_of(std::string_view name, std::string_view printed) {
  const double value = *parse_number(printed);
  return {std::string(name), std::string(printed), value, is_common_number(value)};
}

/// Where the parts begin that are searched. The condition of a choice is left out: a program that has its
/// variable in other units, such as kelvin, has other numbers there and the same constants.
std::size_t first_searched(const Symbolic& formula) {
  return formula.kind() == Symbolic::Kind::choice ? 2 : 0;
}

/// The names and numbers of a formula, in the order of its text.
void append_leaves(const Symbolic& formula, std::vector<Symbolic>& leaves) {
  if (formula.parts().empty()) leaves.push_back(formula);
  for (std::size_t i = first_searched(formula); i < formula.parts().size(); ++i)
    append_leaves(formula.part(i), leaves);
}

/// Whether a number has at least three digits and is no simple fraction.
bool is_telling(const Symbolic& leaf) {
  constexpr int few_digits = 2;
  if (leaf.kind() != Symbolic::Kind::number) return false;
  const double value = constant<double>(leaf.name());
  return parse_number(decimal(value, few_digits)) != value && !is_common_number(value);
}

/// The formula with a variable in place of each telling number; its name is the number.
Symbolic with_names(const Symbolic& formula) {
  if (is_telling(formula)) return Symbolic::variable(formula.name());
  if (formula.parts().empty()) return formula;
  std::vector<Symbolic> parts = formula.parts();
  for (std::size_t i = first_searched(formula); i < parts.size(); ++i) parts[i] = with_names(parts[i]);
  return formula.with_parts(std::move(parts));
}

/// Makes constants of the numbers that stand in the text of a form: 0.1003 in (0.1003 + b x)/(1 + m x). Each
/// comes before the constant that follows it in the form. Numbers of one or two digits and simple fractions
/// stay in the form: a program may write them in another way. So do those of a condition.
void name_form_numbers(KnownSet& set) {
  std::vector<Symbolic> leaves;
  append_leaves(set.formula, leaves);
  auto next = set.constants.end();
  for (auto leaf = leaves.rbegin(); leaf != leaves.rend(); ++leaf) {
    const auto known = std::ranges::find(set.constants, leaf->name(), &KnownConstant::name);
    if (known != set.constants.end()) {
      next = known;
    } else if (is_telling(*leaf)) {
      next = set.constants.insert(next,
                                  {leaf->name(), leaf->name(), constant<double>(leaf->name()), false, true});
    }
  }
  set.formula = with_names(set.formula);
}

KnownSet set_of(const StudyFile& file, const ReadStudy& read, const PublishedSet& published) {
  KnownSet set{file.id, published.form, published.source.unescaped(), {}, read.form, {}};
  set.is_encoded = file.is_encoded;
  for (const StudyAxis& axis : read.axes) set.axes.push_back({axis.variable, axis.lower, axis.upper});
  for (const auto& [name, printed] : published.values) set.constants.push_back(constant_of(name, printed));
  name_form_numbers(set);
  for (const MistypedCopy& copy : published.variants)
    for (const auto& [name, printed] : copy.values) {
      const auto constant = std::ranges::find(set.constants, name, &KnownConstant::name);
      const auto place = static_cast<std::size_t>(constant - set.constants.begin());
      set.variants.push_back({place, printed, copy.replaced.unescaped(), false});
    }
  return set;
}

/// The formula with the published numbers for its constants.
Symbolic with_published(const KnownSet& set, const Symbolic& formula) {
  return evaluate<Symbolic>(formula, [&](const std::string& name) {
    const auto known = std::ranges::find(set.constants, name, &KnownConstant::name);
    return known == set.constants.end() ? Symbolic::variable(name) : Symbolic::number(known->printed);
  });
}

/// Adds the formulas of `KnownSet::mixed` to the sets of one study.
void append_mixed(std::span<KnownSet> sets) {
  for (KnownSet& set : sets)
    for (const KnownSet& other : sets) {
      if (&set == &other || set.formula.kind() != Symbolic::Kind::choice ||
          other.formula.kind() != Symbolic::Kind::choice)
        continue;
      for (const std::size_t branch : {std::size_t{2}, std::size_t{3}}) {
        std::vector<Symbolic> parts = set.formula.parts();
        parts[branch] = with_published(other, other.formula.part(branch));
        set.mixed.push_back(set.formula.with_parts(std::move(parts)));
      }
    }
}

void append_sets(const StudyFile& file, std::vector<KnownSet>& sets) {
  const std::size_t first = sets.size();
  const std::vector<Study> studies = combinations(file.study, file.given);
  for (const PublishedSet& published : file.published) {
    // Without the given constants of a set, the study does not have its form.
    const auto given =
        std::ranges::find_if(studies, [&](const Study& one) { return is_for(published, one); });
    if (given == studies.end()) continue;
    Study study = *given;
    study.form = std::ranges::find(file.forms, published.form, &StudyForm::id)->formula;
    sets.push_back(set_of(file, read_formulas(study), published));
  }
  append_mixed(std::span(sets).subspan(first));
}

/// The published constants of the built-in families, one set for each family and source.
void append_families(std::vector<KnownSet>& sets) {
  std::map<std::tuple<std::string_view, std::string_view, int, std::string_view>, std::size_t> places;
  for (const Published& record : published_constants()) {
    const Family& family = *find_family(record.family);
    // Two records of one parameter are two sets: 0.775 and 0.788.
    const std::string_view number = family.parameters.size() == 1 ? std::string_view(record.id) : "";
    const auto [place, is_new] = places.emplace(
        std::tuple(std::string_view(record.family), record.source.author, record.source.year, number),
        sets.size());
    if (is_new) {
      KnownSet set{record.family, "", std::string(record.source.author), {}, family.form, {}};
      set.axes = {{"c", 0, 1}};
      // A lobe of a smaller exponent is not Gaussian; one of a far larger exponent is a point.
      if (family.has_exponent()) set.axes.push_back({"k", 3, 30});
      sets.push_back(std::move(set));
    }
    KnownSet& set = sets[place->second];
    for (const Variant& variant : record.variants)
      set.variants.push_back({set.constants.size(), variant.printed, "", false});
    set.constants.push_back(constant_of(record.parameter, record.printed));
  }
}

/// Adds, for the numbers in the text of a form, what other sources have for them: another form may have the
/// number as a constant. 0.2343580 is in planck-y, because its x is that of planck-x, and 0.2343589 is there
/// too.
void append_other_sources(KnownSet& set, const std::vector<KnownSet>& sets) {
  constexpr double near = 1e-3;  // a number for another given constant differs by more
  const auto differ = [](const KnownConstant& a, const KnownConstant& b) {
    return std::abs(std::abs(a.value) - std::abs(b.value)) / std::abs(a.value);
  };
  for (std::size_t c = 0; c < set.constants.size(); ++c) {
    if (!set.constants[c].is_of_form) continue;
    for (const KnownSet& source : sets)
      for (std::size_t i = 0; i < source.constants.size(); ++i) {
        if (differ(set.constants[c], source.constants[i]) > 0) continue;
        for (const KnownSet& other : sets)
          if (other.id == source.id && other.form == source.form &&
              differ(set.constants[c], other.constants[i]) > 0 &&
              differ(set.constants[c], other.constants[i]) < near)
            set.variants.push_back({c, other.constants[i].printed, "", true, true});
      }
  }
}

/// Marks the variants whose digits another set publishes.
void mark_known(std::vector<KnownSet>& sets) {
  std::set<std::string> published;
  for (const KnownSet& set : sets)
    for (const KnownConstant& constant : set.constants) published.insert(constant.printed);
  for (KnownSet& set : sets)
    for (KnownVariant& variant : set.variants) variant.is_borrowed = published.contains(variant.printed);
}

}  // namespace

bool is_common_number(double value) {
  namespace numbers = std::numbers;
  if (value == 0) return true;
  // Half a unit of the seventh digit, relative to the number.
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 6);
  const double slack = 0.5 * unit / std::abs(value);
  for (const double factor :
       {1.0, numbers::pi, numbers::inv_pi, numbers::sqrt2, numbers::ln2, 1 / numbers::ln2})
    if (is_simple_fraction(std::abs(value) / factor, slack)) return true;
  return false;
}

std::vector<KnownSet> known_sets(const std::vector<StudyFile>& studies) {
  std::vector<KnownSet> sets;
  append_families(sets);
  for (const StudyFile& study : studies) append_sets(study, sets);
  for (KnownSet& set : sets) append_other_sources(set, sets);
  mark_known(sets);
  return sets;
}

}  // namespace shadefit::lint
