#pragma once

#include <array>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"
#include "approx/reflectance.hpp"
#include "approx/scalar.hpp"

/// Microfacet distributions and Smith's masking.
///
/// m is a microfacet's normal, n that of the surface, v the view; alpha > 0 is the width of a distribution,
/// the square of what artists call roughness (Burley 2012). D(m) is the microfacets' area per unit of surface
/// and solid angle of m, 0 for n.m <= 0. Two identities make it one:
///   integral of D(m) (n.m) = 1           over the sphere of normals: they cover the surface,
///   integral of G1(v) D(m) max(v.m,0) = v.n     what of them is seen covers what is seen of it.
/// Source: Walter, Marschner, Li, Torrance 2007; Heitz 2014, which calls the second the constraint on G1.
namespace shadefit {

/// The angle between m and n, by the squares of its cosine and of its sine: near the normal and near the
/// horizon one of them has lost what the other keeps.
template <class T>
struct MicrofacetNormal {
  T cos2;
  T sin2;
};

/// log((n.m)^2), from the smaller of both squares.
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

/// Blinn-Phong: 1/(pi alpha^2) (n.m)^s with s = 2/alpha^2 - 2, that is (s + 2)/(2 pi) (n.m)^s. 0 < alpha < 1;
/// at alpha = 1 it is 1/pi, but at the horizon, where 0^0 is not a number.
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

/// (alpha^2 - 1)/log(alpha^2), whose limit at alpha = 1 is 1: there, where it is 0/0, by the first terms of
/// its series 1 + x/2, x = alpha^2 - 1. Beside it nothing is lost: x = (alpha - 1)(alpha + 1) and
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

/// Smith's Lambda for GGX: (sqrt(1 + slope^2) - 1)/2, written without its cancellation at a flat slope.
/// Source: Heitz 2014; Walter, Marschner, Li, Torrance 2007.
template <class T>
T ggx_lambda(const T& slope) {
  const T one = integer<T>(1), slope2 = slope * slope;
  return slope2 / (integer<T>(2) * (sqrt(one + slope2) + one));
}

/// Smith's masking: the part G1 = 1/(1 + Lambda) of the microfacets facing v that is seen from there.
template <class T>
T smith_masking(const T& lambda) {
  return integer<T>(1) / (integer<T>(1) + lambda);
}

/// The circle of normals at one angle to n, seen from v: the integral over its azimuth of max(v.m, 0), where
/// `arc` is the part of the circle that faces v: v.m = cos(theta_v) cos + sin(theta_v) sin cos(phi).
template <class T>
T facing_circle(const Direction<T>& view, const Direction<T>& normal, const Arc<T>& arc) {
  return arc_of_line(T(view.cosine * normal.cosine), T(view.sine * normal.sine), arc);
}

namespace detail {

/// What the rows on this topic are given: roughnesses r, and how a width is made of one.
inline constexpr Quantity roughnesses{"roughness", "0.01,0.05,0.1,0.3,0.5,0.7,0.9,1"};
inline constexpr Quantity width_of_roughness{"alpha", "r^2"};
/// View angles in degrees.
inline constexpr Quantity masking_views{"view angles", "15:75:15,85,89,89.9"};

inline constexpr std::string_view masking_derivation =
    "What is seen of the microfacets from v fills what is seen of the surface. G1 = 1/(1 + Lambda) is the same for "
    "every m that faces v, so the integral is G1 times that of D(m) max(v.m, 0); over the azimuth of m it is in "
    "closed form, 2 (p phi + q sin phi) with p = cos(theta_v) cos, q = sin(theta_v) sin up to the phi at which v.m = "
    "0, and over the polar angle it is taken by Gauss-Kronrod in the logarithm of the slope and by tanh-sinh in sine "
    "and cosine.";

}  // namespace detail

/// The rows of the ledger on this topic.
inline constexpr std::array microfacet_claims{
    Claim{.id = "ndf-blinn-phong",
          .statement =
              "1/(pi alpha^2) (n.m)^(2/alpha^2 - 2), the Blinn-Phong distribution with Beckmann's width "
              "alpha: the integral of D(m) (n.m) over the microfacet normals m is 1",
          .printed = {{"", "1"}},
          .inputs = {detail::roughnesses, detail::width_of_roughness},
          .derivation =
              "The microfacets' projected areas add up to the surface's. With s = 2/alpha^2 - 2 the factor "
              "is (s+2)/(2 pi), that of the row norm-ndf. The integral is taken by Gauss-Kronrod over the "
              "logarithm of the slope tan, in which the lobe keeps its width at every roughness, and by "
              "tanh-sinh over sine and cosine.",
          .source = sources::karis_2013},
    Claim{.id = "ndf-beckmann",
          .statement =
              "exp(-tan^2/alpha^2)/(pi alpha^2 cos^4), Beckmann's distribution, angles between m and n: the "
              "integral of D(m) (n.m) over the microfacet normals m is 1",
          .printed = {{"", "1"}},
          .inputs = {detail::roughnesses, detail::width_of_roughness},
          .derivation =
              "The microfacets' projected areas add up to the surface's; in t = tan^2 the integral is that "
              "of exp(-t/alpha^2)/alpha^2. It is taken by Gauss-Kronrod over the logarithm of the slope, in "
              "which the lobe keeps its width at every roughness, and by tanh-sinh over sine and cosine.",
          .source = sources::walter_2007},
    Claim{.id = "ndf-ggx",
          .statement =
              "alpha^2/(pi ((n.m)^2 (alpha^2 - 1) + 1)^2), GGX (Trowbridge-Reitz): the integral of D(m) "
              "(n.m) over the microfacet normals m is 1",
          .printed = {{"", "1"}},
          .inputs = {detail::roughnesses, detail::width_of_roughness},
          .derivation =
              "The microfacets' projected areas add up to the surface's; in u = sin^2 the integral is that "
              "of alpha^2/(alpha^2 + (1 - alpha^2) u)^2. It is taken by Gauss-Kronrod over the logarithm of "
              "the slope, in which the lobe keeps its width at every roughness, and by tanh-sinh over sine "
              "and cosine.",
          .source = sources::walter_2007},
    Claim{.id = "ndf-gtr1",
          .statement =
              "(alpha^2 - 1)/(pi log(alpha^2)) / (1 + (alpha^2 - 1)(n.m)^2), generalised Trowbridge-Reitz of "
              "exponent 1: the integral of D(m) (n.m) over the microfacet normals m is 1, and at alpha = 1, "
              "where the formula is 0/0, D is its limit 1/pi",
          .printed = {{"integral", "1"}, {"limit", "1/pi"}},
          .inputs = {detail::roughnesses, detail::width_of_roughness, {"distance from alpha = 1", "1e-10"}},
          .derivation =
              "The microfacets' projected areas add up to the surface's; in u = sin^2 the integral is that "
              "of 1/(alpha^2 + (1 - alpha^2) u), a logarithm. It is taken by Gauss-Kronrod over the "
              "logarithm of the slope and by tanh-sinh over sine and cosine. With alpha = 1 + h, D is 1/pi "
              "times 1 + h - 2 h (n.m)^2 + O(h^2): at most |h| from 1/pi, which 50 digits on both sides of "
              "alpha = 1 have to show.",
          .source = sources::burley_2012},
    Claim{.id = "smith-beckmann",
          .statement =
              "Beckmann's distribution with Smith's G1 of its own Lambda, (erf(a) - 1)/2 + exp(-a^2)/(2 a "
              "sqrt(pi)), a = 1/(alpha tan(theta_v)): the integral of G1 D(m) max(v.m, 0) is v.n for every "
              "view v",
          .inputs = {{"distribution", "beckmann"},
                     {"masking", "beckmann"},
                     detail::roughnesses,
                     detail::width_of_roughness,
                     detail::masking_views},
          .derivation = detail::masking_derivation,
          .source = sources::heitz_2014},
    Claim{.id = "smith-ggx",
          .statement =
              "GGX with Smith's G1 of its own Lambda, (sqrt(1 + alpha^2 tan^2(theta_v)) - 1)/2: the integral "
              "of G1 D(m) max(v.m, 0) is v.n for every view v",
          .inputs = {{"distribution", "ggx"},
                     {"masking", "ggx"},
                     detail::roughnesses,
                     detail::width_of_roughness,
                     detail::masking_views},
          .derivation = detail::masking_derivation,
          .source = sources::heitz_2014},
    Claim{
        .id = "smith-borrowed",
        .statement =
            "Blinn-Phong with Beckmann's G1 and GTR1 with GGX's, as they are commonly combined: how far the "
            "integral of G1 D(m) max(v.m, 0) is from v.n",
        .inputs = {{"blinn-phong", "beckmann"},
                   {"gtr1", "ggx"},
                   detail::roughnesses,
                   detail::width_of_roughness,
                   detail::masking_views,
                   {"accurate", "0.02"}},
        .derivation =
            "The integral is that of smith-beckmann and smith-ggx. Walter et al. 2007 lend Beckmann's G1 to the Phong "
            "distribution with a = sqrt(s/2 + 1)/tan(theta_v), which is 1/(alpha tan(theta_v)) for s = 2/alpha^2 - 2; "
            "Burley 2012 masks GTR1 by GGX's G1, there at a fixed width, here at GTR1's own. Both lobes are alike up "
            "to relative O(alpha^2) in the first loan, so it is good at low roughness. GTR1 has longer tails than "
            "GGX, and at a grazing view it is the tails that are seen: what GGX's G1 leaves of them is too much. At "
            "alpha = 1 GTR1 is GGX. Accurate is read as: the integral is within that relative distance of v.n.",
        .source = sources::walter_2007},
};

}  // namespace shadefit
