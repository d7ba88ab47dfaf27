#include "fit/study/study_problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fit/scalars/hinges.hpp"
#include "fit/scalars/integral.hpp"

namespace shadefit {
namespace {

bool contains_any(const Symbolic& e, const std::vector<std::string>& names) {
  const auto variables = free_variables(e);
  return std::ranges::any_of(names, [&](const auto& name) { return variables.contains(name); });
}

/// The parameters in which the error is linear together: in their order, each one that keeps it linear.
std::vector<bool> linear_ones(Graph& graph, std::span<const int> slopes, std::size_t first) {
  std::vector<bool> is_linear(slopes.size());
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    is_linear[i] = true;
    for (std::size_t j = 0; j <= i && is_linear[i]; ++j)
      is_linear[i] = !is_linear[j] || graph.is_zero(graph.derivative(slopes[i], first + j));
  }
  return is_linear;
}

Symbolic weighted(const ReadStudy& study, const Symbolic& error) {
  return is_one(study.weight) ? error : study.weight * error;
}

/// The error of a form that is 0, up to its sign. A residual is smaller than form and target where it does
/// not cancel: then its own, where the parameters are 0.
Symbolic scale_formula(const ReadStudy& study) {
  const bool is_relative = study.error == Error::relative;
  if (!study.residual) return weighted(study, is_relative ? Symbolic::number("1") : study.target);
  const Symbolic residual = evaluate<Symbolic>(*study.residual, [&](const std::string& name) {
    const bool is_parameter = std::ranges::find(study.parameters, name) != study.parameters.end();
    return is_parameter ? Symbolic::number("0") : Symbolic::variable(name);
  });
  const auto size = [](const Symbolic& e) { return Symbolic::function("abs", {e}); };
  const Symbolic least = Symbolic::function("min", {size(residual), size(study.target)});
  return weighted(study, is_relative ? least / study.target : least);
}

}  // namespace

Symbolic error_formula(const ReadStudy& study) {
  const Symbolic difference = difference_of(study);
  return weighted(study, study.error == Error::relative ? difference / study.target : difference);
}

Symbolic error_factor(const ReadStudy& study) {
  return study.error == Error::relative ? study.weight / study.target : study.weight;
}

struct StudyError::Parts {
  Parts(const ReadStudy& study, IntegralRule rule)
      : graph(formula_inputs(study), rule), variables(node_variables(study).size()) {
    const int error = graph.add(error_formula(study));
    gradient = {error};
    for (std::size_t i = 0; i < study.parameters.size(); ++i)
      gradient.push_back(graph.derivative(error, variables + i));
    hessian = gradient;
    const std::span<const int> slopes = std::span(gradient).subspan(1);
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) hessian.push_back(graph.derivative(slopes[i], variables + j));
    }
    is_linear = linear_ones(graph, slopes, variables);
    // On either side of a kink that a parameter moves the form may be linear; across it, it is not.
    for (const Symbolic& kink : moving_kinks(study)) {
      for (std::size_t i = 0; i < is_linear.size(); ++i)
        is_linear[i] = is_linear[i] && !contains_any(kink, {study.parameters[i]});
    }
    for (const int slope : slopes) is_open.push_back(graph.is_zero(slope));
    target = {graph.add(scale_formula(study))};
    for (const Hinge& hinge : hinges_of(study.form)) {
      if (hinge.is_pole && contains_any(hinge.part, study.parameters))
        denominators.push_back({graph.add(hinge.part)});
    }
  }

  Graph graph;
  std::size_t variables;
  std::vector<int> gradient, hessian, target;
  std::vector<std::vector<int>> denominators;
  std::vector<bool> is_linear, is_open;
};

StudyError::StudyError(const ReadStudy& study, IntegralRule rule) : StudyError(Parts(study, rule)) {}

