#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "fit/scalars/half.hpp"

/// The floating-point formats of records, by name.
namespace shadefit {

/// `call.template operator()<T>()` for the format of that name: half, float, double or long double. Throws
/// std::invalid_argument for another name.
template <class Call>
auto in_format(std::string_view name, const Call& call) {
  if (name == "half") return call.template operator()<Eigen::half>();
  if (name == "float") return call.template operator()<float>();
  if (name == "double") return call.template operator()<double>();
  if (name == "long double") return call.template operator()<long double>();
  throw std::invalid_argument("no format '" + std::string(name) + "'");
}

/// The largest x of the format, between two others, up to which `holds` (which holds at `low`, not at `high`,
/// and changes once between): by bisection over the numbers of the format.
template <class T, class Holds>
double last_that_holds(double low, double high, const Holds& holds) {
  for (;;) {
    const T middle = rounded_to<T>(low + (high - low) / 2);
    if (widened(middle) == low || widened(middle) == high) return low;
    (holds(middle) ? low : high) = widened(middle);
  }
}

}  // namespace shadefit
