#include "bench/forms/pairing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "approx/exp2_polynomial.hpp"
#include "fit/enclosure.hpp"
#include "fit/exp2_proof.hpp"
#include "fit/families.hpp"
#include "fit/family_visit.hpp"
#include "fit/interval.hpp"
#include "fit/interval_ends.hpp"
#include "fit/running_error.hpp"

namespace shadefit::forms {
namespace {

/// Relative to the error: a tenth of what decides.
constexpr double width = allowed_addition / 10;
/// k and x, their sum, ln 2 and the quotient: what of a constant may be rounded before it is used.
constexpr double roundings_of_constants = 5;

template <std::size_t N>
std::array<Interval, N> enclosed(const Constants& constants) {
  std::array<Interval, N> values;
  for (std::size_t i = 0; i < N; ++i) values[i] = constant<Interval>(constants.numbers.at(i).printed);
  return values;
}

/// A family's error, form and both together at given constants.
template <class Family>
class EnclosedErrors {
 public:
  static constexpr std::size_t N = Family::parameters.size();

  EnclosedErrors(const Family& family, const Constants& constants)
      : family_(family), constants_(enclosed<N>(constants)) {
    own_ = largest(0);
    largest_form_ = largest(1, 0).upper;
  }

  const Enclosure& own() const { return own_; }

  /// max (|error| + relative |form|), from above. Where the second is next to nothing, by the largest of
  /// each; else of the sum and of the difference, the larger. The form is positive.
  double upper_with(double relative) const {
    constexpr double upwards = 1 + 0x1p-50;  // more than what the two operations round
    const double apart = (own_.upper + relative * largest_form_) * upwards;
    if (apart <= (1 + width) * own_.upper) return apart;
    return std::max(largest(relative).upper, largest(-relative).upper);
  }

 private:
  /// max |errors * error + relative * form|
  Enclosure largest(double relative, double errors = 1) const {
    const Interval factor(relative), of_error(errors);
    const auto sum = [&]<class T>(const Cosine<T>& c) {
      std::array<T, N> p;
      for (std::size_t i = 0; i < N; ++i) p[i] = lift<T>(constants_[i]);
      const auto sample = family_.sample(c);
      return T(lift<T>(of_error) * family_.error(sample, p) + lift<T>(factor) * family_.form(sample, p));
    };
    EnclosureOptions options{.width = width};
    if (relative != 0 && errors != 0) options.hint = own_.attained;
    return enclose_largest(sum, Domain{}, options);
  }

  Family family_;
  std::array<Interval, N> constants_;
  Enclosure own_;
  double largest_form_ = 0;
};

/// A bound of what rounding to float adds to the form as it is timed, its exp2 off by `function` of its
/// result.
template <class Form, std::size_t N>
double float_rounding_of(const std::array<Interval, N>& parameters, double function) {
  Rounding rounding = float_rounding;
  rounding.function = function;
  const auto constants = Form::template prepared<Interval>(parameters);
  const auto error = [&](const Cosine<Interval>& c) {
    std::array<RunningError, std::tuple_size_v<decltype(constants)>> p;
    for (std::size_t i = 0; i < p.size(); ++i)
      p[i] = {constants[i], roundings_of_constants * rounding.basic * largest_magnitude_in(constants[i]),
              &rounding};
    return Form()(RunningError{c.cos_theta, 0, &rounding}, p).error;
  };
  // A bound has no need to be near: on so many boxes the values of a form are known to some percent.
  constexpr int boxes_a_side = 128;
  double bound = 0;
  for (const Box& side : boxes_of(Domain{})) {
    for (int i = 0; i < boxes_a_side; ++i) {
      constexpr double step = half_way / boxes_a_side;
      bound = std::max(bound, error(cosine_at(side.side, span_of(i * step, (i + 1) * step))));
    }
  }
  return bound;
}

/// The bounds of the polynomials for float.
double bound_of(int degree) {
  return constant<double>(exp2_for_float[static_cast<std::size_t>(degree - least_exp2_degree)].bound);
}

/// Half an ulp is 2^-24 of a number at most: three of them hold what Horner's rule of any degree rounds, see
/// `Exp2Bounds::rounding`, and exp2 of the library is better.
constexpr double rounding_of_exp2 = 3 * 0x1p-24;

template <class Form, class Family>
Pairing paired(const Family& family, const Constants& constants, std::vector<Interval> of_target) {
  const EnclosedErrors<Family> errors(family, constants);
  Pairing pairing{.own_lower = errors.own().lower, .own_upper = errors.own().upper};
  pairing.totals[0] = pairing.own_upper;
  for (int degree = largest_exp2_degree; degree >= least_exp2_degree; --degree) {
    const double total = errors.upper_with(bound_of(degree));
    pairing.totals[static_cast<std::size_t>(degree)] = total;
    if (total <= (1 + allowed_addition) * pairing.own_lower) pairing.degree = degree;
  }
  std::array<Interval, Form::parameters> parameters;
  std::size_t next = 0;
  for (const Interval& value : of_target) parameters[next++] = value;
  for (const Interval& value : enclosed<EnclosedErrors<Family>::N>(constants)) parameters[next++] = value;
  pairing.rounding = float_rounding_of<Form>(parameters, rounding_of_exp2);
  return pairing;
}

}  // namespace

std::optional<Pairing> pair_exp2(std::string_view form, const Constants& constants) {
  const auto lobe = [&]<class Form, class Family>(Form, std::type_identity<Family>) {
    return paired<Form>(make_family<Family>(Setting(fixed_exponent)), constants, {Interval(fixed_exponent)});
  };
  const auto fresnel = [&]<class Form, class Family>(Form, std::type_identity<Family>) {
    return paired<Form>(Family(), constants, {});
  };
  if (form == LobeGaussian::id) return lobe(LobeGaussian(), std::type_identity<SgOffset>());
  if (form == LobeGaussianOfDifference::id)
    return lobe(LobeGaussianOfDifference(), std::type_identity<SgOffset>());
  if (form == LobeScaledGaussian::id) return lobe(LobeScaledGaussian(), std::type_identity<SgScaled>());
  if (form == FresnelOneTermForm::id)
    return fresnel(FresnelOneTermForm(), std::type_identity<FresnelOneTerm>());
  if (form == FresnelQuadraticForm::id)
    return fresnel(FresnelQuadraticForm(), std::type_identity<FresnelQuadratic>());
  if (form == FresnelCubicForm::id) return fresnel(FresnelCubicForm(), std::type_identity<FresnelCubic>());
  if (form == FresnelQuarticForm::id)
    return fresnel(FresnelQuarticForm(), std::type_identity<FresnelQuartic>());
  return std::nullopt;
}

}  // namespace shadefit::forms
