// Reference values of one-parameter fits that have no power series of their own: the Phong lobe by a Blinn
// lobe, and fits on a part of the domain.
//
// shadefit samples robust rearrangements at Gauss-Legendre nodes; here the plain difference of form and
// target is integrated by tanh-sinh in 55 digits, panel by panel, and the gradient's root is found by the
// secant method.
//
//   make_integral_references            prints integrals.csv
//   make_integral_references --check F  compares F with what it computes; exit 1 where a digit differs
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "print_or_check.hpp"

namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<55>, boost::multiprecision::et_off>;

struct Metric {
  const char* measure;
  const char* lower;
  const char* upper;
};

// Form and target at c for the parameter x, and the form's derivative by x.
struct Errors {
  Real error, slope;
};
using Family = std::function<Errors(const Real& c, const Real& x)>;

Family sg_offset(const Real& k) {
  return [k](const Real& c, const Real& x) {
    const Real form = exp((k + x) * (c - 1));
    return Errors{form - pow(c, k), form * (c - 1)};
  };
}

Family phong_blinn(const Real& rho) {
  return [rho](const Real& c, const Real& x) {
    const Real half = log((1 + c) / 2) / 2;
    const Real form = exp(x * rho * half);
    return Errors{form - pow(c, rho), form * rho * half};
  };
}

Family fresnel_one_term() {
  return [](const Real& c, const Real& a) {
    const Real ln2 = boost::math::constants::ln_two<Real>();
    const Real form = exp(-a * ln2 * c);
    return Errors{form - pow(1 - c, 5), -form * ln2 * c};
  };
}

// The integral of measure * error * slope: the gradient of the least-squares objective, up to a factor 2.
// Panels end at 1 - c = 1, 10, 100 over k, beyond which a lobe of exponent k has fallen to e^-100; in the
// angle measure the variable is the angle.
Real gradient(const Family& family, const Metric& metric, const Real& k, const Real& x) {
  static boost::math::quadrature::tanh_sinh<Real> rule(9);
  const std::string measure = metric.measure;
  const bool is_angle = measure == "angle";
  const Real top = 1 - Real(metric.upper), bottom = 1 - Real(metric.lower);
  std::vector<Real> ends{top};
  for (const char* t : {"1", "10", "100"}) {
    const Real y = top + Real(t) / k;
    if (y < bottom) ends.push_back(y);
  }
  if (top + 100 / k >= bottom) ends.push_back(bottom);
  const auto variable = [&](const Real& y) { return is_angle ? Real(acos(Real(1 - y))) : y; };
  const auto integrand = [&](const Real& v) {
    const Real c = is_angle ? Real(cos(v)) : Real(1 - v);
    if (c <= 0) return Real(0);
    const Errors e = family(c, x);
    return Real(e.error * e.slope * (measure == "cosine-weighted" ? c : Real(1)));
  };
  Real sum = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const Real from = variable(ends[i]), length = variable(ends[i + 1]) - from;
    sum += length * rule.integrate([&](const Real& s) { return integrand(from + length * s); }, Real(0),
                                   Real(1), Real("1e-34"));
  }
  return sum;
}

Real best(const Family& family, const Metric& metric, const Real& k, Real x0) {
  Real x1 = x0 * Real("1.01");
  Real g0 = gradient(family, metric, k, x0), g1 = gradient(family, metric, k, x1);
  for (int i = 0; i < 60 && abs(x1 - x0) > abs(x1) * Real("1e-30"); ++i) {
    const Real x2 = x1 - g1 * (x1 - x0) / (g1 - g0);
    x0 = x1, g0 = g1;
    x1 = x2, g1 = gradient(family, metric, k, x2);
  }
  return x1;
}

void write_references(std::ostream& out) {
  out.precision(25);
  out << "constant,parameter,exponent,measure,domain,value\n";
  const auto row = [&](const char* constant, const char* parameter, const std::string& exponent,
                       const Metric& metric, const Real& value) {
    out << constant << ',' << parameter << ',' << exponent << ',' << metric.measure << ',' << metric.lower
        << ':' << metric.upper << ',' << value << '\n';
  };
  for (const char* measure : {"cosine", "angle", "cosine-weighted"}) {
    const Metric whole{measure, "0", "1"};
    for (const char* rho :
         {"0.1", "0.5", "1", "2", "2.5", "4", "7.3", "8", "16", "23.9", "64", "333.3", "2048", "1000000"}) {
      row("phong-blinn", "x", rho, whole, best(phong_blinn(Real(rho)), whole, Real(rho), Real("4.5")));
    }
    // The other powers of two up to 2048, which bench/peers/run sweeps.
    if (whole.measure == std::string("cosine")) {
      for (const char* rho : {"32", "128", "256", "512", "1024"})
        row("phong-blinn", "x", rho, whole, best(phong_blinn(Real(rho)), whole, Real(rho), Real("4.5")));
    }
    const Metric upper{measure, "0.25", "1"}, middle{measure, "0.5", "0.875"};
    for (const char* k : {"0.5", "5", "100"}) {
      row("sg-offset", "x", k, upper, best(sg_offset(Real(k)), upper, Real(k), Real("0.7")));
    }
    row("sg-offset", "x", "5", middle, best(sg_offset(5), middle, 5, Real("0.7")));
    row("fresnel-one-term", "A", "", upper, best(fresnel_one_term(), upper, 1, Real(8)));
  }
}

}  // namespace

int main(int argc, char** argv) {
  return shadefit::references::print_or_check(argc, argv, write_references);
}
