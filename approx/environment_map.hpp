#pragma once

#include "approx/gloss.hpp"
#include "approx/scalar.hpp"

/// Environment maps: solid angles of caps, lobes and texels, and the mip level for a specular power. Solid
/// angles are in steradians; s > 0 is a specular power, w the texels along an edge of a cube face at level 0,
/// m a mip level (0 the finest; it need not be whole), g a gloss in [0, 1].
namespace shadefit {

/// The cap of directions within the angle phi of an axis, phi in [0, pi] radians: 2 pi (1 - cos(phi)).
template <class T>
T cap_solid_angle(const T& half_angle) {
  return integer<T>(2) * pi<T>() * (integer<T>(1) - cos(half_angle));
}

/// The same without the cancellation of narrow caps: 1 - cos(phi) = 2 sin^2(phi/2).
template <class T>
T cap_solid_angle_near_axis(const T& half_angle) {
  const T half_sine = sin(half_angle / integer<T>(2));
  return integer<T>(4) * pi<T>() * (half_sine * half_sine);
}

/// The solid angle of the lobe cos^s(theta): its integral over the hemisphere, 2 pi/(s + 1).
template <class T>
T lobe_solid_angle(const T& exponent) {
  return integer<T>(2) * pi<T>() / (exponent + integer<T>(1));
}

/// The power whose lobe covers that solid angle: the inverse of `lobe_solid_angle`.
template <class T>
T power_of_solid_angle(const T& solid_angle) {
  return integer<T>(2) * pi<T>() / solid_angle - integer<T>(1);
}

/// The power whose lobe falls to e^-n of its peak at the angle theta, given tan(theta): cos(theta) = 1/sqrt(1
/// + tan^2(theta)), so s = 2 n / log(1 + tan^2(theta)).
template <class T>
T power_that_falls(const T& folds, const T& tangent) {
  return integer<T>(2) * folds / log1p(tangent * tangent);
}

/// The texels along an edge of a face at level m: w 2^-m.
template <class T>
T texels_along_edge(const T& width, const T& level) {
  return width * exp2(-level);
}

/// The mean solid angle of a texel of level m: the sphere over the texels of six faces, 4 pi/(6 (w 2^-m)^2).
template <class T>
T mean_texel_solid_angle(const T& width, const T& level) {
  const T edge = texels_along_edge(width, level);
  return integer<T>(4) * pi<T>() / (integer<T>(6) * (edge * edge));
}

/// Solid angle per area of a cube face, the square [-1, 1]^2 at distance 1: 1/r^2 times the cosine 1/r of the
/// viewing angle, (1 + x^2 + y^2)^(-3/2).
template <class T>
T cube_face_density(const T& x, const T& y) {
  const T r2 = integer<T>(1) + x * x + y * y;
  return integer<T>(1) / (r2 * sqrt(r2));
}

/// The solid angle of the rectangle from the face's centre to (x, y): atan(x y / sqrt(1 + x^2 + y^2)). Its
/// mixed second derivative is `cube_face_density`, and it is 0 on both axes.
template <class T>
T cube_face_solid_angle(const T& x, const T& y) {
  return atan(x * y / sqrt(integer<T>(1) + x * x + y * y));
}

/// The solid angle of the square [x, x + size] x [y, y + size] on a face. It is a difference of four values
/// of size 1, so the result loses log10(1/size^2) digits.
template <class T>
T texel_solid_angle(const T& x, const T& y, const T& size) {
  const T right = x + size, top = y + size;
  return cube_face_solid_angle(right, top) - cube_face_solid_angle(x, top) - cube_face_solid_angle(right, y) +
         cube_face_solid_angle(x, y);
}

/// The level whose mean texel has the solid angle of the lobe of power s: log2(w sqrt(3)) - 1/2 log2(s + 1).
/// Source: McGuire et al. 2013, "Plausible Environment Lighting in Two Lines of Code".
template <class T>
T mip_level_of_power(const T& width, const T& exponent) {
  const T half = integer<T>(1) / integer<T>(2);
  return log2(width * sqrt(integer<T>(3))) - half * log2(exponent + integer<T>(1));
}

/// The relative step of the power between two neighbouring gloss codes: 2^(octaves/steps) - 1. `octaves` are
/// the doublings of `decode_gloss`.
template <class T>
T relative_gloss_step(const T& octaves, const T& steps) {
  return expm1(ln2<T>() * (octaves / steps));
}

/// The gloss that a generator of a prefiltered mip chain assigns to level m: 1 - m/(levels - 1).
template <class T>
T gloss_of_level(const T& level, const T& levels) {
  return integer<T>(1) - level / (levels - integer<T>(1));
}

/// The level that a shader reads for a gloss, clamped to the last one: min((1 - g) count, last).
template <class T>
T level_of_gloss(const T& gloss, const T& count, const T& last_level) {
  return min((integer<T>(1) - gloss) * count, last_level);
}

/// The power at level m, if each level scales it by `drop`: s drop^m.
template <class T>
T power_after_drops(const T& power_of_first, const T& drop, int level) {
  return power_of_first * power(drop, level);
}

}  // namespace shadefit
