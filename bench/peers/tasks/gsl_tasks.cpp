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

#include "sampled_tasks.hpp"

namespace {

using peer_tasks::SampledFit;
using peer_tasks::Task;
using Function = std::function<double(double)>;

template <class Form>
int residuals(const gsl_vector* p, void* context, gsl_vector* f) {
  const SampledFit& fit = *static_cast<const SampledFit*>(context);
  for (int i = 0; i < peer_tasks::samples; ++i) {
    const double at = fit.place(i), off = Form::value(at, p->data, fit.exponent) - fit.target(at);
    gsl_vector_set(f, static_cast<std::size_t>(i), std::sqrt(fit.weight(at)) * off);
  }
  return GSL_SUCCESS;
}

template <class Form>
std::vector<double> multifit(SampledFit fit) {
  std::vector<double> p = fit.start;
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_fdf fdf{};
  fdf.f = residuals<Form>;
  fdf.n = peer_tasks::samples;
  fdf.p = p.size();
  fdf.params = &fit;
  gsl_multifit_nlinear_workspace* w =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, fdf.n, fdf.p);
  const gsl_vector_view view = gsl_vector_view_array(p.data(), p.size());
  gsl_multifit_nlinear_init(&view.vector, &fdf, w);
  int info = 0;
  gsl_multifit_nlinear_driver(100, 1e-8, 1e-8, 0, nullptr, nullptr, &info, w);
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = gsl_vector_get(w->x, i);
  gsl_multifit_nlinear_free(w);
  return p;
}

double call(double x, void* f) {
  return (*static_cast<Function*>(f))(x);
}

/// By the adaptive rule of 61 points, in t = k (1 - c), cut at 24.
double integral_of(Function f, double exponent) {
  static gsl_integration_workspace* const workspace = gsl_integration_workspace_alloc(1000);
  gsl_function g{call, &f};
  double value = 0, error = 0;
  gsl_integration_qag(&g, 0, std::min(exponent, 24.0), 1e-17, 1e-13, 1000, GSL_INTEG_GAUSS61, workspace,
                      &value, &error);
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

// The gradients are derived by hand.

double gaussian_by_root(double k) {
  const auto gradient = [k](double x) {
    const auto slope = [=](double t) {
      const double form = std::exp(-(k + x) * t / k);
      return (form - std::exp(k * std::log1p(-t / k))) * form * t;
    };
    return integral_of(slope, k);
  };
  return brent_root(gradient, 0, 2);
}

double blinn_by_root(double rho) {
  const auto gradient = [rho](double x) {
    const auto slope = [=](double t) {
      const double half = std::log1p(-t / (2 * rho)), form = std::exp(x * rho / 2 * half);
      return (form - std::exp(rho * std::log1p(-t / rho))) * form * half;
    };
    return integral_of(slope, rho);
  };
  return brent_root(gradient, 3, 6);
}

}  // namespace

int main(int argc, char** argv) {
  gsl_set_error_handler_off();
  using namespace peer_tasks;
  std::vector<Task> tasks = sampled_tasks(
      "multifit, 1001 samples", []<class Form>(Form, const SampledFit& fit) { return multifit<Form>(fit); });
  const std::string root = "Brent root of the qag gradient in t (by an expert)";
  tasks.push_back({"T2", root, [] { return at_each(gaussian_exponents, gaussian_by_root); }});
  tasks.push_back({"T2-large", root, [] { return at_each(large_exponents, gaussian_by_root); }});
  tasks.push_back({"T3", root, [] { return at_each(blinn_exponents, blinn_by_root); }});
  return run_all(argc, argv, tasks);
}