StudyError::StudyError(Parts parts)
    : parameter_count_(parts.gradient.size() - 1),
      is_linear_(std::move(parts.is_linear)),
      is_open_(std::move(parts.is_open)),
      gradient_(parts.graph, parts.gradient, parts.variables),
      hessian_(parts.graph, parts.hessian, parts.variables),
      target_(parts.graph, parts.target, parts.variables) {
  for (const auto& outputs : parts.denominators)
    denominators_.emplace_back(parts.graph, outputs, parts.variables);
}

namespace {

template <class T>
std::vector<std::vector<T>> narrowed(const std::vector<std::vector<long double>>& coordinates) {
  std::vector<std::vector<T>> result;
  for (const auto& of_variable : coordinates) result.emplace_back(of_variable.begin(), of_variable.end());
  return result;
}

}  // namespace

template <class T>
SampledStudy<T>::SampledStudy(const StudyError& error, const StudyNodes& nodes)
    : error_(&error),
      count_(error.parameter_count()),
      coordinates_(narrowed<T>(nodes.coordinates)),
      weights_(nodes.weights.begin(), nodes.weights.end()),
      gradient_(error.gradient(), coordinates_) {
  roots_.resize(static_cast<Eigen::Index>(size()));
  for (std::size_t i = 0; i < size(); ++i) roots_[static_cast<Eigen::Index>(i)] = std::sqrt(weights_[i]);
  constexpr std::size_t lanes = Batch<T>::lanes;
  packed_weights_.reserve(gradient_.packs());
  for (std::size_t pack = 0; pack < gradient_.packs(); ++pack) {
    std::array<T, lanes> group{};
    for (std::size_t l = 0; l < lanes && pack * lanes + l < size(); ++l)
      group[l] = weights_[pack * lanes + l];
    packed_weights_.push_back(Batch<T>::Lanes::joined(group));
  }
  for (const StagedTape& denominator : error.denominators())
    denominators_.emplace_back(denominator, coordinates_);
}

template <class T>
const Batch<T>& SampledStudy<T>::hessian() const {
  if (!hessian_) hessian_.emplace(error_->hessian(), coordinates_);
  return *hessian_;
}

template <class T>
T SampledStudy<T>::target_norm() const {
  if (!target_norm_) {
    std::vector<S> target;
    Batch<T>(error_->target(), coordinates_)(std::vector<T>(count_), target);
    T square = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const T value = lane(target, 0, i);
      if (std::isfinite(value)) square += weights_[i] * value * value;  // a residual may overflow there
    }
    target_norm_ = std::sqrt(square);
  }
  return *target_norm_;
}

template <class T>
T SampledStudy<T>::lane(const std::vector<S>& results, std::size_t row, std::size_t node) const {
  constexpr std::size_t lanes = Batch<T>::lanes;
  return Batch<T>::Lanes::lane(results[row * gradient_.packs() + node / lanes], node % lanes);
}

template <class T>
void SampledStudy<T>::errors(std::span<const T> parameters, VectorOf<T>& errors, MatrixOf<T>* slopes) const {
  std::vector<S> results;
  gradient_(parameters, results);
  errors.resize(static_cast<Eigen::Index>(size()));
  if (slopes != nullptr) slopes->resize(errors.size(), static_cast<Eigen::Index>(count_));
  for (std::size_t i = 0; i < size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    errors[row] = lane(results, 0, i);
    for (std::size_t j = 0; slopes != nullptr && j < count_; ++j)
      (*slopes)(row, static_cast<Eigen::Index>(j)) = lane(results, 1 + j, i);
  }
}

