#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "approx/cosine.hpp"
#include "approx/fresnel.hpp"
#include "approx/lobe.hpp"
#include "approx/phong_blinn.hpp"
#include "fit/jet.hpp"
#include "fit/metric.hpp"
#include "fit/substitution.hpp"
#include "fit/surface.hpp"

/// The families that can be fitted: each joins a target and a form of approx/ for the solver. A family brings
/// - `info`: its texts; `target_of` and `form_of`: its two formulas of the cosine, in any scalar;
/// `parameters`: the names of its parameters; `starts`: three points spread over the box in
///   which the optimum is looked for;
/// - `Sample`: what of a place does not depend on the parameters, computed once; `sample`: the function that
/// does;
/// - `form`, `error` (form - target) and `relative_error` at a sample;
/// - `shape`: what the substitution has to know; `relative_end`: the smallest cosine at which a relative
/// error has a
///   meaning, empty where there is no such number; `relative_to`: relative to what, in words.
namespace shadefit {

/// The smallest cosine with c^k >= 1/255, one code of an 8-bit linear target: exp(-log(255)/k). Below k =
/// 0.0078 that is less than any double: empty.
inline std::optional<Cosine<double>> where_lobe_is_visible(double exponent) {
  const double log_end = -std::log(255.0) / exponent;
  if (std::exp(log_end) < std::numeric_limits<double>::min()) return std::nullopt;
  return Cosine<double>{std::exp(log_end), -std::expm1(log_end)};
}

/// The scalar of a factor that all errors at a place share. It weights the place, and a weight off by 1e-16
/// moves an optimum by that times the ratio of error to slope, which is small: what is measured in long
/// double, a difference of nearly equal numbers, gains nothing from a factor wider than double, and its
/// exponential takes a fifth of the time.
template <class T>
using CommonFactor = std::conditional_t<std::same_as<T, long double>, double, T>;

/// Of a place under a lobe, what does not depend on the parameter: form = base exp(change), change = q
/// variable with q the parameter counted from its `origin`, and target = base exp(log_ratio).
template <class T>
struct LobeSample {
  T variable;
  T base;
  T log_ratio;
  T ratio_minus_one;
};

/// In long double an error is target * expm1(change - log_ratio): one exponential in that arithmetic, of the
/// place and the parameter together, where form and target apart would take one each.
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

/// The lobe c^k by a form with one parameter: what the two lobe families share. `Formulas` says how a form of
/// approx/ is an exponential in its parameter.
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
    using B = CommonFactor<T>;
    const B base = gaussian_lobe_near_peak(lift<B>(one_minus_cos), lift<B>(exponent), integer<B>(0));
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

  /// The box is (0, 3/2). For a small exponent the lobe is 1 + k log c + .., and its best offset near 5/4 k.
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

  /// The scale is near 1; the offset as without it.
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

  /// The best factor is 4 for sharp lobes and, under the measures here, below 7.5 for blunt ones: the box is
  /// wide for these and narrow for those.
  std::array<std::array<double, 1>, 3> starts() const {
    const double width = 1 / (1 + exponent);
    return {{{3.75 - 0.25 * width}, {4.5 + 0.5 * width}, {4.25 + 3.75 * width}}};
  }
};

/// The weight of a surface's reflectance, (1-c)^5 where it is none in particular, by a form: what the Fresnel
/// families share.
template <class Form, int N>
struct FresnelFamily {
  /// Errors are those of the reflectance F = f0 + (1 - f0) f; where the surface is none in particular,
  /// Schlick's formula stands for every f0 and has the errors of f.
  Surface surface = {};

  template <class T>
  static T target_of(const T& cos_theta, const T&) {
    return schlick_weight(cos_theta);
  }
  template <class T>
  static T form_of(const T& cos_theta, const T&, const std::array<T, N>& p) {
    return Form::evaluate(cos_theta, p);
  }

  std::string relative_to() const {
    if (!surface.is_named())
      return "F = f0 + (1 - f0) f, f0 = " + (surface.f0 ? to_text(*surface.f0) : std::string(reference_f0));
    return surface.is_exact() ? "the exact F" : "Schlick's F, f0 of the surface";
  }

  Shape shape() const { return {.joint = joint_of(surface)}; }

  /// Where a form falls to one half by 2^-1 at the cosine where its target does.
  double half_sharpness() const { return 1 / half_weight_cosine(surface); }

  template <class T>
  struct Sample {
    T cos_theta;
    T target;
  };

  template <class T>
  Sample<T> sample(const Cosine<T>& c) const {
    return {c.cos_theta, target_weight(surface, c.cos_theta)};
  }

  template <class T, class P>
  P form(const Sample<T>& s, const std::array<P, N>& p) const {
    return Form::evaluate(lift<P>(s.cos_theta), p);
  }

  template <class T, class P>
  P error(const Sample<T>& s, const std::array<P, N>& p) const {
    const P difference = form(s, p) - lift<P>(s.target);
    return surface.is_named() ? (integer<P>(1) - normal_reflectance<P>(surface)) * difference : difference;
  }

  /// (Fhat - F)/F = (1 - f0)/F (form - target): what a shader's reader sees.
  template <class T, class P>
  P relative_error(const Sample<T>& s, const std::array<P, N>& p) const {
    const T f0 = normal_reflectance<T>(surface);
    const T scale = (integer<T>(1) - f0) / schlick_reflectance(f0, s.target);
    return lift<P>(scale) * (form(s, p) - lift<P>(s.target));
  }

