#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "fit/errors/ulps.hpp"
#include "fit/scalars/multiprecision.hpp"

/// The ruler of the tests.
namespace shadefit::testing {

/// Whether `computed` is within a relative tolerance of the 50-digit `expected`; a failure names the place
/// (x) and the distance. The type of the expected value is wider than any computed one.
inline ::testing::AssertionResult is_close(const std::string& x, const Decimal50& expected,
                                           const Decimal50& computed, double tolerance) {
  const Decimal50 error = expected == 0 ? Decimal50(abs(computed)) : Decimal50(abs(computed / expected - 1));
  if (error <= tolerance) return ::testing::AssertionSuccess();
  const auto near = expected.convert_to<double>(), got = computed.convert_to<double>();
  std::ostringstream message;
  message.precision(20);
  message << "x = " << x << "\n  expected " << expected << "\n  computed " << computed << std::hexfloat
          << "\n  as hex   " << near << " and " << got << std::defaultfloat << "\n  apart    "
          << ulps_off(got, expected, double_format) << " ulps\n  error/tolerance "
          << Decimal50(error / tolerance).convert_to<double>();
  return ::testing::AssertionFailure() << message.str();
}

}  // namespace shadefit::testing
