#pragma once

#include <string>

#include "fit/proof/certificate.hpp"

namespace shadefit {

/// What a certificate states, for a reader: a line each for the form and the target with their constants put
/// in, the exponent, the surface, how the error is measured, the domain, the bounds and where the largest
/// error is, and what is proven of the form. Doubles as their shortest decimals. The certificate's subject
/// has no `fault_of`.
std::string statement_of(const Certificate& certificate);

}  // namespace shadefit
