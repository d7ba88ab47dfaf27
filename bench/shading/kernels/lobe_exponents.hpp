#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "approx/arithmetic.hpp"
#include "approx/gloss.hpp"
#include "approx/shading.hpp"
#include "bench/forms/lanes.hpp"
#include "bench/shading/kernels/kernel.hpp"

/// The exponents of a plan's lobes, exp2 of which is the lobe: a type each, made once of a material in the
/// scalar S. Called with n.h where the power is the material's, else with n as well.
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

/// y (s1 + y (s2 + ..)), y = c - 1, of so many slopes.
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

/// n log2(c), of a c that is at least the smallest normal float: log2(0) times a power of 0 is no number, and
/// of any other the n.l beside it is as small.
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
