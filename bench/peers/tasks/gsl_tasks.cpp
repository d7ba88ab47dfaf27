// The tasks of bench/peers/run with the GNU Scientific Library, by the examples of its manual: nonlinear
// least squares on samples, minimisers, quadrature, roots.
#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_multimin.h>
#include <gsl/gsl_multiroots.h>
#include <gsl/gsl_roots.h>
#include <gsl/gsl_version.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "approx/fresnel.hpp"
#include "task_program.hpp"

namespace {

using peer_tasks::Answer;
using peer_tasks::Standing;
using peer_tasks::Variant;

constexpr std::size_t samples = 1001;

// ---- least squares -------------------------------------------------------------------------------------

/// Places, square roots of weights, and the data of a fit.
struct Data {
  std::vector<double> at, root_weight, target;
  double exponent = 0;
};

/// The forms: value and derivatives by the parameters.
struct Pair {
  static constexpr std::size_t size = 2;
  static double value(double c, const double* p, double) { return std::exp2((p[0] * c + p[1]) * c); }
  static void slopes(double c, double value, double, double* d) {
    d[0] = value * M_LN2 * c * c;
    d[1] = value * M_LN2 * c;
  }
};

struct GaussianInC {
  static constexpr std::size_t size = 1;
  static double value(double c, const double* p, double k) { return std::exp((k + p[0]) * (c - 1)); }
  static void slopes(double c, double value, double, double* d) { d[0] = value * (c - 1); }
};

/// The same over t = k (1 - c).
struct GaussianInT {
  static constexpr std::size_t size = 1;
  static double value(double t, const double* p, double k) { return std::exp(-(k + p[0]) * t / k); }
  static void slopes(double t, double value, double k, double* d) { d[0] = -value * t / k; }
};

struct Blinn {
  static constexpr std::size_t size = 1;
  static double value(double angle, const double* p, double rho) {
    return std::pow(std::cos(angle / 2), p[0] * rho);
  }
  static void slopes(double angle, double value, double rho, double* d) {
    d[0] = value * rho * std::log(std::cos(angle / 2));
  }
};

template <class Form>
int residuals(const gsl_vector* p, void* context, gsl_vector* f) {
  const Data& data = *static_cast<const Data*>(context);
  for (std::size_t i = 0; i < data.at.size(); ++i) {
    const double form = Form::value(data.at[i], p->data, data.exponent);
    gsl_vector_set(f, i, data.root_weight[i] * (form - data.target[i]));
  }
  return GSL_SUCCESS;
}

template <class Form>
int jacobian(const gsl_vector* p, void* context, gsl_matrix* j) {
  const Data& data = *static_cast<const Data*>(context);
  double slopes[Form::size];
  for (std::size_t i = 0; i < data.at.size(); ++i) {
    const double form = Form::value(data.at[i], p->data, data.exponent);
    Form::slopes(data.at[i], form, data.exponent, slopes);
    for (std::size_t n = 0; n < Form::size; ++n) gsl_matrix_set(j, i, n, data.root_weight[i] * slopes[n]);
  }
  return GSL_SUCCESS;
}

enum class Derivatives { differences, exact };

struct Tolerances {
  double x, gradient, function;
};
constexpr Tolerances usual{1e-8, 1e-8, 0}, tight{1e-16, 1e-16, 0};

template <class Form>
std::array<double, Form::size> multifit(const Data& data, std::array<double, Form::size> start,
                                        Derivatives derivatives, Tolerances tolerances, Answer& answer) {
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_fdf fdf{};
  fdf.f = residuals<Form>;
  fdf.df = derivatives == Derivatives::exact ? jacobian<Form> : nullptr;
  fdf.n = data.at.size();
  fdf.p = Form::size;
  fdf.params = const_cast<Data*>(&data);
  gsl_multifit_nlinear_workspace* w =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, fdf.n, fdf.p);
  const gsl_vector_view view = gsl_vector_view_array(start.data(), Form::size);
  gsl_multifit_nlinear_init(&view.vector, &fdf, w);
  int info = 0;
  const int status = gsl_multifit_nlinear_driver(100, tolerances.x, tolerances.gradient, tolerances.function,
                                                 nullptr, nullptr, &info, w);
  std::array<double, Form::size> found;
  for (std::size_t n = 0; n < Form::size; ++n) found[n] = gsl_vector_get(w->x, n);
  gsl_multifit_nlinear_free(w);
  if (found == start) answer.remark(std::string("returned its start, status: ") + gsl_strerror(status));
  return found;
}

Data even(double from, double to) {
  Data data;
  for (std::size_t i = 0; i < samples; ++i)
    data.at.push_back(from + (to - from) * static_cast<double>(i) / (samples - 1));
  data.root_weight.assign(samples, 1);
  return data;
}

