#include "fit/steps/levenberg.hpp"

#include <ceres/tiny_solver.h>

namespace shadefit {
namespace {

/// Residuals for the solver. Where their sizes are known to the compiler, nothing is allocated.
template <int N, int Count>
class Function {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Count, NUM_PARAMETERS = N };

  Function(const Residuals& residuals, Eigen::Index parameters)
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

template <int N, int Count>
int descend_by(const Residuals& residuals, const Patience& patience, Eigen::Ref<Eigen::VectorXd> parameters) {
  using Solver = ceres::TinySolver<Function<N, Count>>;
  Solver solver;
  solver.options.parameter_tolerance = patience.last_step;
  solver.options.max_num_iterations = patience.most_steps;
  solver.options.function_tolerance = patience.last_change;
  solver.options.gradient_tolerance = 0;
  solver.options.cost_threshold = 0;
  typename Solver::Parameters p = parameters;
  const int steps = solver.Solve(Function<N, Count>(residuals, parameters.size()), &p).iterations;
  parameters = p;
  return steps;
}

}  // namespace

int descend(const Residuals& residuals, const Patience& patience, Eigen::Ref<Eigen::VectorXd> parameters) {
  // A projection has one residual more than parameters. Each size takes seconds to compile.
  const bool is_projection = residuals.count == parameters.size() + 1;
  if (is_projection && parameters.size() == 1) return descend_by<1, 2>(residuals, patience, parameters);
  if (is_projection && parameters.size() == 2) return descend_by<2, 3>(residuals, patience, parameters);
  return descend_by<Eigen::Dynamic, Eigen::Dynamic>(residuals, patience, parameters);
}

}  // namespace shadefit
