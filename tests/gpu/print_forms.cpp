// Prints forms for tests/gpu: those of the catalogue with every set of their constants, and those of studies
// with every published set. A JSON array of {id, name, variables: [{name, low, high}], code: {c, wgsl, msl}}.
#include <cstdio>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "bench/tradeoff/timed_forms.hpp"
#include "fit/scalars/integral.hpp"
#include "tests/forms_of_studies.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::json;

void append(Json& all, const std::string& id, ShaderFunction function,
            const std::vector<bench::Range>& ranges) {
  function.name += "_" + std::to_string(all.size());  // all of them are compiled together
  Json variables = Json::array(), code;
  for (std::size_t i = 0; i < function.arguments.size(); ++i)
    variables.push_back({{"name", function.arguments[i]}, {"low", ranges[i].from}, {"high", ranges[i].to}});
  for (const Language language : {Language::c, Language::wgsl, Language::msl})
    code[std::string(name(language))] =
        shader_code(std::span(&function, 1), language, ShaderPrecision::float32, {});
  all.push_back({{"id", id}, {"name", function.name}, {"variables", variables}, {"code", code}});
}

Json every_form() {
  Json all = Json::array();
  const bench::Trade forms = bench::catalogue_forms(forms::catalogue(), {}, bench::Exp2Kinds::library);
  for (const bench::TimedForm& form : forms.forms) {
    append(all, form.target + "/" + form.form + "/" + form.constants, form.function,
           target_of(forms, form).ranges);
  }
  for (const testing::FormOfStudy& form : testing::forms_of_studies()) {
    if (!form.is_published || integral_depth(form.function.result) > 0) continue;
    std::vector<bench::Range> ranges;
    for (const StudyAxis& axis : form.read.axes) ranges.push_back({axis.lower, axis.upper});
    append(all, form.function.name, {form.function.name, form.function.arguments, form.function.result},
           ranges);
  }
  return all;
}

}  // namespace
}  // namespace shadefit

int main() {
  std::puts(shadefit::every_form().dump().c_str());
}
