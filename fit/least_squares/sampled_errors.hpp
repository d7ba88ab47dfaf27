#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fit/least_squares/sums.hpp"

/// The error of a form at the nodes of a rule, behind plain functions: the solver is compiled once, for every
/// form and any number of parameters.
namespace shadefit {

struct SampledErrors {
  std::function<double(std::span<const double>)> square;
  /// The Hessian is Gauss and Newton's part of it: sum of w r_i r_j.
  std::function<Sums<double>(std::span<const double>)> gradient;
  std::function<Sums<double>(std::span<const double>)> derivatives;
  /// The errors, and their derivatives parameter by parameter.
  std::function<void(std::span<const double>, std::span<double>, std::span<double>)> errors;
  std::function<double(std::size_t)> weight;
  std::function<bool(std::span<const double>)> is_admissible;  ///< at a start they are
};

/// A problem under each rule that its solver uses.
struct LeastSquaresProblem {
  SampledErrors basin, fine;
  /// The gradient in long double by a rule, an index of `fit_rules`.
  std::function<Sums<long double>(std::size_t, std::span<const long double>)> wide;
};

/// For each parameter of a form its value, if it is given; else it is free.
using GivenParameters = std::vector<std::optional<double>>;

std::size_t free_count(const GivenParameters& given);

/// The free parameters of all.
ParameterVector<double> free_ones(const GivenParameters& given, const ParameterVector<double>& all);

/// All parameters, the given ones in their places.
template <class T>
std::vector<T> with_given(const GivenParameters& given, std::span<const T> free) {
  std::vector<T> all;
  all.reserve(given.size());
  std::size_t next = 0;
  for (const auto& value : given) all.push_back(value ? static_cast<T>(*value) : free[next++]);
  return all;
}

/// The same problem in the free parameters alone. At least one is free.
SampledErrors of_free(const SampledErrors& errors, const GivenParameters& given);
LeastSquaresProblem of_free(const LeastSquaresProblem& problem, const GivenParameters& given);

}  // namespace shadefit
