// The reference values of the fits, by a method that shares nothing with the toolkit.
//
// shadefit samples the integrals at quadrature nodes; here they are summed as power series. With the moments
//   I(m) = integral of c^m over the measure on [0, 1] = 1/(m+1)                                   (cosine)
//                                                     = sqrt(pi)/2 Gamma((m+1)/2) / Gamma(m/2+1)  (angle)
//                                                     = 1/(m+2) (cosine-weighted)
// an integral of c^m h(c) is the sum of h_n I(m + n) over the Taylor coefficients h_n of h. Every gradient of
// the families is a combination of such integrals; its root is found in 100 digits and printed to 50.
//
//   make_references            prints fits.csv
//   make_references --check F  compares F with what it computes; exit 1 where a digit differs
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "print_or_check.hpp"

namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

enum class Measure { cosine, angle, cosine_weighted };

Real moment(Measure measure, const Real& m) {
  if (measure == Measure::cosine) return 1 / (m + 1);
  if (measure == Measure::cosine_weighted) return 1 / (m + 2);
  using boost::math::lgamma;
  return sqrt(boost::math::constants::pi<Real>()) / 2 *
         exp(lgamma(Real((m + 1) / 2)) - lgamma(Real(m / 2 + 1)));
}

// Moments I(m), I(m+1), .. in order: I(m+2) = I(m) (m+1)/(m+2) in the angle.
class Moments {
 public:
  Moments(Measure measure, const Real& m)
      : measure_(measure), m_(m), now_(moment(measure, m)), next_(moment(measure, m + 1)) {}
  const Real& value() const { return now_; }
  void advance() {
    const Real after =
        measure_ == Measure::angle ? Real(now_ * (m_ + 1) / (m_ + 2)) : moment(measure_, m_ + 2);
    now_ = next_;
    next_ = after;
    m_ += 1;
  }

 private:
  Measure measure_;
  Real m_, now_, next_;
};

// Integral of c^m exp(s (c - 1)) = sum over j of e^-s s^j/j! I(m + j): Poisson weights, all positive. They
// are summed where they exceed 1e-105 of their peak: within 24 standard deviations, and 400 for small s.
Real lobe_integral(Measure measure, const Real& m, const Real& s) {
  const Real spread = 24 * sqrt(s) + 400;
  const Real first = s > spread ? Real(floor(s - spread)) : Real(0);
  Real weight = exp(first * log(s) - s - boost::math::lgamma(Real(first + 1)));
  Moments moments(measure, m + first);
  Real sum = 0;
  for (Real j = first; j <= s + spread; j += 1) {
    sum += weight * moments.value();
    weight *= s / (j + 1);
    moments.advance();
  }
  return sum;
}

// Half the derivative of the integral of (exp(a(c-1)) - c^k)^2 by a = k + x.
Real offset_gradient(Measure measure, const Real& k, const Real& x) {
  const Real a = k + x;
  return lobe_integral(measure, 1, 2 * a) - lobe_integral(measure, 0, 2 * a) -
         lobe_integral(measure, k + 1, a) + lobe_integral(measure, k, a);
}

Real best_offset(Measure measure, const Real& k) {
  Real x0 = k < 1 ? Real(k * Real("0.9")) : Real("0.7"), x1 = x0 * Real("1.05");
  Real g0 = offset_gradient(measure, k, x0), g1 = offset_gradient(measure, k, x1);
  for (int i = 0; i < 60 && abs(x1 - x0) > abs(x1) * Real("1e-60"); ++i) {
    const Real x2 = x1 - g1 * (x1 - x0) / (g1 - g0);
    x0 = x1, g0 = g1;
    x1 = x2, g1 = offset_gradient(measure, k, x2);
  }
  return x1;
}

