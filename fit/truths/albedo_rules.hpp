#pragma once

/// Directional albedos of microfacets: the share of the light from the direction with cosine c that the
/// surface reflects, by quadrature. alpha is the width of the lobe. Both are greater than 0 and at most 1.
namespace shadefit {

/// The masking of light and view, in terms of their cosines l and c.
enum class JointMasking {
  height_correlated,  ///< 2 l c/(c sqrt(alpha^2 + (1 - alpha^2) l^2) + l sqrt(alpha^2 + (1 - alpha^2) c^2))
  separable,          ///< G1(c) G1(l), G1(x) = 2 x/(x + sqrt(alpha^2 + (1 - alpha^2) x^2))
  schlick,            ///< G1(c) G1(l), G1(x) = x/(x (1 - k) + k), k = alpha/2
};

/// The albedo of GGX without Fresnel's term, F = 1. The azimuth is integrated in closed form.
/// Source: Walter, Marschner, Li, Torrance 2007, Microfacet models for refraction through rough surfaces.
double ggx_albedo(JointMasking masking, double c, double alpha);

/// The same with (1 - v.h)^5 for Fresnel's term: with Schlick's F = f0 + (1 - f0) (1 - v.h)^5 the albedo is
/// f0 (ggx_albedo - ggx_bias) + ggx_bias.
double ggx_bias(JointMasking masking, double c, double alpha);

/// The albedo of the sheen with D = (2 + 1/alpha) sin(h)^(1/alpha)/(2 pi) and the visibility
/// V = 1/(4 (l + c - l c)), at most `most`. It may be greater than 1.
/// Sources: Estevez, Kulla 2017, Production friendly microfacet sheen BRDF (D);
/// Neubelt, Pettineo 2013, Crafting a next-gen material pipeline for The Order: 1886 (V).
double sheen_albedo(double c, double alpha, double most);

}  // namespace shadefit
