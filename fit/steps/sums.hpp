#pragma once

#include <Eigen/Core>
#include <span>

/// What a descent of least squares is told: sums over nodes that stand for integrals.
namespace shadefit {

/// A form has at most so many parameters that are fitted together.
inline constexpr int most_fitted = 16;

/// One number per parameter, on the stack.
template <class T>
using ParameterVector = Eigen::Matrix<T, Eigen::Dynamic, 1, 0, most_fitted, 1>;
template <class T>
using ParameterMatrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, 0, most_fitted, most_fitted>;

inline ParameterVector<double> vector_of(std::span<const double> values) {
  return Eigen::Map<const ParameterVector<double>>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Of the errors r at the nodes, with their weights w.
template <class T>
struct Sums {
  T square = 0;                 ///< sum of w r^2
  ParameterVector<T> gradient;  ///< of half the square: sum of w r r_i
  ParameterMatrix<T> hessian;   ///< of half the square: sum of w (r_i r_j + r r_ij)

  Sums& operator+=(const Sums& other) {
    square += other.square;
    gradient += other.gradient;
    hessian += other.hessian;
    return *this;
  }
};

}  // namespace shadefit
