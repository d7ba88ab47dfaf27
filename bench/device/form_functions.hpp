#pragma once

#include <string>
#include <vector>

#include "bench/forms/catalogue.hpp"
#include "reports/code/shader_code.hpp"

/// The forms of the catalogue as functions of shaders.
namespace shadefit::device {

/// The name of each function.
inline constexpr const char* form_name = "form";

/// A form with one set of its constants.
struct FormFunction {
  std::string target, form, constants;  ///< ids of the catalogue
  /// What `emit` would write for it: all constants are numbers. Its arguments are c, or c and code, or the x,
  /// y and z of a normal.
  ShaderFunction function;
};

/// Sums of several lights, which repeat the forms of one light.
bool is_of_several_lights(const forms::Target& target);

/// The function of a form with a set of its constants. The target is not of several lights.
FormFunction form_function(const forms::Target& target, const forms::FormEntry& form,
                           const forms::Constants& constants);

/// Every form with every set of constants, except those of several lights.
std::vector<FormFunction> form_functions(const forms::Catalogue& catalogue);

}  // namespace shadefit::device
