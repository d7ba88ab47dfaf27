#pragma once

#include "fit/study/study_fit.hpp"

/// The Fresnel pair, fitted for a polynomial instead of exp2.
namespace shadefit {

/// The pair of exp2((a c + b) c) with the least largest |form - (1-c)^5| over c in [0, 1] if exp2 is a
/// polynomial of approx/exp2_polynomial.hpp and everything else is exact. It compensates a part of the
/// polynomial's error: with degree 2 the published pair is off by 0.0050, this pair by 0.0037. The parameters
/// are b and a, in this order; the level, the largest error, is sampled.
///
/// The degree goes from `least_exp2_degree` to `largest_exp2_degree`, of the polynomials for float. Throws
/// std::logic_error for another.
StudyFit fit_pair_for_exp2(int degree);

}  // namespace shadefit
