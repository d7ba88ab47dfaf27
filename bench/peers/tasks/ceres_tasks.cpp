// The least-squares tasks of bench/peers/run with Ceres. As in its tutorial: a block of automatic derivatives
// for each of 1001 samples. Also listed: Ceres and TinySolver on our Gauss-Legendre nodes.
#include <ceres/ceres.h>
#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>
#include <ceres/version.h>
#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "task_program.hpp"

namespace {

using peer_tasks::Answer;
using peer_tasks::Standing;
using peer_tasks::Variant;

constexpr int samples = 1001;
constexpr int node_count = 64;

/// The forms. T is double or a Jet; `at` is c, t = k (1 - c) or the angle.
struct Pair {
  static constexpr int size = 2;
  template <class T>
  static T value(double c, const T* p, double) {
    using std::exp;
    return exp((p[0] * c + p[1]) * c * M_LN2);
  }
};

struct GaussianInC {
  static constexpr int size = 1;
  template <class T>
  static T value(double c, const T* p, double k) {
    using std::exp;
    return exp((p[0] + k) * (c - 1));
  }
};

struct GaussianInT {
  static constexpr int size = 1;
  template <class T>
  static T value(double t, const T* p, double k) {
    using std::exp;
    return exp(-(p[0] + k) * (t / k));
  }
};

struct Blinn {
  static constexpr int size = 1;
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

/// All nodes in one residual.
template <class Form>
struct NodeResiduals {
  std::vector<double> at, target, root_weight;
  double exponent = 0;
  enum { NUM_RESIDUALS = node_count, NUM_PARAMETERS = Form::size };
  template <class T>
  bool operator()(const T* p, T* residual) const {
    for (std::size_t i = 0; i < node_count; ++i)
      residual[i] = root_weight[i] * (Form::value(at[i], p, exponent) - target[i]);
    return true;
  }
};

enum class Tolerance { usual, tight };

template <std::size_t N>
std::array<double, N> solve(ceres::Problem& problem, std::array<double, N> p, double* block,
                            Tolerance tolerance, Answer& answer) {
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
  const std::array<double, N> start = p;
  std::copy(block, block + N, p.begin());
  if (p == start)
    answer.remark(std::string("returned its start with ") +
                  ceres::TerminationTypeToString(summary.termination_type));
  return p;
}

template <class Form, class Target>
std::array<double, Form::size> tutorial(std::array<double, Form::size> start, double exponent, double end,
                                        bool by_sine, const Target& target, Tolerance tolerance,
                                        Answer& answer) {
  constexpr std::size_t N = Form::size;
  std::array<double, N> block = start;
  ceres::Problem problem;
  for (int i = 0; i < samples; ++i) {
    const double at = end * i / (samples - 1);
    using Residual = SampleResidual<Form>;
    const double weight = by_sine ? std::sqrt(std::sin(at)) : 1;
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Residual, 1, Form::size>(
                                 new Residual{at, target(at), weight, exponent}),
                             nullptr, block.data());
  }
  return solve<N>(problem, start, block.data(), tolerance, answer);
}

template <class Form, class Target>
NodeResiduals<Form> residuals(double exponent, double end, bool by_sine, const Target& target) {
  using Rule = boost::math::quadrature::gauss<double, node_count>;
  NodeResiduals<Form> result;
  result.exponent = exponent;
  for (std::size_t i = 0; i < node_count; ++i) {
    const std::size_t j = i / 2;
    const double s = (i % 2 == 0 ? 1 : -1) * Rule::abscissa()[j], at = end * (1 + s) / 2;
    result.at.push_back(at);
    result.target.push_back(target(at));
    result.root_weight.push_back(std::sqrt(Rule::weights()[j] * end / 2 * (by_sine ? std::sin(at) : 1)));
  }
  return result;
}

enum class Method { tutorial, nodes, tiny };

struct Way {
  Method method;
  Tolerance tolerance;
  std::string name;
};

/// One fit. Our nodes take the place of the tutorial's samples.
template <class Form, class Target>
std::array<double, Form::size> on_nodes(std::array<double, Form::size> start, double exponent, double end,
                                        bool by_sine, const Target& target, const Way& way, Answer& answer) {
  constexpr std::size_t N = Form::size;
  auto all = residuals<Form>(exponent, end, by_sine, target);
  if (way.method == Method::nodes) {
    std::array<double, N> block = start;
    ceres::Problem problem;
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<NodeResiduals<Form>, node_count, Form::size>(
                                 new NodeResiduals<Form>(std::move(all))),
                             nullptr, block.data());
    return solve<N>(problem, start, block.data(), way.tolerance, answer);
  }
  ceres::TinySolverAutoDiffFunction<NodeResiduals<Form>, node_count, Form::size> function(all);
  ceres::TinySolver<decltype(function)> tiny;
  if (way.tolerance == Tolerance::tight) {
    tiny.options.gradient_tolerance = tiny.options.parameter_tolerance = 1e-16;
    tiny.options.function_tolerance = tiny.options.cost_threshold = 0;
    tiny.options.max_num_iterations = 200;
  }
  Eigen::Matrix<double, Form::size, 1> p;
  for (std::size_t i = 0; i < N; ++i) p[static_cast<Eigen::Index>(i)] = start[i];
  tiny.Solve(function, &p);
  std::array<double, N> found;
  for (std::size_t i = 0; i < N; ++i) found[i] = p[static_cast<Eigen::Index>(i)];
  if (found == start) answer.remark("TinySolver returned its start");
  return found;
}

