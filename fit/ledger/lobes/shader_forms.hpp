#pragma once

#include <string_view>
#include <vector>

#include "fit/scalars/symbolic.hpp"

/// The forms whose instructions the ledger counts, by name: the formulas of approx/ run on the symbolic
/// scalar.
namespace shadefit {

/// The results of the form of that name, in the variables of a shader: a cosine c, a power k or s, a
/// sharpness A, a gloss g. A form of lights has one result per light. Throws std::invalid_argument for an
/// unknown name.
std::vector<Symbolic> shader_form(std::string_view name, int lights = 1);

}  // namespace shadefit
