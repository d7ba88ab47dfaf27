#pragma once

#include <stdexcept>

#include "fit/truths/albedos.hpp"

namespace shadefit {

/// An albedo of fit/truths/albedos.hpp in the scalar T. It has at most the digits of a long double, and no
/// enclosure: a scalar without a specialisation has none.
template <class T>
struct AlbedoIn {
  static T value(const Albedo&, const T&, const T&) {
    throw std::logic_error("an albedo in a scalar that has none");
  }
};

template <>
struct AlbedoIn<double> {
  static double value(const Albedo& albedo, double c, double alpha) { return albedo_value(albedo, c, alpha); }
};

template <>
struct AlbedoIn<long double> {
  static long double value(const Albedo& albedo, long double c, long double alpha) {
    return albedo_value(albedo, c, alpha);
  }
};

}  // namespace shadefit
