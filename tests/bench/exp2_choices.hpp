#pragma once

#include "approx/exp2_polynomial.hpp"

/// The polynomials for exp2, for tests of each.
namespace shadefit::testing {

/// Calls visitor with each Exp2Choice of a format.
template <class Format, class Visitor>
void for_each_degree(const Visitor& visitor) {
  visitor(Exp2Choice<2, Format>());
  visitor(Exp2Choice<3, Format>());
  visitor(Exp2Choice<4, Format>());
  visitor(Exp2Choice<5, Format>());
  visitor(Exp2Choice<6, Format>());
}

}  // namespace shadefit::testing
