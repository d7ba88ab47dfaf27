#include "fit/catalogue/read_families.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "fit/catalogue/read_study_file.hpp"
#include "fit/formula/parse_formula.hpp"
#include "studies/catalogue_files.hpp"

namespace shadefit {
namespace {

const MoreKeys keys_of_families{
    .of_file = {"error_of"},
    .of_target = {"near_peak"},
    .of_form = {"near_peak", "title", "variables", "is_comparison", "starts", "starts_inside"},
    .of_published = {"id", "statement", "sweep", "convention"}};

Statement statement_of(const TomlReader& reader, const toml::table& table) {
  constexpr std::array<std::string_view, 4> words{"best", "mean", "limit", "somewhere"};
  const std::string word = reader.optional(table, "statement", "best");
  const auto found = std::ranges::find(words, word);
  if (found == words.end()) reader.fail(table, "'" + word + "' is unknown here");
  return static_cast<Statement>(found - words.begin());
}

/// Points of the search: a formula for each parameter.
std::vector<std::vector<Symbolic>> starts_of(const TomlReader& reader, const toml::table& form,
                                             const std::string& key) {
  constexpr std::array<std::string_view, 2> variables{"k", "h"};
  std::vector<std::vector<Symbolic>> starts;
  for (const toml::node* point : reader.list(form, key)) {
    std::vector<Symbolic>& start = starts.emplace_back();
    for (const toml::node& node : *point->as_array())
      start.push_back(parse_formula(reader.text(node, key), variables));
  }
  return starts;
}

Family family_of(const TomlReader& reader, const toml::table& whole, const toml::table& form,
                 const StudyFile& file, const StudyForm& read) {
  const toml::table& target = *whole["target"].as_table();
  Study study = file.study;
  if (!file.given.empty()) study.given = {{"k", file.given.front().second.front()}};
  take_form(study, read);
  study.near_peak = {reader.optional(target, "near_peak"), reader.optional(form, "near_peak")};
  const ReadStudy formulas = read_formulas(study);
  const auto of_exponent = [](const std::string& formula) {
    return read_formula(formula, {.variables = {"c", "k"}, .takes_parameters = true, .takes_integrals = true})
        .formula;
  };
  return {.id = read.id,
          .title = reader.required(form, "title"),
          .variables = reader.required(form, "variables"),
          .sweep = file.given.empty() ? "" : reader.required(*whole["given"].as_table(), "k"),
          .is_fresnel = whole.contains("error_of"),
          .is_comparison = reader.flag(form, "is_comparison"),
          .parameters = formulas.parameters,
          .target = of_exponent(study.target),
          .form = of_exponent(study.form),
          .study = study,
          .starts = starts_of(reader, form, "starts"),
          .starts_inside = starts_of(reader, form, "starts_inside")};
}

Source source_of(const CitedWork& work) {
  return {work.authors.front().unescaped(), std::atoi(work.year.unescaped().c_str()), work.title.unescaped(),
          work.howpublished.unescaped(), work.url};
}

Convention convention_of(const TomlReader& reader, const toml::table& table) {
  reader.require_keys(table, {"name", "formula", "value"});
  const std::optional<double> value = value_of_numbers(reader.required(table, "value"));
  if (!value) reader.fail(table, "the value of a convention is a formula of numbers");
  return {reader.required(table, "name"), reader.required(table, "formula"), value};
}

/// Appends a record for each number of a published set.
void append_numbers(const TomlReader& reader, const toml::table& table, const PublishedSet& set,
                    std::vector<Published>& into) {
  const std::string id = reader.required(table, "id");
  for (const auto& [parameter, printed] : set.values) {
    Published number{
        .id = set.values.size() == 1 ? id : id + "-" + parameter,
        .family = set.form,
        .parameter = parameter,
        .printed = printed,
        .statement = statement_of(reader, table),
        .exponents = set.given.empty() ? reader.optional(table, "sweep") : set.given.front().second,
        .source = source_of(set.cite.value()),
        .curve = &set.values};
    for (const MistypedCopy& copy : set.variants) {
      for (const auto& [name, mistyped] : copy.values)
        if (name == parameter) number.variants.push_back({mistyped, copy.seen.unescaped()});
    }
    if (const toml::node* convention = table.get("convention"))
      number.convention = convention_of(reader, reader.table(*convention, "convention"));
    into.push_back(std::move(number));
  }
}

const Catalogue& catalogue() {
  static const Catalogue read = [] {
    Catalogue all;
    for (const EmbeddedFile& file : catalogue_files)
      read_families(std::string(file.text), std::string(file.name), all);
    return all;
  }();
  return read;
}

}  // namespace

void read_families(const std::string& text, const std::string& name, Catalogue& into) {
  const TomlReader reader("catalogue '" + name + "'");
  const toml::table whole = parse_in_lines(reader, text);
  const StudyFile& file = into.files.emplace_back(study_of_toml(reader, whole, keys_of_families));
  const auto forms = reader.list(whole, "form"), sets = reader.list(whole, "published");
  for (std::size_t i = 0; i < forms.size(); ++i) {
    Family family = family_of(reader, whole, *forms[i]->as_table(), file, file.forms[i]);
    const auto end = std::ranges::find_if(into.families, &Family::is_comparison);
    into.families.insert(family.is_comparison ? into.families.end() : end, std::move(family));
  }
  for (std::size_t i = 0; i < sets.size(); ++i)
    append_numbers(reader, *sets[i]->as_table(), file.published[i], into.published);
}

std::span<const Family> families() {
  return catalogue().families;
}

std::span<const Published> published_constants() {
  return catalogue().published;
}

const Published* find_published(std::string_view id) {
  const auto all = published_constants();
  const auto found = std::ranges::find(all, id, &Published::id);
  return found == all.end() ? nullptr : &*found;
}

std::size_t parameter_index(const Family& family, std::string_view name) {
  const auto found = std::ranges::find(family.parameters, name);
  if (found == family.parameters.end())
    throw std::logic_error("a record names a parameter that its family lacks");
  return static_cast<std::size_t>(found - family.parameters.begin());
}

const Family* find_family(std::string_view id) {
  const auto all = families();
  const auto found = std::ranges::find(all, id, &Family::id);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace shadefit
