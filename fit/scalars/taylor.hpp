#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "approx/scalar.hpp"
#include "fit/scalars/certainty.hpp"

/// Taylor series in one variable with interval coefficients: the arithmetic of enclosed integrals, and of the
/// search for narrow features.
namespace shadefit {

/// The coefficients f(a), f'(a), f''(a)/2 .. of a function up to the Order-th, each enclosed for all a of an
/// interval: the middle of a panel, or the whole panel. Coefficients beyond `degree` are 0, so constants and
/// polynomials stay cheap.
///
/// If a function leaves its domain, or a condition cannot be decided on the interval, the coefficients and
/// all results from them are NaN, or all numbers where the intervals have no NaN.
template <int Order, class Interval>
class Taylor {
 public:
  Taylor() : Taylor(Interval(0)) {}
  explicit Taylor(const Interval& constant) : coefficients_{constant} {}
  Taylor(double constant) : Taylor(Interval(constant)) {}  // ceres::Jet requires this of its scalar
  explicit Taylor(std::vector<Interval> coefficients) : coefficients_(std::move(coefficients)) {}

  /// The variable itself at a place or on an interval.
  static Taylor variable(const Interval& at) { return Taylor(std::vector{at, Interval(1)}); }

  int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  Interval operator[](int i) const {
    return i <= degree() ? coefficients_[static_cast<std::size_t>(i)] : Interval(0);
  }
  const Interval& value() const { return coefficients_.front(); }

  friend Taylor operator+(const Taylor& a, const Taylor& b) { return termwise(a, b, 1); }
  friend Taylor operator-(const Taylor& a, const Taylor& b) { return termwise(a, b, -1); }
  friend Taylor operator-(const Taylor& a) {
    Taylor result = a;
    for (Interval& x : result.coefficients_) x = -x;
    return result;
  }
  friend Taylor operator*(const Taylor& a, const Taylor& b) {
    std::vector<Interval> product(static_cast<std::size_t>(std::min(Order, a.degree() + b.degree())) + 1);
    Interval term;
    for (int i = 0; i <= a.degree(); ++i) {
      for (int j = 0; j <= std::min(b.degree(), Order - i); ++j)
        add_product(product[static_cast<std::size_t>(i + j)], a.at(i), b.at(j), term);
    }
    return Taylor(std::move(product));
  }
  /// q b = a: q_k = (a_k - sum of b_j q_(k-j)) / b_0
  friend Taylor operator/(const Taylor& a, const Taylor& b) {
    const int last = b.degree() == 0 ? a.degree() : Order;
    return recurrence(last, a[0] / b[0],
                      [&](int k, const Taylor& q) { return (a[k] - convolved(b, q, 1, k, k)) / b.value(); });
  }
  Taylor& operator+=(const Taylor& b) { return *this = *this + b; }
  Taylor& operator-=(const Taylor& b) { return *this = *this - b; }
  Taylor& operator*=(const Taylor& b) { return *this = *this * b; }
  Taylor& operator/=(const Taylor& b) { return *this = *this / b; }

  /// The function with the given value and slope.
  static Taylor integrated(const Interval& value, const Taylor& slope) {
    return recurrence(std::min(Order, slope.degree() + 1), value,
                      [&](int k, const Taylor&) { return slope[k - 1] / Interval(k); });
  }
  Taylor differentiated() const {
    if (degree() == 0) return Taylor();
    return recurrence(degree() - 1, at(1), [&](int k, const Taylor&) { return Interval(k + 1) * at(k + 1); });
  }

  /// The series whose k-th coefficient, k = 1 .. last, is `next` of k and the coefficients before it.
  template <class Next>
  static Taylor recurrence(int last, const Interval& first, const Next& next) {
    Taylor result(first);
    for (int k = 1; k <= last; ++k) result.coefficients_.push_back(next(k, result));
    return result;
  }

