#pragma once

#include <array>
#include <cstddef>

namespace shadefit {

/// Whether a symmetric matrix, stored by rows, is positive definite: `is_positive` holds for each pivot of L
/// D L^T.
template <std::size_t N, class T, class IsPositive>
bool is_positive_definite(std::array<T, N * N> a, const IsPositive& is_positive) {
  for (std::size_t k = 0; k < N; ++k) {
    if (!is_positive(a[k * N + k])) return false;
    for (std::size_t i = k + 1; i < N; ++i) {
      for (std::size_t j = k + 1; j < N; ++j)
        a[i * N + j] = a[i * N + j] - a[i * N + k] * a[k * N + j] / a[k * N + k];
    }
  }
  return true;
}

}  // namespace shadefit
