#pragma once

#include <string_view>
#include <vector>

#include "fit/scalars/symbolic.hpp"

/// The forms whose instructions the ledger counts, by name: the formulas of approx/ run on the symbolic
/// scalar.
namespace shadefit {

/// What the form of that name computes, with the variables that a shader has at hand: a cosine c, a power k
/// or s, a sharpness A, a gloss g. A form of lights has a result for each. Throws std::invalid_argument for a
/// name that is none.
std::vector<Symbolic> shader_form(std::string_view name, int lights = 1);

}  // namespace shadefit
