#pragma once

#include "bench/forms/catalogue.hpp"
#include "bench/forms/float_errors.hpp"

/// A form of the catalogue that `bench --exhaustive` sweeps.
namespace shadefit::bench {

/// A form with a set of its constants, and the target that it is compared with.
struct SweptForm {
  const forms::FormEntry* form;
  const forms::Target* target;
  const forms::Constants* constants;
};

/// The form in float, and as the reference the target's formula in double, by the library. The reference's
/// error is a few last bits of a double: less than one for pow of the C library (as documented), half of one
/// for 1 - c of a float, multiplied by a power of some tens. One ulp of a float is 2^29 ulps of a double, so
/// the reference rounds to the right float, except within a millionth of the middle between two floats.
FloatSubject subject_of(const SweptForm& swept);

}  // namespace shadefit::bench
