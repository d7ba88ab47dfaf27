#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "approx/cosine.hpp"
#include "approx/fresnel.hpp"
#include "fit/families/surface.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/scalars/jet.hpp"

/// The families of Fresnel's weight. fit/families/families.hpp lists the members of a family.
namespace shadefit {

/// The common part of the Fresnel families: a form is fitted to (F - f0)/(1 - f0). Without a surface the
/// target is Schlick's (1-c)^5. `Form` is the family itself, which says how its form is evaluated.
template <class Form, int N>
struct FresnelFamily {
  /// Errors are those of the reflectance F = f0 + (1 - f0) f. Without a surface, the target is Schlick's
  /// formula for every f0, and errors are those of f.
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

  /// The parameter for which a form falls to one half at the same cosine as its target.
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
    return surface.is_named() ? lift<P>(integer<T>(1) - normal_reflectance<T>(surface)) * difference
                              : difference;
  }

  /// (Fhat - F)/F = (1 - f0)/F (form - target): the relative error that a viewer sees.
  template <class T, class P>
  P relative_error(const Sample<T>& s, const std::array<P, N>& p) const {
    return lift<P>(relative_factor(s)) * (form(s, p) - lift<P>(s.target));
  }

  static std::optional<Cosine<double>> relative_end() { return Cosine<double>{0, 1}; }

 private:
  template <class T>
  T relative_factor(const Sample<T>& s) const {
    const T f0 = normal_reflectance<T>(surface);
    return (integer<T>(1) - f0) / schlick_reflectance(f0, s.target);
  }
};

/// (1-c)^5, or the weight of a surface, by exp2(-A c).
struct FresnelOneTerm : FresnelFamily<FresnelOneTerm, 1> {
  static constexpr const Family& info = fresnel_one_term_family;
  static constexpr std::array<std::string_view, 1> parameters{"A"};
  template <class P>
  static P evaluate(const P& c, const std::array<P, 1>& p) {
    return fresnel_one_term(c, p[0]);
  }
  std::array<std::array<double, 1>, 3> starts() const {
    const double half = half_sharpness();
    return {{{half / 3}, {half}, {2 * half}}};
  }
};

/// (1-c)^5, or the weight of a surface, by exp2((a c + b) c).
struct FresnelQuadratic : FresnelFamily<FresnelQuadratic, 2> {
  static constexpr const Family& info = fresnel_quadratic_family;
  static constexpr std::array<std::string_view, 2> parameters{"a", "b"};
  template <class P>
  static P evaluate(const P& c, const std::array<P, 2>& p) {
    return fresnel_quadratic(c, p[0], p[1]);
  }
  /// Inside a dielectric the target stays at 1 from grazing to the critical angle, then falls: good curves
  /// rise before they fall.
  std::array<std::array<double, 2>, 3> starts() const {
    const double b = half_sharpness(), a = b * b;
    if (surface.is_exact() && surface.ior < 1 && surface.extinction < surface.ior)
      return {{{-2 * a, b}, {-a, 0}, {-4 * a, 3 * b}}};
    return {{{0, -b}, {-a / 2, -b / 2}, {-a, 0}}};
  }
};

/// (1-c)^5, or the weight of a surface, by exp2(((a c + b) c + d) c).
struct FresnelCubic : FresnelFamily<FresnelCubic, 3> {
  static constexpr const Family& info = fresnel_cubic_family;
  static constexpr std::array<std::string_view, 3> parameters{"a", "b", "d"};
  template <class P>
  static P evaluate(const P& c, const std::array<P, 3>& p) {
    return fresnel_cubic(c, p[0], p[1], p[2]);
  }
  std::array<std::array<double, 3>, 3> starts() const {
    const double d = half_sharpness(), b = d * d;
    return {{{-b / 8, -b / 8, -d}, {b / 8, -b / 8, -d}, {-b / 8, -b / 4, -d / 2}}};
  }
};

/// (1-c)^5, or the weight of a surface, by exp2((((a c + b) c + d) c + g) c).
struct FresnelQuartic : FresnelFamily<FresnelQuartic, 4> {
  static constexpr const Family& info = fresnel_quartic_family;
  static constexpr std::array<std::string_view, 4> parameters{"a", "b", "d", "g"};
  template <class P>
  static P evaluate(const P& c, const std::array<P, 4>& p) {
    return fresnel_quartic(c, p[0], p[1], p[2], p[3]);
  }
  std::array<std::array<double, 4>, 3> starts() const {
    const double g = half_sharpness(), d = g * g;
    return {{{-d / 16, -d / 16, -d / 8, -g}, {d / 16, -d / 8, -d / 8, -g}, {-d / 8, d / 16, -d / 8, -g}}};
  }
};

/// (1-c)^5, or the weight of a surface, by s (1-c)^4.
struct FresnelFourth : FresnelFamily<FresnelFourth, 1> {
  static constexpr const Family& info = fresnel_fourth_family;
  static constexpr std::array<std::string_view, 1> parameters{"s"};
  template <class P>
  static P evaluate(const P& c, const std::array<P, 1>& p) {
    return fresnel_fourth(c, p[0]);
  }
  static std::array<std::array<double, 1>, 3> starts() { return {{{1}, {0.5}, {2}}}; }
};

/// (1-c)^5, or the weight of a surface, by (1-c)^2 (1 + (a c + b) c).
struct FresnelSquare : FresnelFamily<FresnelSquare, 2> {
  static constexpr const Family& info = fresnel_square_family;
  static constexpr std::array<std::string_view, 2> parameters{"a", "b"};
  template <class P>
  static P evaluate(const P& c, const std::array<P, 2>& p) {
    return fresnel_square(c, p[0], p[1]);
  }
  static std::array<std::array<double, 2>, 3> starts() { return {{{1, -1}, {2, -3}, {4, -4}}}; }
};

/// (1-c)^5, or the weight of a surface, by (1-c)^4/(1 + a c).
struct FresnelRational : FresnelFamily<FresnelRational, 1> {
  static constexpr const Family& info = fresnel_rational_family;
  static constexpr std::array<std::string_view, 1> parameters{"a"};
  template <class P>
  static P evaluate(const P& c, const std::array<P, 1>& p) {
    return fresnel_rational(c, p[0]);
  }
  static std::array<std::array<double, 1>, 3> starts() { return {{{1}, {0.5}, {2}}}; }

  template <class P>
  static P denominator(const P& c, const std::array<P, 1>& p) {
    return fresnel_rational_denominator(c, p[0]);
  }
};

}  // namespace shadefit