template <>
void SampledStudy<double>::products(std::span<const double> parameters, std::span<const Eigen::Index> columns,
                                    ProductMatrix<double>& result) const {
  constexpr std::size_t most = most_product_columns, parts = WideLoops::group;
  const std::size_t rows = columns.size();
  std::array<TwoLanes, most*(most + 1) / 2 * parts> sums;
  std::fill_n(sums.begin(), rows * (rows + 1) / 2 * parts, TwoLanes(0));
  gradient_.visit(parameters, [&](std::size_t first, std::size_t count, std::span<const S* const> outputs) {
    // The error is the first output and the last column.
    std::array<const TwoLanes*, most> of_row;
    for (std::size_t i = 0; i < rows; ++i) {
      const std::size_t output = static_cast<std::size_t>(columns[i]) + 1;
      of_row[i] = outputs[output < outputs.size() ? output : 0];
    }
    wide_loops().add_products(&packed_weights_[first], std::span(of_row).first(rows), sums.data(),
                              count / parts);
  });
  result.resize(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(rows));
  const TwoLanes* of_entry = sums.data();
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j, of_entry += parts) {
      const TwoLanes sum = (of_entry[0] + of_entry[1]) + (of_entry[2] + of_entry[3]);
      result(i, j) = result(j, i) = sum[0] + sum[1];
    }
  }
}

template <class T>
T SampledStudy<T>::square(std::span<const T> parameters) const {
  std::vector<S> results;
  gradient_(parameters, results);
  T sum = 0;
  for (std::size_t i = 0; i < size(); ++i) sum += weights_[i] * lane(results, 0, i) * lane(results, 0, i);
  return sum;
}

template <class T>
Sums<T> SampledStudy<T>::gradient(std::span<const T> parameters) const {
  std::vector<S> results;
  gradient_(parameters, results);
  Sums<T> sums{0, ParameterVector<T>::Zero(static_cast<Eigen::Index>(count_)), {}};
  for (std::size_t i = 0; i < size(); ++i) {
    const T weighted = weights_[i] * lane(results, 0, i);
    sums.square += weighted * lane(results, 0, i);
    for (std::size_t j = 0; j < count_; ++j)
      sums.gradient[static_cast<Eigen::Index>(j)] += weighted * lane(results, 1 + j, i);
  }
  return sums;
}

template <class T>
Sums<T> SampledStudy<T>::derivatives(std::span<const T> parameters) const {
  std::vector<S> results;
  hessian()(parameters, results);
  const auto n = static_cast<Eigen::Index>(count_);
  Sums<T> sums{0, ParameterVector<T>::Zero(n), ParameterMatrix<T>::Zero(n, n)};
  for (std::size_t node = 0; node < size(); ++node) {
    const T error = lane(results, 0, node), weight = weights_[node];
    sums.square += weight * error * error;
    std::size_t second = 1 + count_;
    for (Eigen::Index i = 0; i < n; ++i) {
      const T slope = lane(results, 1 + static_cast<std::size_t>(i), node);
      sums.gradient[i] += weight * error * slope;
      for (Eigen::Index j = 0; j <= i; ++j) {
        const T other = lane(results, 1 + static_cast<std::size_t>(j), node);
        sums.hessian(i, j) += weight * (slope * other + error * lane(results, second++, node));
      }
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = i + 1; j < n; ++j) sums.hessian(i, j) = sums.hessian(j, i);
  }
  return sums;
}

template <class T>
MatrixOf<T> SampledStudy<T>::curvature(std::span<const T> parameters, std::span<const T> shares) const {
  std::vector<S> results;
  hessian()(parameters, results);
  const auto n = static_cast<Eigen::Index>(count_);
  MatrixOf<T> sum = MatrixOf<T>::Zero(n, n);
  for (std::size_t node = 0; node < size(); ++node) {
    std::size_t second = 1 + count_;
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) sum(i, j) += shares[node] * lane(results, second++, node);
    }
  }
  return sum.template selfadjointView<Eigen::Lower>();
}

template <class T>
bool SampledStudy<T>::has_pole(std::span<const T> parameters) const {
  std::vector<S> results;
  for (const Batch<T>& denominator : denominators_) {
    denominator(parameters, results);
    bool is_positive = false, is_negative = false;
    for (std::size_t i = 0; i < size(); ++i) {
      const T value = lane(results, 0, i);
      is_positive = is_positive || !(value <= 0);
      is_negative = is_negative || !(value >= 0);
    }
    if (is_positive == is_negative) return true;
  }
  return false;
}

template class SampledStudy<double>;
template class SampledStudy<long double>;

}  // namespace shadefit