  /// Sum of a_j b_(k-j) for j = from .. to.
  static Interval convolved(const Taylor& a, const Taylor& b, int from, int to, int k) {
    Interval sum(0), term;
    for (int j = std::max(from, k - b.degree()); j <= std::min(to, a.degree()); ++j)
      add_product(sum, a.at(j), b.at(k - j), term);
    return sum;
  }

 private:
  const Interval& at(int i) const { return coefficients_[static_cast<std::size_t>(i)]; }

  /// sum += a b: a proof spends most of its time here.
  static void add_product(Interval& sum, const Interval& a, const Interval& b, Interval& term) {
    if constexpr (requires { Scalar<Interval>::add_product(sum, a, b, term); }) {
      Scalar<Interval>::add_product(sum, a, b, term);
    } else {
      sum = sum + a * b;
    }
  }

  static Taylor termwise(const Taylor& a, const Taylor& b, int sign) {
    Taylor result = a;
    result.coefficients_.resize(std::max(a.coefficients_.size(), b.coefficients_.size()));
    for (std::size_t i = 0; i < b.coefficients_.size(); ++i) {
      Interval& x = result.coefficients_[i];
      x = sign > 0 ? Interval(x + b.coefficients_[i]) : Interval(x - b.coefficients_[i]);
    }
    return result;
  }

  std::vector<Interval> coefficients_;  ///< never empty, at most Order + 1
};

/// The adapter: each function by the recurrence of its differential equation.
template <int Order, class Interval>
struct Scalar<Taylor<Order, Interval>> {
  using T = Taylor<Order, Interval>;

  /// e' = a' e: k e_k = sum of j a_j e_(k-j)
  static T exp(const T& a) { return exp_from(shadefit::exp(a.value()), a); }
  static T exp2(const T& a) { return exp(a * ln2()); }
  static T expm1(const T& a) {
    const T e = exp(a);
    return T::recurrence(e.degree(), shadefit::expm1(a.value()), [&](int k, const T&) { return e[k]; });
  }
  static T log(const T& a) { return T::integrated(shadefit::log(a.value()), a.differentiated() / a); }
  static T log2(const T& a) { return log(a) / ln2(); }
  static T log1p(const T& a) {
    return T::integrated(shadefit::log1p(a.value()), a.differentiated() / (integer(1) + a));
  }
  static T log1p_remainder(const T& a) {
    return T::integrated(shadefit::log1p_remainder(a.value()), -(a * a.differentiated()) / (integer(1) + a));
  }
  static T erf(const T& a) { return T::integrated(shadefit::erf(a.value()), bell(a) * a.differentiated()); }
  static T erfc(const T& a) {
    return T::integrated(shadefit::erfc(a.value()), -bell(a) * a.differentiated());
  }
  static T asin(const T& a) { return T::integrated(shadefit::asin(a.value()), arc_slope(a)); }
  static T acos(const T& a) { return T::integrated(shadefit::acos(a.value()), -arc_slope(a)); }
  static T atan(const T& a) {
    return T::integrated(shadefit::atan(a.value()), a.differentiated() / (integer(1) + a * a));
  }
  static T atan2(const T& y, const T& x) {
    return T::integrated(shadefit::atan2(y.value(), x.value()),
                         (x * y.differentiated() - y * x.differentiated()) / (x * x + y * y));
  }
  /// s s = a: 2 s_0 s_k = a_k - sum of the products between
  static T sqrt(const T& a) {
    const Interval first = shadefit::sqrt(a.value());
    return T::recurrence(a.degree() == 0 ? 0 : Order, first, [&](int k, const T& s) {
      return (a[k] - T::convolved(s, s, 1, k - 1, k)) / (Interval(2) * first);
    });
  }
  static T sin(const T& a) { return turned(a, shadefit::sin(a.value()), shadefit::cos(a.value()), -1); }
  static T cos(const T& a) { return turned(a, shadefit::cos(a.value()), -shadefit::sin(a.value()), -1); }
  static T tan(const T& a) { return sin(a) / cos(a); }
  static T sinh(const T& a) { return turned(a, shadefit::sinh(a.value()), shadefit::cosh(a.value()), 1); }
  static T cosh(const T& a) { return turned(a, shadefit::cosh(a.value()), shadefit::sinh(a.value()), 1); }
  /// m/(m + 2) with m = expm1(2 a), mirrored so that no exponential overflows
  static T tanh(const T& a) {
    const bool is_positive = Scalar<Interval>::less(Interval(0), a.value()) == Certainty::yes;
    const T m = expm1(integer(is_positive ? -2 : 2) * a);
    return is_positive ? -m / (m + integer(2)) : m / (m + integer(2));
  }
  /// Constant between two jumps. An interval with a jump inside has no series.
  static T floor(const T& a) {
    const Interval whole = shadefit::floor(a.value());
    return Scalar<Interval>::less(whole, whole) == Certainty::no ? T(whole) : no_series();
  }
  /// x^p = exp(p log x), x > 0; at x = 0 it has no series.
  static T power(const T& x, const T& p) { return exp(p * log(x)); }

