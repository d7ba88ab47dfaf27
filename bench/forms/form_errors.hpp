#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "approx/exp2_polynomial.hpp"
#include "bench/forms/forms.hpp"
#include "bench/forms/pairing.hpp"
#include "fit/proof/enclosure.hpp"
#include "fit/proof/exponent_bits.hpp"
#include "fit/proof/interval.hpp"

/// Proven errors of a form of the cosine at given constants, with an exact exp2 and with a polynomial.
namespace shadefit::forms {

/// The width relative to the error: a tenth of the deciding threshold.
inline constexpr double pairing_width = allowed_addition / 10;

/// A quantity lies in [lower, upper].
struct Bounds {
  double lower, upper;
};

/// max |f(error, form)| of a family at given constants.
template <class Family, std::size_t N, class F>
Enclosure enclose(const Family& family, const std::array<Interval, N>& constants, const F& f,
                  const EnclosureOptions& options) {
  const auto of_cosine = [&]<class T>(const Cosine<T>& c) {
    std::array<T, N> p;
    for (std::size_t i = 0; i < N; ++i) p[i] = lift<T>(constants[i]);
    const auto sample = family.sample(c);
    return T(f(family.error(sample, p), family.form(sample, p)));
  };
  return enclose_largest(of_cosine, Domain{}, options);
}

/// The bound of a polynomial for float.
inline double bound_of(int degree) {
  return constant<double>(exp2_of_degree(exp2_for_float, degree).bound);
}

/// The largest relative difference between the printed polynomial for float and the other polynomials of its
/// degree: the one with coefficients rounded to float, at most 0.5e-9 from each, and the printed one for
/// double. The terms' differences are summed for |r| <= 0.51, where the sum of the terms is 0.7 at least.
inline double polynomials_apart(int degree) {
  const auto &in_float = exp2_of_degree(exp2_for_float, degree),
             &in_double = exp2_of_degree(exp2_for_double, degree);
  double apart = 0, power = 1;
  for (std::size_t i = 0; i < static_cast<std::size_t>(degree); ++i) {
    power *= 0.51;
    const double between = constant<double>(in_float.printed[i]) - constant<double>(in_double.printed[i]);
    apart += power * (std::abs(between) + 0.5e-9);
  }
  return apart / 0.7;
}

/// A form that approximates the curve of another. `Family` computes their difference without cancellation.
template <class Form, class Curve, class Family>
class FormErrors {
 public:
  /// The parameters of the curve, then those of the form.
  using Parameters = std::array<Interval, Form::parameters>;
  static constexpr std::size_t of_curve = Curve::parameters, own_count = Family::parameters.size();
  static_assert(of_curve + own_count == Form::parameters);

  FormErrors(const Family& family, const Parameters& parameters)
      : prepared_(Form::template prepared<Interval>(parameters)) {
    std::array<Interval, own_count> own;
    for (std::size_t i = 0; i < of_curve; ++i) curve_[i] = parameters[i];
    for (std::size_t i = 0; i < own_count; ++i) own[i] = parameters[of_curve + i];
    const EnclosureOptions options{.width = pairing_width};
    own_ = enclose(
        family, own, [](const auto& error, const auto&) { return error; }, options);
    largest_form_ = enclose(
                        family, own, [](const auto&, const auto& form) { return form; }, options)
                        .upper;
  }

  Bounds own() const { return {own_.lower, own_.upper}; }

  /// max |form - curve| with a polynomial in place of the exp2, for float or for double, from above. If the
  /// polynomial is nearly exact, by the sum of both bounds; else by a proof of the form with the polynomial.
  double upper_with(int degree) const {
    constexpr double upwards = 1 + 0x1p-50;  // safety factor, larger than the rounding
    const double apart = (own_.upper + bound_of(degree) * largest_form_) * upwards;
    if (apart <= (1 + pairing_width) * own_.upper) return apart;
    constexpr double form_at_most =
        1.01;  // times the largest with an exact exp2: no polynomial is off by more
    return (upper_by_polynomial(degree) + form_at_most * polynomials_apart(degree) * largest_form_) * upwards;
  }

 private:
  double upper_by_polynomial(int degree) const {
    double found = 0;
    [&]<int... I>(std::integer_sequence<int, I...>) {
      ((degree == least_exp2_degree + I ? void(found = enclosed_upper<least_exp2_degree + I>()) : void()),
       ...);
    }
    (std::make_integer_sequence<int, largest_exp2_degree - least_exp2_degree + 1>());
    return found;
  }

  template <int degree>
  double enclosed_upper() const {
    const auto difference = [this]<class T>(const Cosine<T>& c) {
      using Approximate = WithExp2<T, Exp2Choice<degree, float>>;
      std::array<Approximate, std::tuple_size_v<Prepared>> p;
      for (std::size_t i = 0; i < p.size(); ++i) p[i] = {lift<T>(prepared_[i])};
      std::array<T, of_curve> q;
      for (std::size_t i = 0; i < of_curve; ++i) q[i] = lift<T>(curve_[i]);
      return T(Form()(Approximate{c.cos_theta}, p).value - Curve()(c.cos_theta, q));
    };
    return enclose_largest(difference, Domain{}, {.width = pairing_width, .hint = own_.attained}).upper;
  }

  using Prepared = decltype(Form::template prepared<Interval>(Parameters()));
  Prepared prepared_;
  std::array<Interval, of_curve> curve_;
  Enclosure own_;
  double largest_form_ = 0;  ///< with an exact exp2
};

}  // namespace shadefit::forms
