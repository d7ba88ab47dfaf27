#pragma once

#include <vector>

#include "fit/catalogue/family.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// Fits under stress (least squares, uniform in the cosine): every lobe for exponents from 1e-3 to 1e9, the
/// one of exponent 15 and all other forms also on a thousandth of the domain. Each fit is right to its
/// `digits` or says that it did not converge.
std::vector<Fit> fits_under_stress(const Checkpoint& checkpoint);

}  // namespace shadefit
