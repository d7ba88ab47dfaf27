#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

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

/// The values at a cosine that do not depend on the lobe's parameter: form = base exp(change), with change =
/// q variable and q = parameter - `origin`; target = base exp(log_ratio).
template <class T>
struct LobeSample {
  T variable;
  T base;
  T log_ratio;
  T ratio_minus_one;
};

template <class T>
LobeSample<T> lobe_sample(const T& variable, const T& base, const T& log_ratio) {
  return {variable, base, log_ratio, expm1(log_ratio)};
}

/// The lobe c^k by a form with one parameter: the common part of two lobe families. `Formulas` writes a form
/// of approx/ as an exponential in its parameter.
template <class Formulas>
struct LobeFamily {
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
    return lobe_error(lift<P>(s.base), change(s, p), lift<P>(s.ratio_minus_one));
  }

  template <class T, class P>
  P relative_error(const Sample<T>& s, const std::array<P, 1>& p) const {
    return lobe_relative_error(change(s, p), lift<P>(s.log_ratio));
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
  static LobeSample<T> sample(const T& cos_theta, const T& one_minus_cos, const T& exponent) {
    const T ratio = lobe_log_ratio(cos_theta, one_minus_cos, exponent);
    const T base = gaussian_lobe_near_peak(one_minus_cos, exponent, integer<T>(0));
    return lobe_sample(T(-one_minus_cos), base, ratio);
  }
};

/// cos^(x rho)(theta/2) = exp(4 rho h) exp((x - 4) rho h), h = log(cos(theta/2)).
struct BlinnFormulas {
  static constexpr int origin = 4;
  template <class T>
  static LobeSample<T> sample(const T& cos_theta, const T& one_minus_cos, const T& exponent) {
    const T remainder = log1p_remainder(-(one_minus_cos / integer<T>(2)));
    const T variable = exponent * log_half_cosine(one_minus_cos, remainder);
    const T ratio =
        phong_blinn_log_ratio(lobe_log_ratio(cos_theta, one_minus_cos, exponent), remainder, exponent);
    return lobe_sample(variable, exp(T(integer<T>(4) * variable)), ratio);
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
    return scaled_lobe_error(lift<P>(s.base), p[0], change(s, std::array{p[1]}), lift<P>(s.ratio_minus_one));
  }

  template <class T, class P>
  P relative_error(const Sample<T>& s, const std::array<P, 2>& p) const {
    return scaled_lobe_relative_error(p[0], change(s, std::array{p[1]}), lift<P>(s.log_ratio));
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
