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
  /// What `emit` would write for it: all constants are numbers. Its arguments are c; c and code; or x, y
  /// and z of a normal.
  ShaderFunction function;
};

/// The function of a form with a set of its constants.
FormFunction form_function(const forms::Target& target, const forms::FormEntry& form,
                           const forms::Constants& constants);

/// Every form with every set, but those of several lights: they are sums of one.
std::vector<FormFunction> form_functions(const forms::Catalogue& catalogue);

}  // namespace shadefit::device
