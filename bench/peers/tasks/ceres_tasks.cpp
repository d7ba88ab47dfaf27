// The least-squares tasks of bench/peers/run with Ceres, as in its tutorial: a block of automatic derivatives
// for each of 1001 samples.
#include <ceres/ceres.h>
#include <glog/logging.h>

#include <cmath>
#include <string>
#include <vector>

#include "sampled_tasks.hpp"

namespace {

using peer_tasks::SampledFit;
using peer_tasks::Task;

template <class Form>
struct SampleResidual {
  double at, target, root_weight, exponent;
  template <class T>
  bool operator()(const T* p, T* residual) const {
    residual[0] = root_weight * (Form::value(at, p, exponent) - target);
    return true;
  }
};

enum class Tolerance { usual, tight };

template <class Form>
std::vector<double> fit(const SampledFit& wanted, Tolerance tolerance) {
  using Residual = SampleResidual<Form>;
  std::vector<double> p = wanted.start;
  ceres::Problem problem;
  for (int i = 0; i < peer_tasks::samples; ++i) {
    const double at = wanted.place(i);
    const Residual residual{at, wanted.target(at), std::sqrt(wanted.weight(at)), wanted.exponent};
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Residual, 1, Form::size>(new Residual(residual)),
                             nullptr, p.data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  if (tolerance == Tolerance::tight) {
    options.function_tolerance = 0;
    options.gradient_tolerance = options.parameter_tolerance = 1e-16;
    options.max_num_iterations = 200;
  }
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return p;
}

}  // namespace

int main(int argc, char** argv) {
  google::InitGoogleLogging(argv[0]);
  FLAGS_minloglevel = 3;
  std::vector<Task> tasks;
  for (const Tolerance tolerance : {Tolerance::usual, Tolerance::tight}) {
    const std::string way = std::string("1001 AutoDiff blocks, DENSE_QR, ") +
                            (tolerance == Tolerance::usual ? "default" : "tight");
    for (const Task& task : peer_tasks::sampled_tasks(
             way, [=]<class Form>(Form, const SampledFit& wanted) { return fit<Form>(wanted, tolerance); }))
      tasks.push_back(task);
  }
  return peer_tasks::run_all(argc, argv, tasks);
}
