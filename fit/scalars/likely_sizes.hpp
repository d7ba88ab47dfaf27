#pragma once

#include <map>
#include <string>
#include <vector>

#include "fit/scalars/symbolic.hpp"

namespace shadefit {

/// How large the parameters of a form probably are, as powers of two: `sizes` has the variables, `result` is
/// the size of the form's value.
///
/// What people write has units. Terms of a sum have the same size, and so have both arguments of `min`; an
/// exponent, an angle and the argument of a sigmoid are of the size of 1. In powers of two these are linear
/// equations for the sizes of the parameters. Where they contradict each other, their least squares decide; a
/// parameter that they leave open has the size of 1.
std::vector<double> likely_sizes(const Symbolic& form, const std::vector<std::string>& parameters,
                                 const std::map<std::string, double>& sizes, double result);

}  // namespace shadefit
