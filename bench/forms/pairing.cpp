#include "bench/forms/pairing.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "approx/exp2_polynomial.hpp"
#include "fit/families/families.hpp"
#include "fit/family_visit.hpp"
#include "fit/proof/enclosure.hpp"
#include "fit/proof/exponent_bits.hpp"
#include "fit/proof/interval.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/proof/running_error.hpp"

namespace shadefit::forms {
namespace {

/// The width relative to the error: a tenth of the deciding threshold.
constexpr double pairing_width = allowed_addition / 10;

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
double bound_of(int degree) {
  return constant<double>(exp2_of_degree(exp2_for_float, degree).bound);
}

/// The largest relative difference between the printed polynomial for float and the other polynomials of its
/// degree: the one with coefficients rounded to float, at most 0.5e-9 from each, and the printed one for
/// double. The terms' differences are summed for |r| <= 0.51, where the sum of the terms is 0.7 at least.
double polynomials_apart(int degree) {
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

/// The relative width of bounds that distinguishes the errors of two lobes.
constexpr double rough_width = 0.02;
/// The roundings of a constant before its use: k, x, their sum, ln 2 and the quotient.
constexpr double roundings_of_constants = 5;

/// For an 8-bit gloss.
constexpr int codes = 256;

/// The error of the lobe with a gloss per element, over all codes.
///
/// exp2 is used twice. A relative error delta turns D = exp2(d g + m) into D (1 + delta). A relative error
/// delta' multiplies the result by 1 + delta': (1 + delta') exp((k + x')(c - 1)), with x' = ln 2 D (1 +
/// delta) + x - k. This falls with delta and rises with delta'. If both are within a bound, the error lies
/// between the errors at two corners. The corners are computed only for the widest lobes, which may have the
/// largest error.
class GlossErrors {
 public:
  GlossErrors(const Target& target, const Constants& constants) : offset_(number(constants.numbers, 1)) {
    const Interval doublings = number(target.parameters, 0), first = number(target.parameters, 1);
    const Interval base_two_first = number(constants.numbers, 0);
    for (int code = 0; code < codes; ++code) {
      const Interval gloss = Interval(code) / largest_code<Interval>();
      Lobe lobe{decode_gloss(gloss, doublings, first), decode_gloss(gloss, doublings, base_two_first)};
      lobe.own_upper = largest_of(lobe, {0, 0}, rough_width).upper;
      lobes_.push_back(lobe);
    }
  }

  Bounds own() const { return largest_at({{0, 0}}, 0); }

  /// The polynomial adds at most ((1 + bound) exp(t bound) - 1) exp(-t) to the own error of a lobe, where t
  /// is the exponent by which the lobe has fallen. t exp(-t) is at most 1/e, and a hundredth more covers the
  /// rest.
  double upper_with(int degree) const {
    const double relative = bound_of(degree);
    constexpr double more_than_both = 1.01 * (1 + 0.37);
    return largest_at({{-relative, relative}, {relative, -relative}}, more_than_both * relative).upper;
  }

 private:
  /// For a code.
  struct Lobe {
    Interval exponent, base_two;
    double own_upper = 0;  ///< bound of its own error
  };
  /// delta and delta'
  struct Corner {
    double of_power, of_result;
  };

  static Interval number(const std::vector<NamedNumber>& numbers, std::size_t i) {
    return constant<Interval>(numbers.at(i).printed);
  }

  /// The largest error of a lobe if the polynomial is off by a corner.
  Bounds largest_of(const Lobe& lobe, const Corner& corner, double width) const {
    // |c^k - c^k'| <= |k - k'|/(e k'), because the largest value of -c^k log c is 1/(e k)
    const double exponent = lower_end(lobe.exponent);
    const double beside = (upper_end(lobe.exponent) - exponent) / exponent;
    const Interval power = ln2<Interval>() * lobe.base_two * (Interval(1) + Interval(corner.of_power));
    const std::array p{Interval(Interval(1) + Interval(corner.of_result)),
                       Interval(power + offset_ - Interval(exponent))};
    const auto error = [](const auto& e, const auto&) { return e; };
    const Enclosure largest = enclose(make_family<SgScaled>(Setting(exponent)), p, error, {.width = width});
    return {largest.lower - beside, largest.upper + beside};
  }

  /// The largest over all lobes. A lobe is skipped if its own error plus `more` is below an error that was
  /// already found.
  Bounds largest_at(const std::vector<Corner>& corners, double more) const {
    Bounds worst{0, 0};
    for (const Lobe& lobe : lobes_) {
      if (lobe.own_upper + more <= worst.lower) {
        worst.upper = std::max(worst.upper, lobe.own_upper + more);
        continue;
      }
      for (const Corner& corner : corners) {
        const Bounds largest = largest_of(lobe, corner, pairing_width);
        worst = {std::max(worst.lower, largest.lower), std::max(worst.upper, largest.upper)};
      }
    }
    return worst;
  }

  Interval offset_;
  std::vector<Lobe> lobes_;
};

/// Half an ulp is 2^-24 of a number at most: three of them bound the rounding of Horner's rule of any degree,
/// see `Exp2Bounds::rounding`. exp2 of the library is better.
constexpr double rounding_of_exp2 = 3 * 0x1p-24;

Rounding rounding_with_polynomial() {
  Rounding rounding = float_rounding;
  rounding.function = rounding_of_exp2;
  return rounding;
}

/// A form's constants, rounded.
template <std::size_t N>
std::array<RunningError, N> rounded_constants(const std::array<Interval, N>& constants,
                                              const Rounding& rounding) {
  std::array<RunningError, N> rounded;
  for (std::size_t i = 0; i < N; ++i) {
    rounded[i] = {constants[i], roundings_of_constants * rounding.basic * largest_magnitude_in(constants[i]),
                  &rounding};
  }
  return rounded;
}

/// The factor by which a polynomial, instead of an exact exp2, increases rounding errors. If the form
/// with the polynomial is proven as a whole, a rounded exponent changes the result by the polynomial's
/// derivative: at most 1.0143 times the derivative of exp2 for degree 2, less for the others. If bounds are
/// added, it is the derivative of exp2, times 1 + bound once, or twice for a decoded gloss: 1.004.
constexpr double rounding_by_polynomial = 1.02;

/// A bound of the rounding error of a form, absolute and relative to the form.
struct AddedByRounding {
  double absolute = 0, relative = 0;
};

/// For `evaluate`, a form of one cosine. A rough bound is enough: on these boxes the values of a form are
/// known to some percent.
template <class Evaluate>
AddedByRounding rounding_on(int boxes_a_side, const Rounding& rounding, const Evaluate& evaluate) {
  AddedByRounding bound;
  for (const Box& side : boxes_of(Domain{})) {
    for (int i = 0; i < boxes_a_side; ++i) {
      const double step = half_way / boxes_a_side;
      const auto c = cosine_at(side.side, span_of(i * step, (i + 1) * step));
      const RunningError result = evaluate(RunningError{c.cos_theta, 0, &rounding});
      bound.absolute = std::max(bound.absolute, result.error);
      bound.relative = std::max(bound.relative, result.error / smallest_magnitude_in(result.value));
    }
  }
  return bound;
}

/// A proof of a form with a polynomial includes both sides of a jump if exponents are off by less than
/// `ExponentBits<Interval>::overlap`. That changes a result by ln 2 times the overlap: the rounding error
/// must be less.
template <class Form>
double float_rounding_of(const std::array<Interval, Form::parameters>& parameters) {
  const Rounding rounding = rounding_with_polynomial();
  const auto p = rounded_constants(Form::template prepared<Interval>(parameters), rounding);
  const AddedByRounding added =
      rounding_on(128, rounding, [&](const RunningError& c) { return Form()(c, p); });
  if (!(added.relative < ln2<double>() * ExponentBits<Interval>::overlap))
    throw std::logic_error(std::string(Form::id) +
                           ": rounding moves an exponent beyond what is proven of jumps");
  return rounding_by_polynomial * added.absolute;
}

/// Over all codes. A relative rounding error r of A changes exp2(A c - A) by r t exp(-t) to first order,
/// where t is the exponent by which the lobe has fallen: at most r/e. The rest is the rounding of the form
/// with that A. It is largest at the peak of the narrowest lobe, and needs no narrow boxes.
double float_rounding_of_gloss(const std::array<Interval, GlossGaussian::parameters>& parameters) {
  const Rounding rounding = rounding_with_polynomial();
  const auto p = rounded_constants(GlossGaussian::prepared<Interval>(parameters), rounding);
  constexpr double falling = 0.37;  // 1/e, and more for the second order
  double bound = 0;
  for (int code = 0; code < codes; ++code) {
    const RunningError base_two = GlossGaussian::base_two(RunningError{Interval(code), 0, &rounding}, p);
    const RunningError exact{base_two.value, 0, &rounding};
    const double of_base_two = base_two.error / smallest_magnitude_in(base_two.value);
    bound = std::max(bound, falling * of_base_two + rounding_on(4, rounding, [&](const RunningError& c) {
                                                      return gaussian_lobe_base_two(c, exact);
                                                    }).absolute);
  }
  return rounding_by_polynomial * bound;
}

template <class Errors>
Pairing paired(const Errors& errors, const Checkpoint& checkpoint) {
  const Bounds own = errors.own();
  Pairing pairing{.own_lower = own.lower, .own_upper = own.upper};
  pairing.totals[0] = pairing.own_upper;
  for (int degree = largest_exp2_degree; degree >= least_exp2_degree; --degree) {
    checkpoint();
    const double total = errors.upper_with(degree);
    pairing.totals[static_cast<std::size_t>(degree)] = total;
    if (total <= (1 + allowed_addition) * pairing.own_lower) pairing.degree = degree;
  }
  return pairing;
}

/// The numbers of the target, then those of the form.
template <class Form>
std::array<Interval, Form::parameters> all_parameters(const Target& target, const Constants& constants) {
  std::array<Interval, Form::parameters> all;
  std::size_t next = 0;
  for (const auto* numbers : {&target.parameters, &constants.numbers}) {
    for (const NamedNumber& number : *numbers) all.at(next++) = constant<Interval>(number.printed);
  }
  return all;
}

template <class Form, class Curve, class Family>
Pairing paired(const Family& family, const Target& target, const Constants& constants,
               const Checkpoint& checkpoint) {
  const auto parameters = all_parameters<Form>(target, constants);
  Pairing pairing = paired(FormErrors<Form, Curve, Family>(family, parameters), checkpoint);
  pairing.rounding = float_rounding_of<Form>(parameters);
  return pairing;
}

Pairing paired_gloss(const Target& target, const Constants& constants, const Checkpoint& checkpoint) {
  Pairing pairing = paired(GlossErrors(target, constants), checkpoint);
  pairing.rounding = float_rounding_of_gloss(all_parameters<GlossGaussian>(target, constants));
  return pairing;
}

/// For N lights in any directions: N times the bound of the lobe, which N lights in one direction attain.
/// Below the horizon the target is 0, and the form is less than at c = 0, where it is nearly 0.
Pairing paired_lights(const Target& target, const Constants& constants, const Checkpoint& checkpoint) {
  constexpr std::size_t power = 1, axes = 3;
  const auto lights = static_cast<double>((target.parameters.size() - power) / axes);
  const std::array parameters{constant<Interval>(target.parameters.front().printed),
                              constant<Interval>(constants.numbers.front().printed)};
  Pairing pairing = paired(FormErrors<LobeGaussian, LobeSquarings, SgOffset>(
                               make_family<SgOffset>(Setting(fixed_exponent)), parameters),
                           checkpoint);
  pairing.own_lower *= lights;
  pairing.own_upper *= lights;
  for (double& total : pairing.totals) total *= lights;
  return pairing;
}

}  // namespace

std::optional<Pairing> pair_exp2(const Target& target, std::string_view form, const Constants& constants,
                                 const Checkpoint& checkpoint) {
  std::optional<Pairing> found;
  const auto look_at = [&]<class Form, class Curve>(Form, Curve, const auto& family) {
    if (form == Form::id) found = paired<Form, Curve>(family, target, constants, checkpoint);
  };
  const Setting exponent(fixed_exponent);
  look_at(LobeGaussian(), LobeSquarings(), make_family<SgOffset>(exponent));
  look_at(LobeGaussianOfDifference(), LobeSquarings(), make_family<SgOffset>(exponent));
  look_at(LobeScaledGaussian(), LobeSquarings(), make_family<SgScaled>(exponent));
  look_at(FresnelOneTermForm(), SchlickMultiplied(), FresnelOneTerm());
  look_at(FresnelQuadraticForm(), SchlickMultiplied(), FresnelQuadratic());
  look_at(FresnelCubicForm(), SchlickMultiplied(), FresnelCubic());
  look_at(FresnelQuarticForm(), SchlickMultiplied(), FresnelQuartic());
  if (form == GlossGaussian::id) found = paired_gloss(target, constants, checkpoint);
  if (form == PhongGaussian::id) found = paired_lights(target, constants, checkpoint);
  return found;
}

}  // namespace shadefit::forms