  static std::optional<Cosine<double>> relative_end() { return Cosine<double>{0, 1}; }
};

struct OneTermForm {
  template <class P>
  static P evaluate(const P& c, const std::array<P, 1>& p) {
    return fresnel_one_term(c, p[0]);
  }
};

struct QuadraticForm {
  template <class P>
  static P evaluate(const P& c, const std::array<P, 2>& p) {
    return fresnel_quadratic(c, p[0], p[1]);
  }
};

/// (1-c)^5, or what an exact surface has in its place, by exp2(-A c).
struct FresnelOneTerm : FresnelFamily<OneTermForm, 1> {
  static constexpr const Family& info = fresnel_one_term_family;
  static constexpr std::array<std::string_view, 1> parameters{"A"};
  std::array<std::array<double, 1>, 3> starts() const {
    const double half = half_sharpness();
    return {{{half / 3}, {half}, {2 * half}}};
  }
};

/// The same by exp2((a c + b) c).
struct FresnelQuadratic : FresnelFamily<QuadraticForm, 2> {
  static constexpr const Family& info = fresnel_quadratic_family;
  static constexpr std::array<std::string_view, 2> parameters{"a", "b"};
  /// From inside, all is reflected down to the critical angle: the curve leaves 1 rising before it falls.
  std::array<std::array<double, 2>, 3> starts() const {
    const double b = half_sharpness(), a = b * b;
    if (surface.is_exact() && surface.ior < 1 && surface.extinction < surface.ior)
      return {{{-2 * a, b}, {-a, 0}, {-4 * a, 3 * b}}};
    return {{{0, -b}, {-a / 2, -b / 2}, {-a, 0}}};
  }
};

struct CubicForm {
  template <class P>
  static P evaluate(const P& c, const std::array<P, 3>& p) {
    return fresnel_cubic(c, p[0], p[1], p[2]);
  }
};

struct QuarticForm {
  template <class P>
  static P evaluate(const P& c, const std::array<P, 4>& p) {
    return fresnel_quartic(c, p[0], p[1], p[2], p[3]);
  }
};

struct FourthForm {
  template <class P>
  static P evaluate(const P& c, const std::array<P, 1>& p) {
    return fresnel_fourth(c, p[0]);
  }
};

struct SquareForm {
  template <class P>
  static P evaluate(const P& c, const std::array<P, 2>& p) {
    return fresnel_square(c, p[0], p[1]);
  }
};

struct RationalForm {
  template <class P>
  static P evaluate(const P& c, const std::array<P, 1>& p) {
    return fresnel_rational(c, p[0]);
  }
};

/// The same by exp2(((a c + b) c + d) c); the starts are those of the quadratic, and beside them.
struct FresnelCubic : FresnelFamily<CubicForm, 3> {
  static constexpr const Family& info = fresnel_cubic_family;
  static constexpr std::array<std::string_view, 3> parameters{"a", "b", "d"};
  std::array<std::array<double, 3>, 3> starts() const {
    const double d = half_sharpness(), b = d * d;
    return {{{-b / 8, -b / 8, -d}, {b / 8, -b / 8, -d}, {-b / 8, -b / 4, -d / 2}}};
  }
};

/// The same by exp2((((a c + b) c + d) c + g) c).
struct FresnelQuartic : FresnelFamily<QuarticForm, 4> {
  static constexpr const Family& info = fresnel_quartic_family;
  static constexpr std::array<std::string_view, 4> parameters{"a", "b", "d", "g"};
  std::array<std::array<double, 4>, 3> starts() const {
    const double g = half_sharpness(), d = g * g;
    return {{{-d / 16, -d / 16, -d / 8, -g}, {d / 16, -d / 8, -d / 8, -g}, {-d / 8, d / 16, -d / 8, -g}}};
  }
};

/// The same by s (1-c)^4.
struct FresnelFourth : FresnelFamily<FourthForm, 1> {
  static constexpr const Family& info = fresnel_fourth_family;
  static constexpr std::array<std::string_view, 1> parameters{"s"};
  static std::array<std::array<double, 1>, 3> starts() { return {{{1}, {0.5}, {2}}}; }
};

/// The same by (1-c)^2 (1 + (a c + b) c).
struct FresnelSquare : FresnelFamily<SquareForm, 2> {
  static constexpr const Family& info = fresnel_square_family;
  static constexpr std::array<std::string_view, 2> parameters{"a", "b"};
  static std::array<std::array<double, 2>, 3> starts() { return {{{1, -1}, {2, -3}, {4, -4}}}; }
};

/// The same by (1-c)^4/(1 + a c).
struct FresnelRational : FresnelFamily<RationalForm, 1> {
  static constexpr const Family& info = fresnel_rational_family;
  static constexpr std::array<std::string_view, 1> parameters{"a"};
  static std::array<std::array<double, 1>, 3> starts() { return {{{1}, {0.5}, {2}}}; }
};

/// Every family, in the order of the report; those of comparison come last.
using Families = std::tuple<SgOffset, FresnelOneTerm, FresnelQuadratic, PhongBlinn, SgScaled, FresnelCubic,
                            FresnelQuartic, FresnelFourth, FresnelSquare, FresnelRational>;

}  // namespace shadefit
