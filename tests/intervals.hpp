#pragma once

#include "fit/proof/interval.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/decimal100.hpp"

/// Looking into an interval, in 100 digits.
namespace shadefit::testing {

inline Decimal100 end(const Interval& x, bool upper) {
  const auto bound = upper ? boost::multiprecision::upper(x) : boost::multiprecision::lower(x);
  return Decimal100(bound.str(100));
}

inline bool contains(const Interval& x, const Decimal100& truth) {
  return end(x, false) <= truth && truth <= end(x, true);
}

inline Interval span(const char* low, const char* high) {
  return Scalar<Interval>::hull(constant<Interval>(low), constant<Interval>(high));
}

}  // namespace shadefit::testing
