// The tasks of bench/peers/run with the GNU Scientific Library, by the examples of its manual: nonlinear
// least squares on samples, roots of an integrated gradient.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "task_program.hpp"

namespace {

using peer_tasks::Answer;
using peer_tasks::Task;
using Function = std::function<double(double)>;

constexpr std::size_t samples = 1001;

double place(std::size_t i) {
  return static_cast<double>(i) / (samples - 1);
}

/// A fit to samples: of the form at a place with these parameters.
struct Fit {
  double end;
  std::function<double(double at, const double* p)> form;
  Function target, weight;
};

int residuals(const gsl_vector* p, void* context, gsl_vector* f) {
  const Fit& fit = *static_cast<const Fit*>(context);
  for (std::size_t i = 0; i < samples; ++i) {
    const double at = fit.end * place(i);
    gsl_vector_set(f, i, std::sqrt(fit.weight(at)) * (fit.form(at, p->data) - fit.target(at)));
  }
  return GSL_SUCCESS;
}

std::vector<double> multifit(Fit fit, std::vector<double> start) {
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_fdf fdf{};
  fdf.f = residuals;
  fdf.n = samples;
  fdf.p = start.size();
  fdf.params = &fit;
  gsl_multifit_nlinear_workspace* w =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, fdf.n, fdf.p);
  const gsl_vector_view view = gsl_vector_view_array(start.data(), start.size());
  gsl_multifit_nlinear_init(&view.vector, &fdf, w);
  int info = 0;
  gsl_multifit_nlinear_driver(100, 1e-8, 1e-8, 0, nullptr, nullptr, &info, w);
  for (std::size_t i = 0; i < start.size(); ++i) start[i] = gsl_vector_get(w->x, i);
  gsl_multifit_nlinear_free(w);
  return start;
}

double call(double x, void* f) {
  return (*static_cast<Function*>(f))(x);
}

/// By the adaptive rule of 61 points.
double integral_of(Function f, double end, double absolute, double relative) {
  static gsl_integration_workspace* const workspace = gsl_integration_workspace_alloc(1000);
  gsl_function g{call, &f};
  double value = 0, error = 0;
  gsl_integration_qag(&g, 0, end, absolute, relative, 1000, GSL_INTEG_GAUSS61, workspace, &value, &error);
  return value;
}

double brent_root(Function f, double low, double high) {
  gsl_function g{call, &f};
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

double schlick(double c) {
  return std::pow(1 - c, 5);
}
double pair(double c, const double* p) {
  return std::exp2((p[0] * c + p[1]) * c);
}
double evenly(double) {
  return 1;
}

Answer pair_by_samples() {
  const auto p = multifit({1, pair, schlick, evenly}, {-5, -5});
  return {{"a", p[0]}, {"b", p[1]}};
}

Answer gaussians_by_samples(const std::vector<double>& exponents) {
  Answer answer;
  for (const double k : exponents) {
    const auto form = [k](double c, const double* p) { return std::exp((k + p[0]) * (c - 1)); };
    answer.push_back(
        {"x", multifit({1, form, [k](double c) { return std::pow(c, k); }, evenly}, {0.5})[0], k});
  }
  return answer;
}

/// The gradient is derived by hand, in t = k (1 - c), and cut at 24.
Answer gaussians_by_root(const std::vector<double>& exponents) {
  Answer answer;
  for (const double k : exponents) {
    const auto gradient = [k](double x) {
      const auto slope = [=](double t) {
        const double form = std::exp(-(k + x) * t / k);
        return (form - std::exp(k * std::log1p(-t / k))) * form * t;
      };
      return integral_of(slope, std::min(k, 24.0), 1e-17, 1e-13);
    };
    answer.push_back({"x", brent_root(gradient, 0, 2), k});
  }
  return answer;
}

Answer blinns(bool by_root) {
  Answer answer;
  for (double rho = 2; rho <= 2048; rho *= 2) {
    if (by_root) {
      const auto gradient = [rho](double x) {
        const auto slope = [=](double t) {
          const double half = std::log1p(-t / (2 * rho)), form = std::exp(x * rho / 2 * half);
          return (form - std::exp(rho * std::log1p(-t / rho))) * form * half;
        };
        return integral_of(slope, std::min(rho, 24.0), 1e-17, 1e-13);
      };
      answer.push_back({"x", brent_root(gradient, 3, 6), rho});
    } else {
      const auto form = [rho](double t, const double* p) { return std::pow(std::cos(t / 2), p[0] * rho); };
      const auto target = [rho](double t) { return std::pow(std::max(std::cos(t), 0.0), rho); };
      answer.push_back(
          {"x", multifit({M_PI_2, form, target, [](double t) { return std::sin(t); }}, {3})[0], rho});
    }
  }
  return answer;
}

}  // namespace

int main(int argc, char** argv) {
  gsl_set_error_handler_off();
  std::vector<double> sweep;
  for (int k = 3; k <= 15; ++k) sweep.push_back(k);
  const std::vector<double> large{100, 1e3, 1e4, 1e6};
  const std::string fit = "multifit, 1001 samples",
                    root = "Brent root of the qag gradient in t (by an expert)";
  const std::vector<Task> tasks{{"T1", fit, pair_by_samples},
                                {"T2", fit, [=] { return gaussians_by_samples(sweep); }},
                                {"T2", root, [=] { return gaussians_by_root(sweep); }},
                                {"T2-large", fit, [=] { return gaussians_by_samples(large); }},
                                {"T2-large", root, [=] { return gaussians_by_root(large); }},
                                {"T3", fit, [] { return blinns(false); }},
                                {"T3", root, [] { return blinns(true); }}};
  return peer_tasks::run_all(argc, argv, tasks);
}
