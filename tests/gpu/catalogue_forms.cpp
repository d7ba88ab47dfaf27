// Prints the forms of the catalogue, each with every set of its constants, for tests/gpu: a JSON array of
// {id, name, variables: [{name, low, high}], code: {c, wgsl, msl}}.
#include <cstdio>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "bench/device/times/device_forms.hpp"

int main() {
  using namespace shadefit;
  nlohmann::json all = nlohmann::json::array();
  const device::DeviceForms forms = device::catalogue_forms(forms::catalogue(), {});
  for (const device::DeviceForm& form : forms.forms) {
    const device::DeviceTarget& target = forms.targets[form.target];
    ShaderFunction function = form.function;
    function.name += "_" + std::to_string(all.size());  // all of them are compiled together
    nlohmann::json variables = nlohmann::json::array(), code;
    for (std::size_t i = 0; i < function.arguments.size(); ++i)
      variables.push_back(
          {{"name", function.arguments[i]}, {"low", target.ranges[i].from}, {"high", target.ranges[i].to}});
    for (const Language language : {Language::c, Language::wgsl, Language::msl})
      code[std::string(name(language))] =
          shader_code(std::span(&function, 1), language, ShaderPrecision::float32, {});
    all.push_back({{"id", target.heading.id + "/" + form.row.form + "/" + form.row.constants},
                   {"name", function.name},
                   {"variables", variables},
                   {"code", code}});
  }
  std::puts(all.dump().c_str());
}
