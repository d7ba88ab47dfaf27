#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "approx/arithmetic.hpp"
#include "approx/gloss.hpp"
#include "approx/shading.hpp"
#include "bench/forms/lanes.hpp"
#include "bench/shading/kernels/kernel.hpp"

/// The exponents of a plan's lobes; exp2 of an exponent is the lobe. One type for each form, made once per
/// material in the scalar S. Called with n.h if the power belongs to the material, else with n too.
namespace shadefit::shade {

/// A c - A.
template <class S>
class FusedExponent {
 public:
  explicit FusedExponent(const PlannedMaterial& m)
      : slope_(forms::Lanes<S>::of(m.slopes.data()[0])), offset_(forms::Lanes<S>::of(m.offset)) {}
  S operator()(const S& c) const { return gaussian_exponent_base_two(c, slope_); }
  S operator()(const S& c, const S& n) const {
    return gaussian_exponent_base_two(c, S((n + offset_) * slope_));
  }

 private:
  S slope_, offset_;
};

/// y (s1 + y (s2 + ..)), y = c - 1, with that many slopes.
template <class S, std::size_t count>
class SlopedExponent {
 public:
  explicit SlopedExponent(const PlannedMaterial& m) : offset_(forms::Lanes<S>::of(m.offset)) {
    for (std::size_t i = 0; i < count; ++i) slopes_[i] = forms::Lanes<S>::of(m.slopes.data()[i]);
  }
  S operator()(const S& c) const { return log2_by_slopes(S(c - integer<S>(1)), slopes_); }
  S operator()(const S& c, const S& n) const { return (n + offset_) * (*this)(c); }

 private:
  std::array<S, count> slopes_;
  S offset_;
};

/// n log2(c), with c at least the smallest normal float: log2(0) times a power of 0 would be NaN. For other
/// powers it changes nothing, because n.l is as small.
template <class S>
class LogarithmExponent {
 public:
  explicit LogarithmExponent(const PlannedMaterial& m)
      : power_(forms::Lanes<S>::of(m.power)),
        least_(forms::Lanes<S>::of(std::numeric_limits<float>::min())) {}
  S operator()(const S& c) const { return (*this)(c, power_); }
  S operator()(const S& c, const S& n) const { return power_exponent_base_two(S(max(c, least_)), n); }

 private:
  S power_, least_;
};

}  // namespace shadefit::shade
