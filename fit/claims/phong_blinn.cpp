#include "approx/phong_blinn.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/ledger/topics.hpp"

namespace shadefit {
namespace {

double radians(double degrees) {
  return degrees * pi<double>() / 180;
}

double degrees(double radians) {
  return radians * 180 / pi<double>();
}

/// A direction by its angle from the normal and its azimuth, as x, y, z with z along the normal.
using Vector = std::array<double, 3>;

Vector direction(double from_normal, double azimuth) {
  const double s = std::sin(from_normal);
  return {s * std::cos(azimuth), s * std::sin(azimuth), std::cos(from_normal)};
}

/// The angle between two vectors of any length: atan2 of |a x b| and a.b keeps its digits near 0 and pi.
double angle_between(const Vector& a, const Vector& b) {
  const Vector cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const double sine = std::sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
  return std::atan2(sine, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

struct Angles {
  double phong;  ///< between r and v
  double blinn;  ///< between n and h
};

/// Computed from the vectors r = 2 (n.l) n - l and h ~ l + v.
Angles angles_of(const Vector& light, const Vector& view) {
  const Vector reflected{-light[0], -light[1], light[2]};
  const Vector half{light[0] + view[0], light[1] + view[1], light[2] + view[2]};
  return {angle_between(reflected, view), angle_between({0, 0, 1}, half)};
}

/// The range of phong/blinn over lights and views in one plane, every `step` degrees from horizon to horizon.
Range factor_in_plane(double step) {
  Range range{1e9, -1e9};
  const int steps = static_cast<int>(std::floor(89 / step));
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      if (i + j == 0) continue;  // the mirror direction: both angles are 0
      const Angles angles = angles_of(direction(radians(i * step), 0), direction(radians(j * step), 0));
      range.from = std::min(range.from, angles.phong / angles.blinn);
      range.to = std::max(range.to, angles.phong / angles.blinn);
    }
  }
  return range;
}

/// The largest value of a function of the light over the hemisphere; the view is at azimuth 0, and the two
/// sides of its plane are mirror images.
template <class F>
double largest_over_lights(const F& f) {
  return largest_sampled([&](double s) {
    return largest_sampled([&](double t) { return f(direction(s * pi<double>() / 2, t * pi<double>())); });
  });
}

/// cos^rho of an angle, 0 beyond 90 degrees.
double lobe_of_angle(double angle, double exponent) {
  return power_lobe(positive_part(std::cos(angle)), exponent);
}

/// The factor at a view.
struct AtView {
  double angle;          ///< from the normal, in degrees
  double across;         ///< phong/blinn at the peak, across the plane
  double excess;         ///< the largest 2 blinn - phong, by search, in degrees
  double lawful_excess;  ///< and by `sine_of_half_excess`
  double lobe;           ///< the largest difference of cos^rho(phong) from cos^rho(2 blinn)
};

AtView look_from(double view_angle, double exponent) {
  const double from_normal = radians(view_angle);
  const Vector view = direction(from_normal, 0), mirrored = direction(from_normal, pi<double>());
  // The distance of a light from the mirror direction, perpendicular to the plane: near enough to the peak
  // for six digits (the next term is of the second order), far enough for the rounding of angles.
  constexpr double off = 1e-5;
  const Angles near_peak =
      angles_of({mirrored[0] * std::cos(off), std::sin(off), mirrored[2] * std::cos(off)}, view);
  return {view_angle, near_peak.phong / near_peak.blinn,
          degrees(largest_over_lights([&](const Vector& light) {
            const Angles a = angles_of(light, view);
            return 2 * a.blinn - a.phong;
          })),
          degrees(2 * std::asin(sine_of_half_excess(std::cos(from_normal)))),
          largest_over_lights([&](const Vector& light) {
            const Angles a = angles_of(light, view);
            return std::abs(lobe_of_angle(a.phong, exponent) - lobe_of_angle(2 * a.blinn, exponent));
          })};
}

/// The effect of the lobe of twice the Blinn angle instead of Phong's, for one view: over lights at
/// every degree from the normal and around it, on one side of the plane of the view.
Effect effect_seen_from(double view_angle, double exponent) {
  const Vector view = direction(radians(view_angle), 0);
  Effect effect;
  for (int polar = 0; polar <= 90; ++polar) {
    for (int azimuth = 0; azimuth <= 180; ++azimuth) {
      const Angles a = angles_of(direction(radians(polar), radians(azimuth)), view);
      effect.show(lobe_of_angle(a.phong, exponent), lobe_of_angle(2 * a.blinn, exponent),
                  {{"light ", static_cast<double>(polar), " degrees from n"},
                   {"azimuth ", static_cast<double>(azimuth), " degrees"}});
    }
  }
  return effect;
}

/// "3.905, 15.4 and 34.06"
std::string listed(const std::vector<AtView>& views, double AtView::*value, int digits) {
  std::vector<std::string> words;
  for (const AtView& at : views) words.push_back(decimal(at.*value, digits));
  return enumerated(words);
}

/// About ten roundings of an angle, and a quotient of two.
constexpr double angle_tolerance = 1e-12;
/// A maximum whose place has half the digits, in degrees; and the second-order term of `off`.
constexpr double search_tolerance = 1e-6;

/// Whether the search at a view agrees with the laws.
bool follows_the_laws(const AtView& at) {
  return std::abs(at.excess - at.lawful_excess) <= search_tolerance &&
         std::abs(at.across - angle_ratio_across(std::cos(radians(at.angle)))) <= search_tolerance;
}

Finding angle(const Claim& claim) {
  const double printed = number_of(claim.printed[0].value), exponent = given(claim, "exponent");
  const Range in_plane = factor_in_plane(given(claim, "step"));
  const bool holds_in_plane = std::max(in_plane.to - printed, printed - in_plane.from) <= angle_tolerance;
  std::vector<AtView> views;
  for (const double view : parse_sweep(claim.inputs.at("views"))) views.push_back(look_from(view, exponent));
  const auto holds_at = [](const AtView& at) { return at.excess <= search_tolerance; };
  const bool holds_everywhere = holds_in_plane && std::ranges::all_of(views, holds_at);
  const Verdict verdict = verdict_of(holds_everywhere, holds_in_plane);
  const bool is_known = std::ranges::all_of(views, follows_the_laws);
  const AtView& worst_view = *std::ranges::max_element(views, {}, &AtView::lobe);
  return told(
      claim, is_known ? std::optional(verdict) : std::nullopt,
      sentence(effect_seen_from(worst_view.angle, exponent), "Phong's lobe",
               fmt::format("seen from {:.4g} degrees the lobe of twice the Blinn angle", worst_view.angle)),
      Told{"middle", (in_plane.from + in_plane.to) / 2}, Told{"tolerance", angle_tolerance},
      Told{"across", listed(views, &AtView::across, 5)}, Told{"excess", listed(views, &AtView::excess, 5)},
      Told{"lobes", listed(views, &AtView::lobe, 3)});
}

}  // namespace

std::vector<Evaluator> phong_blinn_evaluators() {
  return {{"phong-blinn-angle", angle}};
}

}  // namespace shadefit