Data nodes(double from, double to) {
  constexpr std::size_t count = 64;
  gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(count);
  Data data;
  for (std::size_t i = 0; i < count; ++i) {
    double at, weight;
    gsl_integration_glfixed_point(from, to, i, &at, &weight, table);
    data.at.push_back(at);
    data.root_weight.push_back(std::sqrt(weight));
  }
  gsl_integration_glfixed_table_free(table);
  return data;
}

Answer pair(Data data, Derivatives derivatives, Tolerances tolerances) {
  for (const double c : data.at) data.target.push_back(std::pow(1 - c, 5));
  Answer answer;
  const auto p = multifit<Pair>(data, {-5, -5}, derivatives, tolerances, answer);
  answer.add("a", p[0]);
  answer.add("b", p[1]);
  return answer;
}

const std::vector<double> sweep{3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}, large{100, 1e3, 1e4, 1e6},
    powers{2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048};

Answer gaussians_in_c(const std::vector<double>& exponents) {
  Answer answer;
  for (const double k : exponents) {
    Data data = even(0, 1);
    data.exponent = k;
    for (const double c : data.at) data.target.push_back(std::pow(c, k));
    answer.add("x", multifit<GaussianInC>(data, {0.5}, Derivatives::exact, usual, answer)[0], k);
  }
  return answer;
}

Answer gaussians_in_t(const std::vector<double>& exponents) {
  Answer answer;
  for (const double k : exponents) {
    Data data = nodes(0, std::min(k, 24.0));
    data.exponent = k;
    for (const double t : data.at) data.target.push_back(std::exp(k * std::log1p(-t / k)));
    answer.add("x", multifit<GaussianInT>(data, {0.5}, Derivatives::exact, tight, answer)[0], k);
  }
  return answer;
}

Answer blinns(bool on_nodes) {
  Answer answer;
  for (const double rho : powers) {
    Data data = on_nodes ? nodes(0, std::min(M_PI_2, 9 / std::sqrt(rho))) : even(0, M_PI_2);
    data.exponent = rho;
    for (std::size_t i = 0; i < data.at.size(); ++i) {
      data.root_weight[i] *= std::sqrt(std::sin(data.at[i]));
      data.target.push_back(std::pow(std::max(std::cos(data.at[i]), 0.0), rho));
    }
    answer.add("x", multifit<Blinn>(data, {3}, Derivatives::exact, on_nodes ? tight : usual, answer)[0], rho);
  }
  return answer;
}

// ---- roots of an integrated gradient ---------------------------------------------------------------------

using Workspace = std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)>;

Workspace new_workspace() {
  return {gsl_integration_workspace_alloc(1000), gsl_integration_workspace_free};
}

template <class F>
double call(double x, void* f) {
  return (*static_cast<F*>(f))(x);
}

/// The adaptive rules: of 21 points, for singularities at the ends too, or of 61 points.
enum class Rule { qags, qag61 };

template <class F>
double integral_of(Rule rule, F f, double from, double to, double absolute, double relative,
                   const Workspace& workspace) {
  gsl_function g{call<F>, &f};
  double value = 0, error = 0;
  if (rule == Rule::qags)
    gsl_integration_qags(&g, from, to, absolute, relative, 1000, workspace.get(), &value, &error);
  else
    gsl_integration_qag(&g, from, to, absolute, relative, 1000, GSL_INTEG_GAUSS61, workspace.get(), &value,
                        &error);
  return value;
}

int pair_gradient(const gsl_vector* p, void* context, gsl_vector* f) {
  const Workspace& workspace = *static_cast<const Workspace*>(context);
  const double a = gsl_vector_get(p, 0), b = gsl_vector_get(p, 1);
  for (int power = 1; power <= 2; ++power) {
    const auto slope = [=](double c) {
      const double form = std::exp2((a * c + b) * c), rest = 1 - c;
      return (form - rest * rest * rest * rest * rest) * form * (power == 2 ? c * c : c);
    };
    gsl_vector_set(f, static_cast<std::size_t>(2 - power),
                   integral_of(Rule::qag61, slope, 0, 1, 1e-17, 1e-13, workspace));
  }
  return GSL_SUCCESS;
}

