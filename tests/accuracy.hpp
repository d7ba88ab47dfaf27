#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>

#include "fit/multiprecision.hpp"

/// The ruler of the tests.
namespace shadefit::testing {

/// How many doubles lie from a to b, counted across zero too; 0 only for equal values (0 and -0 are equal).
inline std::uint64_t ulps_between(double a, double b) {
  const auto ordered = [](double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
  };
  const std::int64_t low = std::min(ordered(a), ordered(b)), high = std::max(ordered(a), ordered(b));
  return static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
}

/// Whether `computed` is within a relative tolerance of the 50-digit `expected`; a failure says where (x) and
/// how far. The expected value is wider than any computed one by its type.
inline ::testing::AssertionResult is_close(const std::string& x, const Decimal50& expected,
                                           const Decimal50& computed, double tolerance) {
  const Decimal50 error = expected == 0 ? Decimal50(abs(computed)) : Decimal50(abs(computed / expected - 1));
  if (error <= tolerance) return ::testing::AssertionSuccess();
  const auto near = expected.convert_to<double>(), got = computed.convert_to<double>();
  std::ostringstream message;
  message.precision(20);
  message << "x = " << x << "\n  expected " << expected << "\n  computed " << computed << std::hexfloat
          << "\n  as hex   " << near << " and " << got << std::defaultfloat << "\n  apart    "
          << ulps_between(near, got) << " ulps\n  error/tolerance "
          << Decimal50(error / tolerance).convert_to<double>();
  return ::testing::AssertionFailure() << message.str();
}

}  // namespace shadefit::testing
