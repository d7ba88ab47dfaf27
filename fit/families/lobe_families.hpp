#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "approx/cosine.hpp"
#include "approx/lobe.hpp"
#include "approx/phong_blinn.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/scalars/jet.hpp"

/// The families of the lobe c^k. fit/families/families.hpp lists the members of a family.
namespace shadefit {

/// The smallest cosine with c^k >= 1/255, one code of an 8-bit linear target: exp(-log(255)/k). Empty below k
/// = 0.0078, where that is less than any double.
inline std::optional<Cosine<double>> where_lobe_is_visible(double exponent) {
  const double log_end = -std::log(255.0) / exponent;
  if (std::exp(log_end) < std::numeric_limits<double>::min()) return std::nullopt;
  return Cosine<double>{std::exp(log_end), -std::expm1(log_end)};
}

/// The scalar of a factor that all errors at a place share: double is enough. It weights the place. A weight
/// that is off by 1e-16 moves an optimum by 1e-16 times the ratio of error to slope, which is small. In long
/// double, its exponential would take a fifth of the time.
template <class T>
using CommonFactor = std::conditional_t<std::same_as<T, long double>, double, T>;

/// The values at a cosine that do not depend on the lobe's parameter: form = base exp(change), with change =
/// q variable and q = parameter - `origin`; target = base exp(log_ratio).
template <class T>
struct LobeSample {
  T variable;
  T base;
  T log_ratio;
  T ratio_minus_one;
};

/// In long double an error is target * expm1(change - log_ratio): one exponential instead of one each for
/// form and target.
template <>
struct LobeSample<long double> {
  long double variable;
  CommonFactor<long double> base;
  long double log_ratio;
  CommonFactor<long double> target;
};

template <class T>
LobeSample<T> lobe_sample(const T& variable, const CommonFactor<T>& base, const T& log_ratio) {
  if constexpr (std::same_as<T, long double>) {
    return {variable, base, log_ratio, base * exp(lift<CommonFactor<T>>(log_ratio))};
  } else {
    return {variable, base, log_ratio, expm1(log_ratio)};
  }
}

/// The lobe c^k by a form with one parameter: the common part of two lobe families. `Formulas` writes a form
/// of approx/ as an exponential in its parameter.
template <class Formulas>
struct LobeFamily {
  static constexpr bool is_linear = true;  ///< the logarithm is
  static constexpr std::array<std::string_view, 1> parameters{"x"};
  static std::string relative_to() { return "target >= 1/255"; }

  double exponent;

  template <class T>
  static T target_of(const T& cos_theta, const T& exponent) {
    return power_lobe(cos_theta, exponent);
  }

  /// Target and forms fall at least as fast as exp(-k y), their squares twice as fast.
  Shape shape() const { return {.concentration = 2 * exponent, .end_power = exponent}; }

  template <class T>
  using Sample = LobeSample<T>;

  template <class T>
  Sample<T> sample(const Cosine<T>& c) const {
    return Formulas::sample(c.cos_theta, c.one_minus_cos, lift<T>(exponent));
  }

  template <class T, class P>
  P form(const Sample<T>& s, const std::array<P, 1>& p) const {
    return lift<P>(s.base) * exp(change(s, p));
  }

  template <class T, class P>
  P error(const Sample<T>& s, const std::array<P, 1>& p) const {
    if constexpr (std::same_as<T, long double>) {
      // At c = 0 the target is 0, and the error is the form.
      if (s.target == 0) return form(s, p);
      return lift<P>(s.target) * lobe_relative_error(change(s, p), lift<P>(s.log_ratio));
    } else {
      return lobe_error(lift<P>(s.base), change(s, p), lift<P>(s.ratio_minus_one));
    }
  }

  template <class T, class P>
  P relative_error(const Sample<T>& s, const std::array<P, 1>& p) const {
    return lobe_relative_error(change(s, p), lift<P>(s.log_ratio));
  }

  /// relative error / error: 1/target.
  template <class T>
  CommonFactor<T> relative_scale(const Sample<T>& s) const {
    return integer<CommonFactor<T>>(1) / (s.base * exp(lift<CommonFactor<T>>(s.log_ratio)));
  }

  /// log(form), linear in the parameter.
  template <class T, class P>
  P log_form(const Sample<T>& s, const std::array<P, 1>& p) const {
    return lift<P>(Formulas::log_base(s.variable, lift<T>(exponent))) + change(s, p);
  }

  /// log(form/target), infinite where the target is 0.
  template <class T, class P>
  P log_ratio(const Sample<T>& s, const std::array<P, 1>& p) const {
    return change(s, p) - lift<P>(s.log_ratio);
  }

  std::optional<Cosine<double>> relative_end() const { return where_lobe_is_visible(exponent); }

