#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "app/studies/find_study.hpp"
#include "fit/catalogue/study_file.hpp"
#include "fit/study/study.hpp"
#include "reports/code/shader_code.hpp"

/// The forms of every study in studies/, as functions that `emit` writes.
namespace shadefit::testing {

/// A form with one set of constants.
struct FormOfStudy {
  ShaderFunction function;  ///< with a comment: what the study says
  ReadStudy read;
  PrintedValues constants;
  bool is_published = true;  ///< else 0.625 stands for each constant
};

/// The function of a form whose parameters have printed values.
inline FormOfStudy form_of_study(const std::string& name, const ReadStudy& read,
                                 const PrintedValues& constants) {
  FormOfStudy form{{name, {}, read.form}, read, constants};
  std::replace(form.function.name.begin(), form.function.name.end(), '-', '_');
  for (const StudyAxis& axis : read.axes) form.function.arguments.push_back(axis.variable);
  form.function.result = evaluate<Symbolic>(read.form, [&](const std::string& variable) {
    const auto found = std::find_if(constants.begin(), constants.end(),
                                    [&](const auto& constant) { return constant.first == variable; });
    return found == constants.end() ? Symbolic::variable(variable) : Symbolic::number(found->second);
  });
  return form;
}

/// Of every study, with the first of its given constants, each form with each of its published sets; with
/// 0.625 for the constants of a form that has none.
inline std::vector<FormOfStudy> forms_of_studies() {
  std::vector<FormOfStudy> forms;
  for (const auto& path : study_files({std::string(SHADEFIT_SOURCE_DIR) + "/studies"})) {
    const StudyFile file = load_study(path);
    for (const StudyForm& form : file.forms) {
      Study study = combinations(file.study, file.given).front();
      study.form = form.formula;
      const ReadStudy read = read_formulas(study);
      std::vector<PublishedSet> sets;
      std::copy_if(file.published.begin(), file.published.end(), std::back_inserter(sets),
                   [&](const PublishedSet& set) { return set.form == form.id && is_for(set, study); });
      const bool is_published = !sets.empty();
      if (!is_published) {
        sets.push_back({.form = form.id, .values = {}, .source = OthersText("not published")});
        for (const std::string& parameter : read.parameters)
          sets.front().values.emplace_back(parameter, "0.625");
      }
      for (std::size_t i = 0; i < sets.size(); ++i) {
        forms.push_back(
            form_of_study(file.id + "_" + form.id + "_" + std::to_string(i + 1), read, sets[i].values));
        forms.back().is_published = is_published;
        forms.back().function.comment = {form.formula, file.study.target, sets[i].source.unescaped()};
      }
    }
  }
  return forms;
}

}  // namespace shadefit::testing
