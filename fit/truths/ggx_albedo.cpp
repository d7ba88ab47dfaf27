#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "fit/truths/albedo_rules.hpp"
#include "fit/truths/graded_rule.hpp"

namespace shadefit {
namespace {

constexpr double pi_of_albedo = std::numbers::pi;

/// The masking of light and view, times l/(l c).
double masking_over_c(JointMasking masking, double c, double l, double alpha) {
  const double square = alpha * alpha, k = alpha / 2;
  const auto root = [&](double x) { return std::sqrt(square + (1 - square) * x * x); };
  switch (masking) {
    case JointMasking::height_correlated:
      return 2 * l / (c * root(l) + l * root(c));
    case JointMasking::separable:
      return 4 * l / ((c + root(c)) * (l + root(l)));
    default:
      return l / ((c * (1 - k) + k) * (l * (1 - k) + k));
  }
}

/// A direction of the light: the sine and cosine of d and the cosine and sine of m, where d is half the
/// difference and m half the sum of the angles of light and view. The squares of v + l, times
/// 1 - (1 - alpha^2) h_z^2, are `near` for the light opposite the view and `far` for the light beside it.
struct LightRing {
  LightRing(double elevation, double half_difference, double alpha) {
    const double sd = std::sin(half_difference);
    // pi/2 - m is small at grazing angles: its sine keeps all digits.
    const double cm = std::sin(elevation - half_difference), sm = std::cos(elevation - half_difference);
    square_cd = 1 - sd * sd;
    cosine_m = cm;
    near = 4 * cm * cm * (sd * sd + alpha * alpha * square_cd);
    far = 4 * square_cd * (sm * sm + alpha * alpha * cm * cm);
  }
  double square_cd, cosine_m, near, far;
};

/// The integral of D |v + l|^.. over the azimuth for F = 1.
double closed_ring(const LightRing& ring, double alpha) {
  const double part = 4 * (1 - alpha * alpha) * ring.square_cd * ring.cosine_m * ring.cosine_m;
  const double root = std::sqrt(ring.near * ring.far);
  return 2 * pi_of_albedo *
         (1 + 2 * part / root + part * part * (ring.near + ring.far) / (2 * root * root * root));
}

/// The same for F = (1 - v.h)^5. `sines` is the product of the sines of the angles of light and view.
double fresnel_ring(const LightRing& ring, double sines, double alpha) {
  if (!(sines > 0)) return closed_ring(ring, alpha) * std::pow(1 - ring.cosine_m, 5);
  const double least = 4 * ring.cosine_m * ring.cosine_m;
  double sum = 0;
  const auto nodes = [](double k) { return static_cast<std::size_t>(10 + 5 * k); };
  // A scale of less than 1e-15 is that of a light at the horizon, which gives nothing.
  const double scale = std::max(std::sqrt(ring.near / (4 * sines)), 1e-15);
  visit_graded(scale, pi_of_albedo / 2, nodes, [&](double half, double weight) {
    const double sine = std::sin(half), turn = 4 * sines * sine * sine;
    const double square = least + turn, ratio = square / (ring.near + turn);
    const double low = 1 - std::sqrt(square) / 2, low2 = low * low;
    sum += weight * ratio * ratio * (low2 * low2 * low);
  });
  return 4 * sum;
}

/// The integral over the elevations of the light: from that of the mirrored view to the zenith and half the
/// way down, and from the horizon up.
template <class OfRing>
double over_elevations(JointMasking masking, double c, double alpha, const OfRing& of_ring) {
  const double sine = std::sqrt((1 - c) * (1 + c));
  const double view = std::atan2(sine, c), top = std::atan2(c, sine);
  // Of lights that are lower than 1e-11 alpha no more than that share is seen.
  const double scale = std::max(std::min(alpha, top), 1e-11 * alpha);
  double sum = 0;
  const auto add = [&](double elevation, double half_difference, double weight) {
    const LightRing ring(elevation, half_difference, alpha);
    const double cosine = std::cos(elevation), l = std::sin(elevation);
    sum += weight * cosine * masking_over_c(masking, c, l, alpha) * of_ring(ring, cosine * sine);
  };
  const auto nodes = [](double k) { return static_cast<std::size_t>(14 + 5 * k); };
  if (view > 0) {
    visit_graded(scale, std::tan(view / 2), nodes, [&](double t, double weight) {
      const double d = std::atan(t);
      add(top + 2 * d, d, 2 * weight / (1 + t * t));
    });
  }
  visit_graded(scale, std::tan(top / 4), nodes, [&](double t, double weight) {
    const double d = std::atan(t);
    add(top - 2 * d, -d, 2 * weight / (1 + t * t));
  });
  visit_graded(scale, top / 2, nodes, [&](double x, double weight) { add(x, (x - top) / 2, weight); });
  return sum * alpha * alpha / (4 * pi_of_albedo);
}

}  // namespace

double ggx_albedo(JointMasking masking, double c, double alpha) {
  return over_elevations(masking, c, alpha,
                         [&](const LightRing& ring, double) { return closed_ring(ring, alpha); });
}

double ggx_bias(JointMasking masking, double c, double alpha) {
  return over_elevations(masking, c, alpha, [&](const LightRing& ring, double sines) {
    return fresnel_ring(ring, sines, alpha);
  });
}

}  // namespace shadefit