Answer pair_by_root() {
  const Workspace workspace = new_workspace();
  gsl_multiroot_function f{pair_gradient, 2, const_cast<Workspace*>(&workspace)};
  gsl_multiroot_fsolver* solver = gsl_multiroot_fsolver_alloc(gsl_multiroot_fsolver_hybrids, 2);
  double start[2] = {-5, -5};
  const gsl_vector_view view = gsl_vector_view_array(start, 2);
  gsl_multiroot_fsolver_set(solver, &f, &view.vector);
  int status = GSL_CONTINUE;
  for (int i = 0; i < 100 && status == GSL_CONTINUE; ++i) {
    if (gsl_multiroot_fsolver_iterate(solver) != GSL_SUCCESS) break;
    status = gsl_multiroot_test_delta(solver->dx, solver->x, 0, 1e-15);
  }
  Answer answer;
  answer.add("a", gsl_vector_get(solver->x, 0));
  answer.add("b", gsl_vector_get(solver->x, 1));
  gsl_multiroot_fsolver_free(solver);
  return answer;
}

template <class F>
double brent_root(F f, double low, double high) {
  gsl_function g{call<F>, &f};
  gsl_root_fsolver* solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
  gsl_root_fsolver_set(solver, &g, low, high);
  int status = GSL_CONTINUE;
  for (int i = 0; i < 100 && status == GSL_CONTINUE; ++i) {
    gsl_root_fsolver_iterate(solver);
    status =
        gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver), 0, 4e-16);
  }
  const double root = gsl_root_fsolver_root(solver);
  gsl_root_fsolver_free(solver);
  return root;
}

Answer gaussians_by_root(const std::vector<double>& exponents) {
  Answer answer;
  const Workspace workspace = new_workspace();
  for (const double k : exponents) {
    const auto gradient = [&](double x) {
      const auto slope = [=](double t) {
        const double form = std::exp(-(k + x) * t / k);
        return (form - std::exp(k * std::log1p(-t / k))) * form * t;
      };
      return integral_of(Rule::qag61, slope, 0, std::min(k, 24.0), 1e-17, 1e-13, workspace);
    };
    answer.add("x", brent_root(gradient, 0, 2), k);
  }
  return answer;
}

Answer blinns_by_root() {
  Answer answer;
  const Workspace workspace = new_workspace();
  for (const double rho : powers) {
    const auto gradient = [&](double x) {
      const auto slope = [=](double t) {
        const double half = std::log1p(-t / (2 * rho)), form = std::exp(x * rho / 2 * half);
        return (form - std::exp(rho * std::log1p(-t / rho))) * form * half;
      };
      return integral_of(Rule::qag61, slope, 0, std::min(rho, 24.0), 1e-17, 1e-13, workspace);
    };
    answer.add("x", brent_root(gradient, 3, 6), rho);
  }
  return answer;
}

// ---- minimax and the largest error ------------------------------------------------------------------------

double pair_error(double c, double a, double b) {
  return std::exp2((a * c + b) * c) - std::pow(1 - c, 5);
}

std::array<double, 2> published_pair() {
  return {shadefit::constant<double>(shadefit::fresnel_published[2].printed),
          shadefit::constant<double>(shadefit::fresnel_published[3].printed)};
}

double largest(const gsl_vector* p, void* is_relative) {
  double most = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const double c = static_cast<double>(i) / (samples - 1);
    double error = std::abs(pair_error(c, gsl_vector_get(p, 0), gsl_vector_get(p, 1)));
    if (*static_cast<bool*>(is_relative)) error *= 0.96 / (0.04 + 0.96 * std::pow(1 - c, 5));
    most = std::max(most, error);
  }
  return most;
}

Answer minimax(bool is_relative) {
  gsl_multimin_function f{largest, 2, &is_relative};
  std::array<double, 2> start = published_pair();
  double steps[2] = {0.1, 0.1};
  const gsl_vector_view from = gsl_vector_view_array(start.data(), 2), by = gsl_vector_view_array(steps, 2);
  gsl_multimin_fminimizer* solver = gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, 2);
  gsl_multimin_fminimizer_set(solver, &f, &from.vector, &by.vector);
  for (int i = 0; i < 500; ++i) {
    if (gsl_multimin_fminimizer_iterate(solver) != GSL_SUCCESS) break;
    if (gsl_multimin_test_size(gsl_multimin_fminimizer_size(solver), 1e-8) == GSL_SUCCESS) break;
  }
  Answer answer;
  answer.add("a", gsl_vector_get(solver->x, 0));
  answer.add("b", gsl_vector_get(solver->x, 1));
  gsl_multimin_fminimizer_free(solver);
  return answer;
}