Answer pair(const Way& way) {
  Answer answer;
  const auto target = [](double c) { return std::pow(1 - c, 5); };
  const auto p = way.method == Method::tutorial
                     ? tutorial<Pair>({-5, -5}, 0, 1, false, target, way.tolerance, answer)
                     : on_nodes<Pair>({-5, -5}, 0, 1, false, target, way, answer);
  answer.add("a", p[0]);
  answer.add("b", p[1]);
  return answer;
}

Answer gaussians(const Way& way, const std::vector<double>& exponents) {
  Answer answer;
  for (const double k : exponents) {
    const auto in_c = [k](double c) { return std::pow(c, k); };
    const auto in_t = [k](double t) { return std::exp(k * std::log1p(-t / k)); };
    const auto p = way.method == Method::tutorial
                       ? tutorial<GaussianInC>({0.5}, k, 1, false, in_c, way.tolerance, answer)
                       : on_nodes<GaussianInT>({0.5}, k, std::min(k, 24.0), false, in_t, way, answer);
    answer.add("x", p[0], k);
  }
  return answer;
}

Answer blinns(const Way& way) {
  Answer answer;
  for (double rho = 2; rho <= 2048; rho *= 2) {
    const auto target = [rho](double angle) { return std::pow(std::max(std::cos(angle), 0.0), rho); };
    const auto p =
        way.method == Method::tutorial
            ? tutorial<Blinn>({3}, rho, M_PI_2, true, target, way.tolerance, answer)
            : on_nodes<Blinn>({3}, rho, std::min(M_PI_2, 9 / std::sqrt(rho)), true, target, way, answer);
    answer.add("x", p[0], rho);
  }
  return answer;
}

}  // namespace

int main(int argc, char** argv) {
  google::InitGoogleLogging(argv[0]);
  FLAGS_minloglevel = 3;  // the answers contain the warnings of Ceres
  const std::vector<double> sweep{3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}, large{100, 1e3, 1e4, 1e6};
  const std::vector<Way> ways{
      {Method::tutorial, Tolerance::usual, "1001 AutoDiff blocks, DENSE_QR, default"},
      {Method::tutorial, Tolerance::tight, "1001 AutoDiff blocks, DENSE_QR, tight"},
      {Method::nodes, Tolerance::usual, "64 Gauss-Legendre nodes in one residual, default"},
      {Method::nodes, Tolerance::tight, "64 Gauss-Legendre nodes in one residual, tight"},
      {Method::tiny, Tolerance::usual, "TinySolver, 64 Gauss-Legendre nodes, default"},
      {Method::tiny, Tolerance::tight, "TinySolver, 64 Gauss-Legendre nodes, tight"}};
  std::vector<Variant> variants;
  for (const Way& way : ways) {
    const Standing standing = way.method == Method::tutorial ? Standing::judged : Standing::listed;
    variants.push_back({"T1", way.name, standing, [way] { return pair(way); }});
    variants.push_back({"T2", way.name, standing, [way, sweep] { return gaussians(way, sweep); }});
    variants.push_back({"T2-large", way.name, standing, [way, large] { return gaussians(way, large); }});
    variants.push_back({"T3", way.name, standing, [way] { return blinns(way); }});
  }
  return peer_tasks::run_program(argc, argv, std::string("Ceres ") + CERES_VERSION_STRING, variants);
}
