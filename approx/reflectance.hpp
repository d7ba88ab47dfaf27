#pragma once

#include "approx/lobe.hpp"
#include "approx/scalar.hpp"

/// The directional reflectance of a Phong or Blinn-Phong lobe, seen from the angle theta_v:
///   R(theta_v) = constant * integral over the hemisphere n.l >= 0 of the lobe [times n.l].
/// n is the normal, v the view, theta_v the angle between them, r the view mirrored at n, l the light, h the
/// half vector of l and v.
///
/// The number is computed in two independent ways. In polar coordinates around the lobe's axis, the azimuth
/// integral has a closed form. In longitude and latitude around a pole perpendicular to n and v, the
/// integrand has no kink at the horizon.
namespace shadefit {

/// The part |phi| < angle of a circle, 0 <= angle <= pi, with its sine and cosine: the part of a circle
/// around the axis where the light is above the horizon.
template <class T>
struct Arc {
  T angle;
  T sine;
  T cosine;
};

/// The integrals of a lobe and of the lobe times n.l.
template <class T>
struct LobeIntegrand {
  T plain;
  T with_cosine;
};

/// The integral of p + q cos(phi) over the arc: 2 (p phi + q sin(phi)).
template <class T>
T arc_of_line(const T& p, const T& q, const Arc<T>& arc) {
  return integer<T>(2) * (p * arc.angle + q * arc.sine);
}

/// The integral of (p + q cos(phi))^2 over the arc: (2 p^2 + q^2) phi + 4 p q sin(phi) + q^2 sin(phi)
/// cos(phi), as cos^2 integrates to (phi + sin cos)/2 on either side.
template <class T>
T arc_of_square(const T& p, const T& q, const Arc<T>& arc) {
  const T q2 = q * q;
  return (integer<T>(2) * p * p + q2) * arc.angle + (integer<T>(4) * p * q + q2 * arc.cosine) * arc.sine;
}

/// The cosine and sine of a polar angle.
template <class T>
struct Direction {
  T cosine;
  T sine;
};

/// The Phong lobe on the circle at the angle w around r, integrated over the arc above the horizon, per
/// dy = sin(w) dw with y = 1 - cos(w):  (r.l)^a times the integrals of 1 and of
///   n.l = cos(theta_v) cos(w) + sin(theta_v) sin(w) cos(phi).
/// The arc ends where n.l = 0: cos(phi) = -cot(theta_v) cot(w). w up to pi/2, where r.l is clamped.
template <class T>
LobeIntegrand<T> phong_circle(const T& y, const T& alpha, const Direction<T>& view, const Arc<T>& arc) {
  const T lobe = power_lobe_near_peak(y, alpha);
  const T sine = sqrt(y * (integer<T>(2) - y));
  const T n_l = arc_of_line(view.cosine * (integer<T>(1) - y), view.sine * sine, arc);
  return {integer<T>(2) * arc.angle * lobe, lobe * n_l};
}

/// The Blinn-Phong lobe on the circle of half vectors at the angle w around n, integrated over the arc whose
/// light is above the horizon, per dy with y = 1 - cos(2 w).
///
/// d omega_l = 4 (v.h) d omega_h, and d omega_h = sin(w) dw dphi = dy dphi / (4 n.h), so per dy it is
/// (n.h)^a / (n.h) times the integrals of v.h and of (v.h)(n.l), where
///   v.h = cos(theta_v) cos(w) + sin(theta_v) sin(w) cos(phi),   n.l = 2 (v.h)(n.h) - n.v,
/// l being v mirrored at h. n.l = cos(theta_v) cos(2w) + sin(theta_v) sin(2w) cos(phi) when multiplied out,
/// so the arc ends where cos(phi) = -cot(theta_v) cot(2w); v.h > 0 on it, as 2 (v.h)(n.h) > n.v there.
template <class T>
LobeIntegrand<T> blinn_phong_circle(const T& y, const T& alpha, const Direction<T>& view, const Arc<T>& arc) {
  const T sine = sqrt(y / integer<T>(2));
  const T n_h = sqrt(integer<T>(1) - y / integer<T>(2));
  const T lobe = half_angle_power(y, alpha) / n_h;
  const T p = view.cosine * n_h;
  const T q = view.sine * sine;
  const T v_h = arc_of_line(p, q, arc);
  const T v_h_n_l = integer<T>(2) * n_h * arc_of_square(p, q, arc) - view.cosine * v_h;
  return {lobe * v_h, lobe * v_h_n_l};
}

/// cos^a(x) for |x| <= pi/2, accurate near the peak: 1 - cos(x) = 2 sin^2(x/2), which rounding must not carry
/// beyond 1.
template <class T>
T cosine_power(const T& angle, const T& exponent) {
  const T half = sin(angle / integer<T>(2));
  return power_lobe_near_peak(min(integer<T>(2) * half * half, integer<T>(1)), exponent);
}

/// The Phong lobe by its longitude. Let z be the component of l along the pole n x r and g the longitude of l
/// around it, counted from r; d omega = dz dg. Then r.l = sqrt(1-z^2) cos(g) and, n being at g = theta_v,
/// n.l = sqrt(1-z^2) sin(g + e) with the elevation e = pi/2 - theta_v of the view. The directions above the
/// horizon and in front of r form the lune -e < g < pi/2. The integral is a product: this factor over g times
/// `phong_latitude` over -1 < z < 1.
template <class T>
LobeIntegrand<T> phong_longitude(const T& g, const T& alpha, const T& elevation) {
  const T lobe = cosine_power(g, alpha);
  return {lobe, lobe * sin(g + elevation)};
}

/// The other factor of `phong_longitude`: (1-z^2)^(a/2), and ^((a+1)/2) with n.l.
template <class T>
LobeIntegrand<T> phong_latitude(const T& z, const T& alpha) {
  const T two = integer<T>(2);
  return {power_lobe_near_peak(T(z * z), T(alpha / two)),
          power_lobe_near_peak(T(z * z), T((alpha + integer<T>(1)) / two))};
}

/// The Blinn-Phong lobe by the longitude of h around the pole; z is the component of h along the pole. The
/// longitude g is counted from the start of the horizon, with n at e/2 and v at pi/2 - e/2 (e the elevation
/// of the view). Then n.h = sqrt(1-z^2) cos(g - e/2) and v.h = sqrt(1-z^2) sin(g + e/2), so that
///   n.l = 2 (v.h)(n.h) - n.v = (1-z^2)(sin 2g + sin e) - sin e,
/// which is positive for 0 < g < pi/2 and z^2 < sin 2g / (sin 2g + sin e), see `horizon_latitude`. The
/// integrand 4 (v.h)(n.h)^a, per dz dg, is this factor over g times (1-z^2)^((a+1)/2).
template <class T>
T blinn_phong_longitude(const T& g, const T& alpha, const T& elevation) {
  const T half = elevation / integer<T>(2);
  return integer<T>(4) * cosine_power(T(g - half), alpha) * sin(g + half);
}

/// Integrals over the latitude z of the lobe and of z^2 times the lobe.
template <class T>
struct LatitudeMoments {
  T one;
  T z_squared;
};

/// The z at which the light of `blinn_phong_longitude` is on the horizon.
template <class T>
T horizon_latitude(const T& g, const T& elevation) {
  const T s = sin(integer<T>(2) * g);
  return sqrt(s / (s + sin(elevation)));
}

/// The other factor of `blinn_phong_longitude`: (1-z^2)^((a+1)/2), alone and times z^2.
template <class T>
LatitudeMoments<T> blinn_phong_latitude(const T& z, const T& alpha) {
  const T z2 = z * z;
  const T lobe = power_lobe_near_peak(z2, T((alpha + integer<T>(1)) / integer<T>(2)));
  return {lobe, lobe * z2};
}

/// The integrand at one longitude, from the integrals of `blinn_phong_latitude` over z: n.l = sin 2g - z^2
/// (sin 2g + sin e), multiplied out from `blinn_phong_longitude`.
template <class T>
LobeIntegrand<T> blinn_phong_meridian(const T& g, const T& alpha, const T& elevation,
                                      const LatitudeMoments<T>& latitude) {
  const T s = sin(integer<T>(2) * g);
  const T factor = blinn_phong_longitude(g, alpha, elevation);
  return {factor * latitude.one, factor * (s * latitude.one - (s + sin(elevation)) * latitude.z_squared)};
}

}  // namespace shadefit