Answer largest_error() {
  std::size_t best = 1;
  const std::array<double, 2> p = published_pair();
  const auto error = [p](double c) { return -std::abs(pair_error(c, p[0], p[1])); };
  const auto place = [](std::size_t i) { return static_cast<double>(i) / (samples - 1); };
  for (std::size_t i = 1; i + 1 < samples; ++i) {
    if (error(place(i)) < error(place(best))) best = i;
  }
  gsl_function f{call<decltype(error)>, const_cast<void*>(static_cast<const void*>(&error))};
  gsl_min_fminimizer* solver = gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
  gsl_min_fminimizer_set(solver, &f, place(best), place(best - 1), place(best + 1));
  int status = GSL_CONTINUE;
  for (int i = 0; i < 100 && status == GSL_CONTINUE; ++i) {
    gsl_min_fminimizer_iterate(solver);
    status = gsl_min_test_interval(gsl_min_fminimizer_x_lower(solver), gsl_min_fminimizer_x_upper(solver), 0,
                                   1e-8);
  }
  Answer answer;
  answer.add("level", -gsl_min_fminimizer_f_minimum(solver));
  gsl_min_fminimizer_free(solver);
  return answer;
}

// ---- normalisation ----------------------------------------------------------------------------------------

Answer constants(Rule rule, bool in_angle) {
  Answer answer;
  const Workspace workspace = new_workspace();
  const auto integrate = [&](const char* name, double n, const auto& lobe) {
    const auto over_angle = [&](double angle) { return lobe(std::cos(angle)) * std::sin(angle); };
    const double integral = in_angle ? integral_of(rule, over_angle, 0, M_PI_2, 0, 1e-12, workspace)
                                     : integral_of(rule, lobe, 0, 1, 0, 1e-12, workspace);
    answer.add(name, 1 / (2 * M_PI * integral), n);
    if (integral == 0) answer.remark("integral 0");
  };
  for (const double n : {0.1, 1.0, 2.0, 8.0, 64.0, 2048.0, 1e5, 1e6}) {
    integrate("norm-phong", n, [n](double c) { return std::pow(c, n); });
    integrate("norm-phong-brdf", n, [n](double c) { return std::pow(c, n) * c; });
    integrate("norm-blinn-phong", n, [n](double c) { return std::pow((1 + c) / 2, n / 2); });
    integrate("norm-blinn-phong-brdf", n, [n](double c) { return std::pow((1 + c) / 2, n / 2) * c; });
  }
  return answer;
}

}  // namespace

int main(int argc, char** argv) {
  gsl_set_error_handler_off();
  const std::vector<Variant> variants{
      {"T1", "multifit, 1001 samples, finite differences", Standing::judged,
       [] { return pair(even(0, 1), Derivatives::differences, usual); }},
      {"T1", "multifit, 1001 samples, own derivatives", Standing::judged,
       [] { return pair(even(0, 1), Derivatives::exact, usual); }},
      {"T1", "multifit, 64 Gauss-Legendre nodes, tight", Standing::expert,
       [] { return pair(nodes(0, 1), Derivatives::exact, tight); }},
      {"T1", "multiroot hybrids on the qag gradient (expert)", Standing::expert, pair_by_root},
      {"T2", "multifit, 1001 samples, own derivatives", Standing::judged,
       [] { return gaussians_in_c(sweep); }},
      {"T2", "multifit, 64 nodes in t, tight", Standing::expert, [] { return gaussians_in_t(sweep); }},
      {"T2", "Brent root of the qag gradient in t (expert)", Standing::expert,
       [] { return gaussians_by_root(sweep); }},
      {"T2-large", "multifit, 1001 samples, own derivatives", Standing::judged,
       [] { return gaussians_in_c(large); }},
      {"T2-large", "multifit, 64 nodes in t, tight", Standing::expert, [] { return gaussians_in_t(large); }},
      {"T2-large", "Brent root of the qag gradient in t (expert)", Standing::expert,
       [] { return gaussians_by_root(large); }},
      {"T3", "multifit, 1001 samples, own derivatives", Standing::judged, [] { return blinns(false); }},
      {"T3", "multifit, 64 nodes in the angle, tight", Standing::expert, [] { return blinns(true); }},
      {"T3", "Brent root of the qag gradient in t (expert)", Standing::expert, blinns_by_root},
      {"T4-absolute", "nmsimplex2 on the largest of 1001 samples", Standing::judged,
       [] { return minimax(false); }},
      {"T4-relative", "nmsimplex2 on the largest of 1001 samples", Standing::judged,
       [] { return minimax(true); }},
      {"T5", "grid of 1001, min_fminimizer_brent", Standing::judged, largest_error},
      {"T6", "qags in the angle", Standing::judged, [] { return constants(Rule::qags, true); }},
      {"T6", "qags in the cosine", Standing::judged, [] { return constants(Rule::qags, false); }},
      {"T6", "qag61 in the angle", Standing::judged, [] { return constants(Rule::qag61, true); }},
      {"T6", "qag61 in the cosine", Standing::judged, [] { return constants(Rule::qag61, false); }}};
  return peer_tasks::run_program(argc, argv, std::string("GSL ") + gsl_version, variants);
}