 protected:
  template <class T, class P>
  static P change(const Sample<T>& s, const std::array<P, 1>& p) {
    return (p[0] - integer<P>(Formulas::origin)) * lift<P>(s.variable);
  }
};

/// exp((k+x)(c-1)) = exp(-k y) exp(x (-y)).
struct GaussianFormulas {
  static constexpr int origin = 0;
  template <class T>
  static T log_base(const T& variable, const T& exponent) {
    return exponent * variable;
  }
  template <class T>
  static LobeSample<T> sample(const T& cos_theta, const T& one_minus_cos, const T& exponent) {
    const T ratio = lobe_log_ratio(cos_theta, one_minus_cos, exponent);
    using B = CommonFactor<T>;
    const B base = gaussian_lobe_near_peak(lift<B>(one_minus_cos), lift<B>(exponent), integer<B>(0));
    return lobe_sample(T(-one_minus_cos), base, ratio);
  }
};

/// cos^(x rho)(theta/2) = exp(4 rho h) exp((x - 4) rho h), h = log(cos(theta/2)).
struct BlinnFormulas {
  static constexpr int origin = 4;
  template <class T>
  static T log_base(const T& variable, const T&) {
    return integer<T>(origin) * variable;
  }
  template <class T>
  static LobeSample<T> sample(const T& cos_theta, const T& one_minus_cos, const T& exponent) {
    const T remainder = log1p_remainder(-(one_minus_cos / integer<T>(2)));
    const T variable = exponent * log_half_cosine(one_minus_cos, remainder);
    const T ratio =
        phong_blinn_log_ratio(lobe_log_ratio(cos_theta, one_minus_cos, exponent), remainder, exponent);
    return lobe_sample(variable, exp(lift<CommonFactor<T>>(integer<T>(4) * variable)), ratio);
  }
};

/// c^k by exp((k+x)(c-1)).
struct SgOffset : LobeFamily<GaussianFormulas> {
  static constexpr const Family& info = sg_offset;

  template <class T>
  static T form_of(const T& cos_theta, const T& exponent, const std::array<T, 1>& p) {
    return gaussian_lobe(cos_theta, exponent, p[0]);
  }

  /// The search box is (0, 3/2). For a small exponent the lobe is 1 + k log c + .., and its best offset is
  /// near 5/4 k.
  std::array<std::array<double, 1>, 3> starts() const {
    const double scale = std::min(1.0, exponent);
    return {{{0.25 * scale}, {0.75 * scale}, {1.25 * scale}}};
  }
};

/// c^k by A exp((k+x)(c-1)).
struct SgScaled : LobeFamily<GaussianFormulas> {
  static constexpr const Family& info = sg_scaled;
  static constexpr std::array<std::string_view, 2> parameters{"A", "x"};
  static constexpr bool is_linear = false;

  template <class T>
  static T form_of(const T& cos_theta, const T& exponent, const std::array<T, 2>& p) {
    return scaled_gaussian_lobe(cos_theta, exponent, p[0], p[1]);
  }

  template <class T, class P>
  P form(const Sample<T>& s, const std::array<P, 2>& p) const {
    return p[0] * LobeFamily::form(s, std::array{p[1]});
  }

  template <class T, class P>
  P error(const Sample<T>& s, const std::array<P, 2>& p) const {
    if constexpr (std::same_as<T, long double>) {
      if (s.target == 0) return form(s, p);
      return lift<P>(s.target) * relative_error(s, p);
    } else {
      return scaled_lobe_error(lift<P>(s.base), p[0], change(s, std::array{p[1]}),
                               lift<P>(s.ratio_minus_one));
    }
  }

  template <class T, class P>
  P relative_error(const Sample<T>& s, const std::array<P, 2>& p) const {
    return scaled_lobe_relative_error(p[0], change(s, std::array{p[1]}), lift<P>(s.log_ratio));
  }

  template <class T, class P>
  P log_form(const Sample<T>& s, const std::array<P, 2>& p) const {
    return log(p[0]) + LobeFamily::log_form(s, std::array{p[1]});
  }

  template <class T, class P>
  P log_ratio(const Sample<T>& s, const std::array<P, 2>& p) const {
    return log(p[0]) + LobeFamily::log_ratio(s, std::array{p[1]});
  }

  /// The scale is near 1, and the offset near that of the form without a scale.
  std::array<std::array<double, 2>, 3> starts() const {
    const double scale = std::min(1.0, exponent);
    return {{{1, 0.75 * scale}, {1 - 0.125 * scale, 0.25 * scale}, {1 + 0.125 * scale, 1.25 * scale}}};
  }
};

/// cos^rho(theta) by cos^(x rho)(theta/2).
struct PhongBlinn : LobeFamily<BlinnFormulas> {
  static constexpr const Family& info = phong_blinn;

  template <class T>
  static T form_of(const T& cos_theta, const T& exponent, const std::array<T, 1>& p) {
    return blinn_lobe_of_cosine(cos_theta, exponent, p[0]);
  }

  /// The best factor is 4 for sharp lobes and, under the measures here, below 7.5 for blunt ones. So the
  /// search box is narrow for sharp lobes and wide for blunt ones. Far below 4 the ratio of a sharp form to
  /// its target overflows at the horizon.
  std::array<std::array<double, 1>, 3> starts() const {
    const double width = 1 / (1 + exponent);
    return {{{4 - 0.5 * width}, {4.5 + 0.5 * width}, {4.25 + 3.75 * width}}};
  }
};

}  // namespace shadefit
