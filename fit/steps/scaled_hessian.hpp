#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "fit/steps/sums.hpp"

namespace shadefit {

/// A Hessian in units that make its diagonal 1. Parameters have units: without this a small one would look
/// like rounding beside a large one.
struct ScaledHessian {
  explicit ScaledHessian(const ParameterMatrix<double>& hessian);

  ParameterMatrix<double> inverse() const;  ///< of the Hessian itself

  ParameterVector<double> units;  ///< of the parameters
  ParameterMatrix<double> scaled;
};

/// Whether a point with this Hessian is a minimum: each pivot of L D L^T is positive.
bool is_minimum(ParameterMatrix<double> hessian);

/// A parameter counts as 0 if it moves the form by less than this share of the target. Then its digits are
/// those of that share.
inline constexpr double negligible = 1e-6;

/// The largest step, each relative to its parameter. `hessian` is that of half the square.
template <class Step>
long double relative_size(const Step& step, const std::vector<double>& parameters,
                          const ParameterMatrix<double>& hessian, double target_norm) {
  long double largest = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double least = negligible * target_norm / std::sqrt(std::abs(hessian(row, row)));
    const double size = std::max(std::abs(parameters[i]), least);
    largest =
        std::max(largest, std::abs(static_cast<long double>(step[row]) / static_cast<long double>(size)));
  }
  return largest;
}

/// A parameter that moves the form by less than 1e-16 of the target is rounding: it becomes 0.
void clear_rounding(std::span<double> parameters, const ParameterMatrix<double>& hessian, double target_norm);

}  // namespace shadefit
