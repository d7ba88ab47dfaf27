#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Calls in programs, in the notation of formulas.
namespace shadefit::lint {

/// The arguments of a call, without the blanks around.
std::vector<std::string_view> arguments_in(std::string_view list);

/// A call that compares, selects or multiplies vectors, as a formula: lessThan(a, b) is 1 or 0, as a mask for
/// mix(); select(x < t, a, b) is x < t ? a : b, and so is select(b, a, x < t) of WGSL; dot(u, vec3(a, b, c))
/// is a sum over the components of u by name; __fmul_rn(a, b) of CUDA is a product. Empty for other calls.
std::optional<std::string> call_as_formula(std::string_view function, std::string_view arguments);

}  // namespace shadefit::lint
