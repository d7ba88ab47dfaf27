#include "app/studies/chosen_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/options/fit_arguments.hpp"
#include "app/studies/find_study.hpp"
#include "fit/better/results.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/formula/formula_text.hpp"
#include "fit/input/bounded_file.hpp"
#include "fit/input/known.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/family_file.hpp"

namespace shadefit {
namespace {

/// The options that a built-in family does not take: its target and its form are given.
void refuse_formulas(const FitOptions& options) {
  const StudyOptions& study = options.study;
  if (study.form)
    throw UserError(fmt::format("'{}' does not go with --form: leave the family out", options.id));
  if (!study.target.empty() && !options.target)
    throw UserError(
        fmt::format("--target '{}' is unknown: it must be one of schlick, exact; a formula needs a --form",
                    study.target));
  if (study.word) throw UserError(fmt::format("'{}' has one form: leave '{}' out", options.id, *study.word));
  for (const char* option : {"--table", "--value", "--let", "--params"}) {
    if (options.present.contains(option))
      throw UserError(fmt::format("{} belongs to --form, a formula of your own, or to a study", option));
  }
}

/// Options of the surface of a Fresnel form.
void refuse_surface(const FitOptions& options, const std::string& with) {
  const char* option = options.ior ? "--ior" : options.extinction ? "--extinction" : options.f0 ? "--f0" : "";
  if (*option != '\0')
    throw UserError(fmt::format(
        "{} does not go with {}: write the reflectance of the surface as the --target", option, with));
}

/// --exponent, --domain and --measure are other words for --given and --over.
void change_range(StudyFile& file, const FitOptions& options) {
  const bool has_domain = options.present.contains("--domain") || options.study.has_domain,
             has_measure = options.present.contains("--measure");
  if (!has_domain && !has_measure) return;
  if (file.study.over.size() != 1)
    throw UserError(
        fmt::format("{} is for one variable: say it by --over", has_domain ? "--domain" : "--measure"));
  StudyRange& range = file.study.over.front();
  if (has_domain) {
    range.lower = to_text(options.metric.domain.lower);
    range.upper = to_text(options.metric.domain.upper);
  }
  if (has_measure) range.density = density_of(std::string(name(options.metric.measure)), range.variable);
}

/// The constants of --given, and the exponents.
std::vector<std::pair<std::string, std::vector<std::string>>> given_of(const FitOptions& options) {
  auto given = options.study.given;
  if (!options.exponents) return given;
  std::vector<std::string>& values = given.emplace_back("k", std::vector<std::string>{}).second;
  for (const double exponent : *options.exponents) values.push_back(to_text(exponent));
  return given;
}

/// The values of the options instead of those of the file.
void change_given(StudyFile& file, const FitOptions& options) {
  for (const auto& [constant, values] : given_of(options)) {
    const auto same = [&, &name = constant](const auto& given) { return given.first == name; };
    const auto found = std::ranges::find_if(file.given, same);
    if (found == file.given.end()) {
      file.given.emplace_back(constant, values);
    } else if (options.study.form && file.id.empty()) {
      throw UserError(fmt::format("--given '{}' is given a second time", constant));
    } else {
      found->second = values;
    }
  }
}

void require_use(const StudyFile& file, const FitOptions& options) {
  std::string all = file.study.target + " " + file.study.weight;
  for (const StudyForm& form : file.forms) all += " " + form.formula;
  for (const StudyDefinition& definition : file.study.definitions) all += " " + definition.formula;
  for (const StudyRange& range : file.study.over)
    all += " " + range.lower + " " + range.upper + " " + range.density;
  const std::vector<std::string> names = names_in(all);
  for (const auto& [constant, values] : given_of(options)) {
    if (std::ranges::find(names, constant) != names.end()) continue;
    const bool is_exponent = constant == "k" && options.exponents;
    throw UserError(fmt::format("{}: no formula of the study has this name",
                                is_exponent ? "--exponent k" : fmt::format("--given '{}'", constant)));
  }
}

/// Whether a text beside a study can only be meant as the id of a form: a formula has a variable or an
/// operator.
bool names_a_form(const std::string& text, const Study& study) {
  const auto is_letter = [](char c) { return begins_name(c) || is_digit(c) || c == '-'; };
  if (text.empty() || !begins_name(text.front()) || !std::ranges::all_of(text, is_letter)) return false;
  return std::ranges::none_of(names_in(text), [&](const std::string& name) {
    return std::ranges::find(study.over, name, &StudyRange::variable) != study.over.end();
  });
}

/// --form, or a word beside the study, names a form of it. --form may be a formula of its own instead.
void change_form(StudyFile& file, const StudyOptions& own) {
  const std::string& form = own.word ? *own.word : *own.form;
  if (own.word && own.form)
    throw UserError(fmt::format("'{}' does not go with --form: both name a form", form));
  const auto found = std::ranges::find(file.forms, form, &StudyForm::id);
  if (!file.id.empty() && (own.word || names_a_form(form, file.study))) {
    std::vector<std::string> ids;
    for (const StudyForm& known : file.forms) ids.push_back(known.id);
    require_known(form, ids, "form of the study");
  }
  file.forms = {found == file.forms.end() ? StudyForm{"form", form} : *found};
  std::erase_if(file.published, [&](const PublishedSet& set) { return set.form != file.forms.front().id; });
}

void change_metric(StudyFile& file, const FitOptions& options) {
  const Metric& metric = options.metric;
  if (options.present.contains("--norm")) file.norm = metric.norm;
  const Constraints& asked = metric.constraints;
  if (!asked.exact_at.empty()) file.constraints.exact_at = asked.exact_at;
  if (asked.one_sided) file.constraints.one_sided = asked.one_sided;
  if (asked.at_most) file.constraints.at_most = asked.at_most;
  if (asked.at_least) file.constraints.at_least = asked.at_least;
  if (asked.monotone) file.constraints.monotone = asked.monotone;
}

/// The error and its weight; those of a built-in family belong to its target.
void change_error(StudyFile& file, const FitOptions& options) {
  if (options.present.contains("--error")) file.study.error = options.metric.error;
  if (options.present.contains("--weight")) {
    file.study.weight = options.metric.weight;
    file.has_weight = true;
  }
}

/// The bounds of the options instead of those of the file.
void change_bounds(StudyFile& file, const StudyOptions& own) {
  for (auto bounds = own.bounds.begin(); bounds != own.bounds.end(); ++bounds) {
    const std::string option = fmt::format("--bounds '{}'", to_text(*bounds)), &name = bounds->parameter;
    if (std::find_if(own.bounds.begin(), bounds, [&](const auto& of) { return of.parameter == name; }) !=
        bounds)
      throw UserError(fmt::format("{} gives {} a second time: leave one out", option, name));
    for (const Held& held : file.study.held) {
      if (held.parameter == name)
        throw UserError(
            fmt::format("{} does not go with --fix '{}={}', which gives {} one value: leave one out", option,
                        name, to_text(held.value), name));
    }
    std::erase_if(file.study.bounds, [&](const auto& of) { return of.parameter == name; });
    file.study.bounds.push_back(*bounds);
  }
}

/// A part of the file may not fit the options: then the fault is one of the file, since no option gave the
/// part.
void require_fitting_parts(const StudyFile& file, const FitOptions& options) {
  const StudyForm& form = file.forms.front();
  try {
    Study study = combinations(file.study, file.given).front();
    take_form(study, form);
    const std::vector<std::string> parameters = read_formulas(study).parameters;
    for (const ParameterBounds& bounds : options.study.bounds) {
      if (std::ranges::find(parameters, bounds.parameter) == parameters.end())
        throw UserError(fmt::format("--bounds '{}': the form has no parameter '{}', it must be one of {}",
                                    to_text(bounds), bounds.parameter, fmt::join(parameters, ", ")));
    }
  } catch (const StudyFault& fault) {
    if (options.id.empty() || options.present.contains(fault.part.option)) throw;
    throw UserError(fmt::format("study '{}'{}", options.id, fault_in(file, fault, form.id)));
  }
}

/// The study that is named, or an empty one for --form.
StudyFile named_file(const FitOptions& options) {
  if (options.id.empty()) return {};
  const auto folders = study_folders(options.studies);
  auto found = find_study(options.id, folders);
  if (!found) {
    std::vector<std::string> known = fitted_ids();
    for (const std::string& id : study_ids(folders)) known.push_back(id);
    require_known(options.id, known, "form, constant or study");
  }
  return *std::move(found);
}

StudyFile named_family(const FitOptions& options) {
  const auto [family, published] = find_fit(options.id);
  const Metric& metric = options.metric;
  return family_file(*family, published, surface_for(*family, options), metric.error, metric.weight);
}

/// The options that belong to a study, not to a built-in family.
void change_study(StudyFile& file, const FitOptions& options, const Checkpoint& checkpoint) {
  const StudyOptions& own = options.study;
  refuse_surface(options, options.id.empty() ? "--form" : "a study");
  if (!own.target.empty() && !own.table.empty())
    throw UserError("--table does not go with --target: the rows are the target");
  if (!own.target.empty()) {
    file.study.target = own.target;
    file.study.rows = nullptr;
  }
  if (file.study.target.empty() && file.study.rows == nullptr && own.table.empty())
    throw UserError("--form needs a --target, the formula to approximate, or a --table of measured rows");
  if (own.form || own.word) change_form(file, own);
  auto& definitions = file.study.definitions;
  definitions.insert(definitions.end(), own.definitions.begin(), own.definitions.end());
  file.study.parameters = own.parameters;
  change_error(file, options);
  if (!own.over.empty()) file.study.over = own.over;
  if (own.table == "-") {
    const std::string name = "standard input";
    take_rows(file, parts_of_standard_input(most_row_bytes, checkpoint), name, own.value, name);
  } else if (!own.table.empty()) {
    take_rows(file, parts_of(own.table, most_row_bytes), own.table, own.value, own.table);
  } else if (options.present.contains("--value")) {
    throw UserError(fmt::format("--value '{}' belongs to --table: it names its column", own.value));
  }
}

}  // namespace

StudyFile chosen_study(const FitOptions& options, const Checkpoint& checkpoint) {
  const StudyOptions& own = options.study;
  if (options.id.empty() && !own.form) {
    refuse_formulas(options);
    throw UserError(fmt::format(
        "{0} needs a family, a published constant, a study or --form (see 'shadefit list' and 'shadefit help {0}')",
        options.words.front()));
  }
  const bool is_family = is_known_id(options.id);
  StudyFile file = is_family ? named_family(options) : named_file(options);
  if (is_family) {
    refuse_formulas(options);
    if (!own.over.empty()) file.study.over = own.over;
  } else {
    change_study(file, options, checkpoint);
  }
  change_range(file, options);
  change_given(file, options);
  if (has_peak(file.study) && file.study.error == Error::relative) narrow_to_visible(file);
  file.study.held = options.metric.constraints.held;
  file.study.starts = own.starts;
  change_bounds(file, own);
  change_metric(file, options);
  require_fitting_parts(file, options);
  require_use(file, options);
  return file;
}

StudyFile compared_study(const FitOptions& options, const Checkpoint& checkpoint) {
  StudyFile file = chosen_study(options, checkpoint);
  if (!is_known_id(options.id)) return file;
  const auto [named, published] = find_fit(options.id);
  const Family& family = *named;
  take_rivals(file, family, published, surface_for(family, options));
  if (!family.has_exponent() || options.exponents || !options.study.given.empty()) return file;
  auto& exponents = file.given.front().second;
  if (exponents.size() > 2) exponents = {exponents.front(), exponents.back()};
  return file;
}

}  // namespace shadefit
