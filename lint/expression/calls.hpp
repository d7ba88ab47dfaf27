#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Calls of programs in the notation of formulas.
namespace shadefit::lint {

/// The arguments of a call, without the blanks around.
std::vector<std::string_view> arguments_in(std::string_view list);

/// A call that compares, chooses or multiplies vectors, as a formula: lessThan(a, b) is 1 or 0, as a mask of
/// mix() is; select(x < t, a, b) is x < t ? a : b, and so is select(b, a, x < t) of WGSL;
/// dot(u, vec3(a, b, c)) is a sum over names for the components of u. Empty for other calls.
std::optional<std::string> call_as_formula(std::string_view function, std::string_view arguments);

}  // namespace shadefit::lint
