#include "bench/device/form_functions.hpp"

#include <array>
#include <cstddef>
#include <optional>

#include "fit/scalars/symbolic.hpp"

namespace shadefit::device {
namespace {

/// The names of the function's arguments: what a form reads for each element.
std::vector<std::string> arguments_of(forms::Arguments arguments) {
  if (arguments == forms::Arguments::normal_to_lights) return {"x", "y", "z"};
  if (arguments == forms::Arguments::cosine_and_code) return {"c", "code"};
  return {"c"};
}

template <class Form>
Symbolic result_of(const std::vector<Symbolic>& numbers) {
  std::array<Symbolic, Form::parameters> p = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Symbolic, Form::parameters>{numbers.at(I)...};
  }
  (std::make_index_sequence<Form::parameters>());
  const auto prepared = Form::template prepared<Symbolic>(p);
  const auto variable = [](const char* name) { return Symbolic::variable(name); };
  if constexpr (Form::arguments == forms::Arguments::cosine) {
    return Form()(variable("c"), prepared);
  } else if constexpr (Form::arguments == forms::Arguments::cosine_and_code) {
    return Form()(variable("c"), variable("code"), prepared);
  } else {
    return Form()(std::array<Symbolic, 3>{variable("x"), variable("y"), variable("z")}, prepared);
  }
}

template <class... Forms>
Symbolic result_of(forms::FormList<Forms...>, std::string_view id, const std::vector<Symbolic>& numbers) {
  std::optional<Symbolic> result;
  ((Forms::id == id ? void(result = result_of<Forms>(numbers)) : void()), ...);
  return result.value();
}

}  // namespace

bool is_of_several_lights(const forms::Target& target) {
  constexpr std::size_t of_one_light = 4;  // its exponent and its direction
  return target.arguments == forms::Arguments::normal_to_lights && target.parameters.size() > of_one_light;
}

FormFunction form_function(const forms::Target& target, const forms::FormEntry& form,
                           const forms::Constants& constants) {
  std::vector<Symbolic> numbers;
  for (const auto* list : {&target.parameters, &constants.numbers}) {
    for (const forms::NamedNumber& number : *list) numbers.push_back(Symbolic::number(number.printed));
  }
  return {std::string(target.id), std::string(form.id), constants.id,
          ShaderFunction{form_name, arguments_of(form.arguments),
                         result_of(forms::AllForms(), form.id, numbers)}};
}

std::vector<FormFunction> form_functions(const forms::Catalogue& catalogue) {
  std::vector<FormFunction> functions;
  for (const forms::FormEntry& form : catalogue.forms) {
    const forms::Target& target = forms::target_of(catalogue, form.target);
    if (is_of_several_lights(target)) continue;
    for (const forms::Constants& constants : form.constants)
      functions.push_back(form_function(target, form, constants));
  }
  return functions;
}

}  // namespace shadefit::device
