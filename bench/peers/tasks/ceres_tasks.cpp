// The least-squares tasks of bench/peers/run with Ceres, as in its tutorial: a block of automatic derivatives
// for each of 1001 samples.
#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "task_program.hpp"

namespace {

using peer_tasks::Answer;
using peer_tasks::Task;

constexpr int samples = 1001;

/// The forms. T is double or a Jet; `at` is c or the angle.
struct Pair {
  static constexpr std::size_t size = 2;
  template <class T>
  static T value(double c, const T* p, double) {
    using std::exp;
    return exp((p[0] * c + p[1]) * c * M_LN2);
  }
};

struct Gaussian {
  static constexpr std::size_t size = 1;
  template <class T>
  static T value(double c, const T* p, double k) {
    using std::exp;
    return exp((p[0] + k) * (c - 1));
  }
};

struct Blinn {
  static constexpr std::size_t size = 1;
  template <class T>
  static T value(double angle, const T* p, double rho) {
    using std::exp;
    return exp(p[0] * (rho * std::log(std::cos(angle / 2))));
  }
};

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

/// Fits a form to weighted samples of its target, from 0 to `end`.
template <class Form, class Target, class Weight>
std::array<double, Form::size> fit(std::array<double, Form::size> p, double exponent, double end,
                                   const Target& target, const Weight& weight, Tolerance tolerance) {
  using Residual = SampleResidual<Form>;
  ceres::Problem problem;
  for (int i = 0; i < samples; ++i) {
    const double at = end * i / (samples - 1);
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Residual, 1, Form::size>(
                                 new Residual{at, target(at), std::sqrt(weight(at)), exponent}),
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

double evenly(double) {
  return 1;
}

Answer pair(Tolerance tolerance) {
  const auto target = [](double c) { return std::pow(1 - c, 5); };
  const auto p = fit<Pair>({-5, -5}, 0, 1, target, evenly, tolerance);
  return {{"a", p[0]}, {"b", p[1]}};
}

Answer gaussians(const std::vector<double>& exponents, Tolerance tolerance) {
  Answer answer;
  for (const double k : exponents) {
    const auto target = [k](double c) { return std::pow(c, k); };
    answer.push_back({"x", fit<Gaussian>({0.5}, k, 1, target, evenly, tolerance)[0], k});
  }
  return answer;
}

Answer blinns(Tolerance tolerance) {
  Answer answer;
  for (double rho = 2; rho <= 2048; rho *= 2) {
    const auto target = [rho](double angle) { return std::pow(std::max(std::cos(angle), 0.0), rho); };
    const auto weight = [](double angle) { return std::sin(angle); };
    answer.push_back({"x", fit<Blinn>({3}, rho, M_PI_2, target, weight, tolerance)[0], rho});
  }
  return answer;
}

}  // namespace

int main(int argc, char** argv) {
  google::InitGoogleLogging(argv[0]);
  FLAGS_minloglevel = 3;
  std::vector<double> sweep;
  for (int k = 3; k <= 15; ++k) sweep.push_back(k);
  std::vector<Task> tasks;
  for (const Tolerance tolerance : {Tolerance::usual, Tolerance::tight}) {
    const std::string way = std::string("1001 AutoDiff blocks, DENSE_QR, ") +
                            (tolerance == Tolerance::usual ? "default" : "tight");
    tasks.push_back({"T1", way, [=] { return pair(tolerance); }});
    tasks.push_back({"T2", way, [=] { return gaussians(sweep, tolerance); }});
    tasks.push_back({"T2-large", way, [=] { return gaussians({100, 1e3, 1e4, 1e6}, tolerance); }});
    tasks.push_back({"T3", way, [=] { return blinns(tolerance); }});
  }
  return peer_tasks::run_all(argc, argv, tasks);
}
