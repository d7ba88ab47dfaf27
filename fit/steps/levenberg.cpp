#include "fit/steps/levenberg.hpp"

#include <ceres/tiny_solver.h>

#include <algorithm>
#include <array>

namespace shadefit {
namespace {

/// As many residuals as fit into matrices on the stack.
constexpr int most_on_stack = 12;

/// For one or two parameters the sizes are known to the compiler, and nothing is allocated. Residuals that
/// are missing are 0. Each size takes seconds to compile.
template <int N>
class OnStack {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = most_on_stack, NUM_PARAMETERS = N };

  explicit OnStack(const Residuals& residuals) : residuals_(residuals) {}

  int NumParameters() const { return N; }
  bool operator()(const double* parameters, double* residuals, double* jacobian) const {
    std::fill_n(residuals, most_on_stack, 0.0);
    std::array<double, most_on_stack * N> columns;
    residuals_.evaluate(parameters, residuals, jacobian == nullptr ? nullptr : columns.data());
    if (jacobian == nullptr) return true;
    std::fill_n(jacobian, most_on_stack * N, 0.0);
    for (Eigen::Index i = 0; i < N; ++i)
      std::copy_n(columns.data() + i * residuals_.count, residuals_.count, jacobian + i * most_on_stack);
    return true;
  }

 private:
  const Residuals& residuals_;
};

class OfAnySize {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  OfAnySize(const Residuals& residuals, Eigen::Index parameters)
      : residuals_(residuals), parameters_(parameters) {}

  int NumResiduals() const { return static_cast<int>(residuals_.count); }
  int NumParameters() const { return static_cast<int>(parameters_); }
  bool operator()(const double* parameters, double* residuals, double* jacobian) const {
    residuals_.evaluate(parameters, residuals, jacobian);
    return true;
  }

 private:
  const Residuals& residuals_;
  Eigen::Index parameters_;
};

template <class Function>
int descend_by(const Function& function, const Patience& patience, Eigen::Ref<Eigen::VectorXd> parameters) {
  using Solver = ceres::TinySolver<Function>;
  Solver solver;
  solver.options.parameter_tolerance = patience.last_step;
  solver.options.max_num_iterations = patience.most_steps;
  solver.options.function_tolerance = patience.last_change;
  solver.options.gradient_tolerance = 0;
  solver.options.cost_threshold = 0;
  typename Solver::Parameters p = parameters;
  const int steps = solver.Solve(function, &p).iterations;
  parameters = p;
  return steps;
}

}  // namespace

int descend(const Residuals& residuals, const Patience& patience, Eigen::Ref<Eigen::VectorXd> parameters) {
  const bool is_small = residuals.count <= most_on_stack;
  if (is_small && parameters.size() == 1) return descend_by(OnStack<1>(residuals), patience, parameters);
  if (is_small && parameters.size() == 2) return descend_by(OnStack<2>(residuals), patience, parameters);
  return descend_by(OfAnySize(residuals, parameters.size()), patience, parameters);
}

}  // namespace shadefit
