#include "fit/ledger/lobes/lobe_errors.hpp"

#include <cmath>

#include "approx/encoding.hpp"
#include "approx/lobe.hpp"
#include "approx/lobe_laws.hpp"
#include "fit/errors/effect.hpp"
#include "fit/families/families.hpp"
#include "fit/solve/solve.hpp"
#include "fit/support/root.hpp"

namespace shadefit {
namespace {

/// The substitution for an extremum: all cosines, scaled to the lobe.
Substitution places(double exponent) {
  return {Metric{}, SgOffset{{exponent}}.shape()};
}

/// The Gaussian, and c^k, as functions of the cosine in any scalar; their difference without cancellation.
auto gaussian(double exponent, double offset) {
  return [family = SgOffset{{exponent}}, offset]<class T>(const Cosine<T>& c) {
    return family.form(family.sample(c), std::array{lift<T>(offset)});
  };
}

auto target(double exponent) {
  return [family = SgOffset{{exponent}}]<class T>(const Cosine<T>& c) {
    const auto sample = family.sample(c);
    return T(sample.base * exp(sample.log_ratio));
  };
}

auto error(double exponent, double offset) {
  return [family = SgOffset{{exponent}}, offset]<class T>(const Cosine<T>& c) {
    return family.error(family.sample(c), std::array{lift<T>(offset)});
  };
}

template <class A, class B>
double largest_codes(const A& a, const B& b, double exponent) {
  const Substitution substitution = places(exponent);
  return largest_sampled([&](double s) {
    const Cosine<double> c = substitution.at(s).cosine;
    return std::abs(srgb_code(double(a(c))) - srgb_code(double(b(c))));
  });
}

}  // namespace

Extremum largest_lobe_error(double exponent, double offset) {
  return largest_magnitude(error(exponent, offset), places(exponent));
}

double largest_lobe_codes(double exponent, double offset) {
  return largest_codes(gaussian(exponent, offset), target(exponent), exponent);
}

Extremum largest_offset_difference(double exponent, double offset, double other) {
  const auto a = gaussian(exponent, offset), b = gaussian(exponent, other);
  return largest_magnitude([&]<class T>(const Cosine<T>& c) { return T(a(c) - b(c)); }, places(exponent));
}

double largest_offset_codes(double exponent, double offset, double other) {
  return largest_codes(gaussian(exponent, offset), gaussian(exponent, other), exponent);
}

std::optional<double> best_offset(double exponent, Measure measure) {
  const Solution optimum = solve_by_squares(SgOffset{{exponent}}, {.measure = measure});
  return optimum.status == Status::converged ? std::optional(optimum.parameters[0]) : std::nullopt;
}

SmallestLobeError smallest_lobe_error(double exponent) {
  const Substitution substitution = places(exponent);
  // The largest error above c^k for the sign 1, below it for -1.
  const auto excess = [&](double offset, int sign) {
    const auto above = [&]<class T>(const Cosine<T>& c) {
      return positive_part(T(integer<T>(sign) * error(exponent, offset)(c)));
    };
    return largest_magnitude(above, substitution).magnitude;
  };
  const auto imbalance = [&](double offset) { return excess(offset, 1) - excess(offset, -1); };
  const double offset = root_between(imbalance, 0, 2, 34);
  return {offset, excess(offset, 1)};
}

std::optional<Cosine<double>> peak_crossing(double exponent, double offset) {
  if (!(offset > 0)) return std::nullopt;
  // The residual is not negative at y = x/k, as -log(c^k/exp(-k y)) >= k y^2/2 and log((1 + e^(-x y))/2) >=
  // -x y/2, nor close enough to the horizon; it is negative close to the peak.
  const bool is_blunt = exponent <= 2 * offset;
  const auto place = [&](double s) {
    return is_blunt ? Cosine<double>{std::exp(-s), -std::expm1(-s)} : Cosine<double>{1 - s, s};
  };
  const auto residual = [&](double s) {
    const Cosine<double> c = place(s);
    return peak_crossing_residual(c.cos_theta, c.one_minus_cos, exponent, offset);
  };
  double high = is_blunt ? 1 : offset / exponent;
  while (is_blunt && residual(high) < 0) high *= 2;
  double low = high / 2;
  while (residual(low) >= 0) low /= 2;
  return place(root_between(residual, low, high, 48));
}

double lobe_error_at(const Cosine<double>& c, double exponent, double offset) {
  return std::abs(error(exponent, offset)(c));
}

void show_gaussian(Effect& effect, const Cosine<double>& c, double exponent, double offset) {
  effect.show(target(exponent)(c), gaussian(exponent, offset)(c), at_cosine(c));
}

Effect effect_of_gaussian(double exponent, double offset) {
  return effect_between(target(exponent), gaussian(exponent, offset), places(exponent));
}

Effect effect_of_offset(double exponent, double from, double to) {
  return effect_between(gaussian(exponent, from), gaussian(exponent, to), places(exponent));
}

}  // namespace shadefit
