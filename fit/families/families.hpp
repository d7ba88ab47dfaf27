#pragma once

#include <tuple>

#include "fit/families/fresnel_families.hpp"
#include "fit/families/lobe_families.hpp"

/// The families that can be fitted: each joins a target and a form of approx/ for the solver. A family brings
/// - `info`: its texts; `target_of` and `form_of`: its two formulas of the cosine, in any scalar;
/// `parameters`: the names of its parameters; `starts`: three points spread over the box in
///   which the optimum is looked for;
/// - `Sample`: the values at a cosine that do not depend on the parameters; `sample` computes them once;
/// - `form`, `error` (form - target) and `relative_error` at a sample;
/// - `log_form` and `log_ratio` (log(form/target)) of a positive form; `is_linear`: whether these, or else
/// the form itself, are linear in the parameters;
/// - `shape`: what the substitution has to know; `relative_end`: the smallest cosine at which a relative
/// error has a
///   meaning, empty where there is no such number; `relative_to`: relative to what, in words;
/// - where the form has one, its `denominator`, which parameters must keep positive
/// (fit/families/admissible.hpp).
namespace shadefit {

/// Every family, in the order of the report; those of comparison come last.
using Families = std::tuple<SgOffset, FresnelOneTerm, FresnelQuadratic, PhongBlinn, SgScaled, FresnelCubic,
                            FresnelQuartic, FresnelFourth, FresnelSquare, FresnelRational>;

}  // namespace shadefit
