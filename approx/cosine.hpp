#pragma once

/// A cosine that keeps its distance from 1.
namespace shadefit {

/// A cosine c = cos(theta) in [0, 1] together with 1 - c, both to full relative precision.
/// A lobe of exponent 1e6 is only about 1e-6 wide in 1 - c. There, 1 - c computed from c has lost six of its
/// sixteen digits.
template <class T>
struct Cosine {
  T cos_theta;
  T one_minus_cos;
};

}  // namespace shadefit
