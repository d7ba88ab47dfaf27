#include "fit/least_squares/sampled_errors.hpp"

#include <algorithm>

namespace shadefit {
namespace {

/// The indices of the free parameters.
std::vector<Eigen::Index> free_indices(const GivenParameters& given) {
  std::vector<Eigen::Index> indices;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i]) indices.push_back(static_cast<Eigen::Index>(i));
  }
  return indices;
}

template <class T>
Sums<T> of_free(const Sums<T>& all, const GivenParameters& given) {
  const auto free = free_indices(given);
  return {all.square, all.gradient(free), all.hessian(free, free)};
}

}  // namespace

std::size_t free_count(const GivenParameters& given) {
  return static_cast<std::size_t>(std::count(given.begin(), given.end(), std::nullopt));
}

ParameterVector<double> free_ones(const GivenParameters& given, const ParameterVector<double>& all) {
  return all(free_indices(given));
}

SampledErrors of_free(const SampledErrors& all, const GivenParameters& given) {
  if (free_count(given) == given.size()) return all;
  using Parameters = std::span<const double>;
  return {.square = [=](Parameters p) { return all.square(with_given(given, p)); },
          .gradient = [=](Parameters p) { return of_free(all.gradient(with_given(given, p)), given); },
          .derivatives = [=](Parameters p) { return of_free(all.derivatives(with_given(given, p)), given); },
          .errors =
              [=](Parameters p, std::span<double> r, std::span<double> slopes) {
                std::vector<double> of_all(r.size() * given.size());
                all.errors(with_given(given, p), r, of_all);
                auto next = slopes.begin();
                for (const Eigen::Index i : free_indices(given)) {
                  const auto column = of_all.begin() + i * static_cast<std::ptrdiff_t>(r.size());
                  next = std::copy_n(column, r.size(), next);
                }
              },
          .weight = all.weight,
          .is_admissible = [=](Parameters p) { return all.is_admissible(with_given(given, p)); }};
}

LeastSquaresProblem of_free(const LeastSquaresProblem& all, const GivenParameters& given) {
  if (free_count(given) == given.size()) return all;
  const auto wide = [=, of_all = all.wide](std::size_t rule, std::span<const long double> p) {
    return of_free(of_all(rule, with_given(given, p)), given);
  };
  return {of_free(all.basin, given), of_free(all.fine, given), wide};
}

}  // namespace shadefit