  /// Single points do not change an integral, so touching intervals count as decided. Where a and b are equal
  /// at a middle, the first coefficient in which they differ says which is less beside it.
  static Certainty less(const T& a, const T& b) {
    const T difference = b - a;
    for (int i = 0; i <= difference.degree(); ++i) {
      if (Scalar<Interval>::is_zero(difference[i])) continue;
      const Interval zero(0);
      if (Scalar<Interval>::less(difference[i], zero) == Certainty::no) return Certainty::yes;
      return Scalar<Interval>::less(zero, difference[i]) == Certainty::no ? Certainty::no
                                                                          : Certainty::unknown;
    }
    return Certainty::no;
  }
  /// An undecided condition would need two functions, so the result has no series.
  static T select(Certainty condition, const T& a, const T& b) {
    if (condition == Certainty::unknown) return no_series();
    return condition == Certainty::yes ? a : b;
  }
  static T min(const T& a, const T& b) { return select(less(b, a), b, a); }
  static T max(const T& a, const T& b) { return select(less(a, b), b, a); }

  static T integer(int n) { return T(Interval(n)); }
  static T from_decimal(std::string_view decimal) { return T(Scalar<Interval>::from_decimal(decimal)); }
  static T pi() { return T(Scalar<Interval>::pi()); }
  static T ln2() { return T(Scalar<Interval>::ln2()); }

  static bool is_zero(const T& a) {
    for (int i = 0; i <= a.degree(); ++i) {
      if (!Scalar<Interval>::is_zero(a[i])) return false;
    }
    return true;
  }

 private:
  static T no_series() { return T(std::vector(Order + 1, shadefit::log(Interval(-1)))); }

  /// 2/sqrt(pi) exp(-a^2)
  static T bell(const T& a) { return integer(2) / sqrt(pi()) * exp(-(a * a)); }
  /// a'/sqrt(1 - a^2)
  static T arc_slope(const T& a) { return a.differentiated() / sqrt((integer(1) - a) * (integer(1) + a)); }

  static T exp_from(const Interval& first, const T& a) {
    const T slope = a.differentiated();
    return T::recurrence(a.degree() == 0 ? 0 : Order, first, [&](int k, const T& e) {
      return T::convolved(slope, e, 0, k - 1, k - 1) / Interval(k);
    });
  }

  /// f with f(a) and f'(a) given and f'' = sign f: a sine or a cosine, circular or hyperbolic. k f_k = sum of
  /// j a_j g_(k-j), and correspondingly for g with f.
  static T turned(const T& a, const Interval& value, const Interval& slope, int sign) {
    const T inner = a.differentiated();
    T f(value), g(slope);
    std::vector<Interval> fs{value}, gs{slope};
    for (int k = 1; a.degree() > 0 && k <= Order; ++k) {
      fs.push_back(T::convolved(inner, g, 0, k - 1, k - 1) / Interval(k));
      gs.push_back(Interval(sign) * T::convolved(inner, f, 0, k - 1, k - 1) / Interval(k));
      f = T(fs);
      g = T(gs);
    }
    return f;
  }
};

}  // namespace shadefit