// Integral of c^m exp(alpha c^2 + beta c), by its Taylor series: n h_n = beta h_(n-1) + 2 alpha h_(n-2).
Real quadratic_integral(Measure measure, int m, const Real& alpha, const Real& beta) {
  Moments moments(measure, m);
  Real before = 0, now = 1, sum = 0;
  for (int n = 1; n < 800; ++n) {
    sum += now * moments.value();
    const Real next = (beta * now + 2 * alpha * before) / n;
    before = now;
    now = next;
    moments.advance();
  }
  return sum;
}

// The same times (1 - c)^5.
Real weighted_integral(Measure measure, int m, const Real& alpha, const Real& beta) {
  const int binomial[] = {1, -5, 10, -10, 5, -1};
  Real sum = 0;
  for (int j = 0; j <= 5; ++j) sum += binomial[j] * quadratic_integral(measure, m + j, alpha, beta);
  return sum;
}

// Gradient and Jacobian entries of the integral of (h - (1-c)^5)^2, h = exp(alpha c^2 + beta c), are
//   g_p = M2(p) - M1(p),  J_pq = 2 M2(p+q) - M1(p+q),  p, q the power of c that belongs to the parameter.
struct Fresnel {
  Measure measure;
  Real alpha, beta;
  Real m1(int p) const { return weighted_integral(measure, p, alpha, beta); }
  Real m2(int p) const { return quadratic_integral(measure, p, 2 * alpha, 2 * beta); }
  Real gradient(int p) const { return m2(p) - m1(p); }
  Real jacobian(int p, int q) const { return 2 * m2(p + q) - m1(p + q); }
};

Real best_one_term(Measure measure) {
  const Real ln2 = boost::math::constants::ln_two<Real>();
  Fresnel f{measure, 0, Real(-8) * ln2};
  for (int i = 0; i < 12; ++i) f.beta -= f.gradient(1) / f.jacobian(1, 1);
  return -f.beta / ln2;
}

std::pair<Real, Real> best_quadratic(Measure measure) {
  const Real ln2 = boost::math::constants::ln_two<Real>();
  Fresnel f{measure, Real("-5.5") * ln2, Real(-7) * ln2};
  for (int i = 0; i < 12; ++i) {
    const Real g2 = f.gradient(2), g1 = f.gradient(1);
    const Real j22 = f.jacobian(2, 2), j21 = f.jacobian(2, 1), j11 = f.jacobian(1, 1);
    const Real determinant = j22 * j11 - j21 * j21;
    f.alpha -= (j11 * g2 - j21 * g1) / determinant;
    f.beta -= (j22 * g1 - j21 * g2) / determinant;
  }
  return {f.alpha / ln2, f.beta / ln2};
}

void write_references(std::ostream& out) {
  const char* exponents[] = {"0.1",  "0.2", "0.37", "0.5",  "0.9",       "1",     "1.5",    "2",
                             "2.5",  "3",   "3.7",  "4",    "4.99",      "5",     "6",      "6.3",
                             "7",    "7.7", "8",    "9",    "10",        "11",    "11.3",   "12",
                             "13",   "14",  "15",   "17.9", "23.3",      "24",    "24.1",   "25",
                             "37.5", "50",  "100",  "1000", "12345.678", "10000", "250000", "1000000"};
  out.precision(50);
  out << "constant,parameter,exponent,measure,value\n";
  for (const Measure measure : {Measure::cosine, Measure::angle, Measure::cosine_weighted}) {
    const char* name = measure == Measure::cosine  ? "cosine"
                       : measure == Measure::angle ? "angle"
                                                   : "cosine-weighted";
    for (const char* k : exponents)
      out << "sg-offset,x," << k << ',' << name << ',' << best_offset(measure, Real(k)) << '\n';
    out << "fresnel-one-term,A,," << name << ',' << best_one_term(measure) << '\n';
    const auto [a, b] = best_quadratic(measure);
    out << "fresnel-quadratic,a,," << name << ',' << a << '\n';
    out << "fresnel-quadratic,b,," << name << ',' << b << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  return shadefit::references::print_or_check(argc, argv, write_references);
}
