#include "fit/study/study_problem.hpp"

#include <algorithm>
#include <span>

#include "fit/scalars/integral.hpp"
#include "fit/study/study_nodes.hpp"

namespace shadefit {
namespace {

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

StudyError::StudyError(const ReadStudy& study, IntegralRule rule)
    : parameter_count_(study.parameters.size()) {
  Graph graph(formula_inputs(study), rule);
  const std::size_t variables = node_variables(study).size();
  const int error = graph.add(error_formula(study));
  std::vector<int> slopes, outputs{error};
  for (std::size_t i = 0; i < parameter_count_; ++i) slopes.push_back(graph.derivative(error, variables + i));
  outputs.insert(outputs.end(), slopes.begin(), slopes.end());
  gradient_.emplace(graph, outputs, variables);
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) outputs.push_back(graph.derivative(slopes[i], variables + j));
  }
  hessian_.emplace(graph, outputs, variables);
  is_linear_ = linear_ones(graph, slopes, variables);
  // On either side of a kink that a parameter moves the form may be linear; across it, it is not.
  for (const Symbolic& kink : moving_kinks(study)) {
    for (std::size_t i = 0; i < is_linear_.size(); ++i)
      is_linear_[i] = is_linear_[i] && !contains_any(kink, {study.parameters[i]});
  }
  for (const int slope : slopes) is_open_.push_back(graph.is_zero(slope));
  target_.emplace(graph, std::vector{graph.add(scale_formula(study))}, variables);
  for (const Symbolic& pole : moving_poles(study))
    denominators_.emplace_back(graph, std::vector{graph.add(pole)}, variables);
}

}  // namespace shadefit
