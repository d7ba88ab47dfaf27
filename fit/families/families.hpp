#pragma once

#include <tuple>

#include "fit/families/fresnel_families.hpp"
#include "fit/families/lobe_families.hpp"

/// The families that can be fitted: each joins a target and a form of approx/. The engine fits them as
/// studies (fit/catalogue_study.hpp); here are the errors of their curves. A family brings
/// - `info`: its texts; `target_of` and `form_of`: its two formulas of the cosine, in any scalar;
/// `parameters`: the names of its parameters; `starts`: three points spread over the box of the search;
/// - `Sample`: the values at a cosine that do not depend on the parameters; `sample` computes them once;
/// - `form`, `error` (form - target) and `relative_error` at a sample;
/// - `shape`: the data for the substitution; `relative_end`: the smallest cosine at which a relative error
/// has a meaning, empty if there is none; `relative_to`: the denominator of a relative error, in words;
/// - for a quotient, its `denominator`, which must stay positive
/// (fit/families/admissible.hpp).
namespace shadefit {

/// Every family, in the order of the report. Families that only compare come last.
using Families = std::tuple<SgOffset, FresnelOneTerm, FresnelQuadratic, PhongBlinn, SgScaled, FresnelCubic,
                            FresnelQuartic, FresnelFourth, FresnelSquare, FresnelRational>;

}  // namespace shadefit
