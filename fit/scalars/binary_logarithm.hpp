#pragma once

#include <limits>
#include <vector>

#include "approx/scalar.hpp"

/// exp2 and log2 by their definition: square roots and squares only, without an exponential or a logarithm.
/// They are slow, but independent of the functions that they check. T is a multiprecision number.
namespace shadefit {

/// 2^x = 2^n * 2^(1/2) * 2^(1/4) * .. over the binary digits of x: all digits of T, each factor the square
/// root of the one before. Relative error: a few epsilons per digit. An object stores the roots.
template <class T>
class RootsOfTwo {
 public:
  RootsOfTwo() {
    T root = 2;
    for (int i = 0; i < std::numeric_limits<T>::digits; ++i) roots_.push_back(root = sqrt(root));
  }

  T exp2(const T& x) const {
    const T whole = floor(x);
    T rest = x - whole, product = 1;
    for (const T& root : roots_) {
      rest *= 2;
      if (rest < 1) continue;
      rest -= 1;
      product *= root;
    }
    return ldexp(product, static_cast<int>(whole));
  }

 private:
  std::vector<T> roots_;
};

/// log2(x), x > 0: the whole part is the binary exponent. A square doubles the logarithm, so the next binary
/// digit is 1 if the square of the rest is at least 2. The rounding of each square counts half as much as
/// that of the one before: the absolute error is a few epsilons.
template <class T>
T log2_by_squares(const T& x) {
  int exponent = 0;
  T rest = 2 * frexp(x, &exponent);  // in [1, 2)
  T sum = exponent - 1, digit = 1;
  for (int i = 0; i < std::numeric_limits<T>::digits; ++i) {
    rest *= rest;
    digit /= 2;
    if (rest < 2) continue;
    rest /= 2;
    sum += digit;
  }
  return sum;
}

}  // namespace shadefit
