#pragma once

#include <cstddef>

namespace shadefit {

/// Whether a symmetric matrix of n rows, stored one after the other, is positive definite: `is_positive`
/// holds for each pivot of L D L^T.
template <class Numbers, class IsPositive>
bool is_positive_definite(Numbers a, std::size_t n, const IsPositive& is_positive) {
  for (std::size_t k = 0; k < n; ++k) {
    if (!is_positive(a[k * n + k])) return false;
    for (std::size_t i = k + 1; i < n; ++i) {
      for (std::size_t j = k + 1; j < n; ++j)
        a[i * n + j] = a[i * n + j] - a[i * n + k] * a[k * n + j] / a[k * n + k];
    }
  }
  return true;
}

}  // namespace shadefit
