#pragma once

#include "approx/reflectance.hpp"
#include "approx/scalar.hpp"

/// Microfacet distributions and Smith's masking.
///
/// m is a microfacet's normal, n that of the surface, v the view; alpha > 0 is the width of a distribution,
/// the square of what artists call roughness (Burley 2012). D(m) is the microfacets' area per unit of surface
/// and solid angle of m, 0 for n.m <= 0. A distribution satisfies two identities:
///   integral of D(m) (n.m) = 1           over the sphere of normals: they cover the surface,
///   integral of G1(v) D(m) max(v.m,0) = v.n the visible microfacets cover the visible surface.
/// Source: Walter, Marschner, Li, Torrance 2007; Heitz 2014, which calls the second the constraint on G1.
namespace shadefit {

/// The angle between m and n, as the squares of its cosine and sine. Near the normal the sine keeps the
/// digits, near the horizon the cosine.
template <class T>
struct MicrofacetNormal {
  T cos2;
  T sin2;
};

/// log((n.m)^2), from the smaller of the two squares.
template <class T>
T log_cos2(const MicrofacetNormal<T>& m) {
  return choose(
      less(m.sin2, m.cos2), [&] { return log1p(-m.sin2); }, [&] { return log(m.cos2); });
}

/// (n.m)^2 (alpha^2 - 1) + 1, as sin^2 + alpha^2 cos^2: no cancellation at small alpha.
template <class T>
T ellipsoid(const MicrofacetNormal<T>& m, const T& alpha) {
  return m.sin2 + alpha * alpha * m.cos2;
}

/// The exponent of the Blinn-Phong distribution that is as wide as Beckmann's: 2/alpha^2 - 2.
/// Source: Karis 2013.
template <class T>
T blinn_phong_exponent(const T& alpha) {
  const T two = integer<T>(2);
  return two / (alpha * alpha) - two;
}

/// Blinn-Phong: 1/(pi alpha^2) (n.m)^s with s = 2/alpha^2 - 2, that is (s + 2)/(2 pi) (n.m)^s. 0 < alpha < 1.
/// At alpha = 1 it is 1/pi except at the horizon, where 0^0 gives NaN.
template <class T>
T blinn_phong_distribution(const MicrofacetNormal<T>& m, const T& alpha) {
  const T half_exponent = blinn_phong_exponent(alpha) / integer<T>(2);
  return exp(half_exponent * log_cos2(m)) / (pi<T>() * alpha * alpha);
}

/// Beckmann: exp(-tan^2/alpha^2) / (pi alpha^2 cos^4), tan and cos those of the angle between m and n.
/// Source: Beckmann, Spizzichino 1963, as in Walter, Marschner, Li, Torrance 2007.
template <class T>
T beckmann_distribution(const MicrofacetNormal<T>& m, const T& alpha) {
  const T alpha2 = alpha * alpha;
  return exp(-(m.sin2 / (alpha2 * m.cos2))) / (pi<T>() * alpha2 * m.cos2 * m.cos2);
}

/// GGX: alpha^2 / (pi ((n.m)^2 (alpha^2 - 1) + 1)^2).
/// Source: Trowbridge, Reitz 1975; Walter, Marschner, Li, Torrance 2007.
template <class T>
T ggx_distribution(const MicrofacetNormal<T>& m, const T& alpha) {
  const T e = ellipsoid(m, alpha);
  return alpha * alpha / (pi<T>() * e * e);
}

/// (alpha^2 - 1)/log(alpha^2). At alpha = 1, where it is 0/0 with the limit 1, the first terms of its series
/// are used: 1 + x/2, x = alpha^2 - 1. Next to it no digits are lost: x = (alpha - 1)(alpha + 1) and
/// log(alpha^2) = 2 log(alpha) are as exact as alpha itself.
template <class T>
T gtr1_factor(const T& alpha) {
  const T one = integer<T>(1), two = integer<T>(2);
  const T x = (alpha - one) * (alpha + one);
  return choose(
      less(integer<T>(0), x * x), [&] { return T(x / (two * log(alpha))); },
      [&] { return T(one + x / two); });
}

/// Generalised Trowbridge-Reitz of exponent 1: (alpha^2 - 1)/(pi log(alpha^2)) / (1 + (alpha^2 - 1)(n.m)^2);
/// alpha = 1 gives its limit 1/pi.
/// Source: Burley 2012, appendix B.
template <class T>
T gtr1_distribution(const MicrofacetNormal<T>& m, const T& alpha) {
  return gtr1_factor(alpha) / (pi<T>() * ellipsoid(m, alpha));
}

/// Smith's Lambda for Beckmann: with a = 1/slope, slope = alpha tan(theta_v),
///   (erf(a) - 1)/2 + exp(-a^2)/(2 a sqrt(pi)).
/// slope >= 0. Source: Heitz 2014; Walter, Marschner, Li, Torrance 2007.
template <class T>
T beckmann_lambda(const T& slope) {
  const T one = integer<T>(1), two = integer<T>(2);
  const T a = one / slope;
  return slope * exp(-(a * a)) / (two * sqrt(pi<T>())) - erfc(a) / two;
}

/// Smith's Lambda for GGX: (sqrt(1 + slope^2) - 1)/2, rearranged to avoid cancellation at small slopes.
/// Source: Heitz 2014; Walter, Marschner, Li, Torrance 2007.
template <class T>
T ggx_lambda(const T& slope) {
  const T one = integer<T>(1), slope2 = slope * slope;
  return slope2 / (integer<T>(2) * (sqrt(one + slope2) + one));
}

/// Smith's masking G1 = 1/(1 + Lambda): the visible fraction of the microfacets that face v.
template <class T>
T smith_masking(const T& lambda) {
  return integer<T>(1) / (integer<T>(1) + lambda);
}

/// The circle of normals at one angle to n: the integral of max(v.m, 0) over its azimuth. `arc` is the part
/// of the circle that faces v: v.m = cos(theta_v) cos + sin(theta_v) sin cos(phi).
template <class T>
T facing_circle(const Direction<T>& view, const Direction<T>& normal, const Arc<T>& arc) {
  return arc_of_line(T(view.cosine * normal.cosine), T(view.sine * normal.sine), arc);
}

}  // namespace shadefit
