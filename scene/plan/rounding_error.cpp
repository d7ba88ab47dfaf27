#include "scene/plan/rounding_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "approx/gloss.hpp"
#include "fit/scalars/gpu_model.hpp"

namespace shadefit::scene {
namespace {

struct Format {
  double unit;      ///< u
  double function;  ///< roundings of exp2, and of log2 away from 1
  double largest;   ///< number
  double smallest;  ///< step below the normal numbers
};

Format format_of(PixelPrecision precision) {
  // 4 ulps of 2 u, as `usual_gpu` (fit/scalars/gpu_model.hpp).
  if (precision == PixelPrecision::float32) return {0x1p-24, 8, 0x1.fffffep127, 0x1p-149};
  return {0x1p-11, 1, 65504, 0x1p-24};
}

/// A bound of the cancellation in a sum of slopes: sum |s_i| y^(i-1) over |sum s_i (-y)^(i-1)|.
double cancellation(std::span<const double> slopes) {
  double most = 1;
  constexpr int places = 256;
  for (int i = 0; i <= places; ++i) {
    const double y = static_cast<double>(i) / places;
    double sum = 0, size = 0, power = 1;
    for (const double slope : slopes) {
      sum += slope * power;
      size += std::abs(slope * power);
      power *= -y;
    }
    most = std::max(most, size / std::abs(sum));
  }
  constexpr double between_places = 1.1;
  return most > 1 ? most * between_places : 1;
}

/// Roundings of a pixel's power: relative to n + 2, which is at most 3 n for n >= 1, or to n.
double roundings_of_power(const RoundedShading& shading) {
  if (!shading.lobes.is_textured()) return 0;
  return shading.is_gloss_exponential ? 20 : 5;
}

/// Roundings of the exponent, relative to it, for powers of at least 1.
double roundings_of_exponent(const RoundedShading& shading, const Format& format) {
  const double of_power = 3 * roundings_of_power(shading);
  const LobeForm& form = shading.form;
  switch (form.kind) {
    case LobeKind::constant:
    case LobeKind::multiplied:
      return 0;
    case LobeKind::exponential:
      return static_cast<double>(2 * form.slopes.size() + 3) * cancellation(form.slopes) + of_power;
    case LobeKind::power:
      return format.function + 2 + of_power;
  }
  return 0;
}

/// A bound of the change on the scale by a relative error of a value v: size times v^power times the error.
/// The encoding's v S'(v) is 255 (1.055/2.4) v^(1/2.4), and up to 1.7 % more in its linear part.
struct Elasticity {
  double size, power;
};

Elasticity elasticity_of(ShownScale scale) {
  if (scale == ShownScale::linear) return {1, 1};
  constexpr double straight = 1.018;
  return {on_scale(scale, 1) * straight * 1.055 / 2.4, 1 / 2.4};
}

/// The largest |a| min(1, g 2^-|a|)^p: at |a| = log2 g, or beyond at 1/(p ln 2).
double largest_exponent(double factor, double p) {
  const double beyond = 1 / (p * std::numbers::ln2), at_white = std::log2(factor);
  return at_white >= beyond ? at_white : std::pow(factor, p) * beyond / std::numbers::e;
}

/// The largest factor of powers below 1.
double largest_dull_factor(const Lobes& lobes) {
  double largest = 0;
  for (const WeightedPower& lobe : lobes.all) {
    if (lobe.power.least < 1) largest = std::max(largest, lobe.factor);
  }
  return largest;
}

/// The sum of all roundings of a light, weighted by their effect.
double weighted_roundings(const RoundedShading& shading, const Format& format, double sharpness, double p) {
  constexpr double of_fresnel = 12, of_constant = 1, of_normalisation = 3, of_products = 3;
  constexpr double ln2 = std::numbers::ln2;
  const double factor = shading.lobes.largest_factor(), of_power = roundings_of_power(shading);
  double of_value = (shading.has_fresnel ? of_fresnel : of_constant) + of_normalisation + of_products +
                    format.function + of_power;
  if (shading.form.is_fused) of_value += ln2 * sharpness;
  if (shading.form.kind == LobeKind::multiplied) of_value += shading.form.whole;
  if (shading.form.kind == LobeKind::power)
    of_value += ln2 * shading.lobes.range().most * usual_gpu.log2_near_one / format.unit;
  // (2 c)^p |log2 c| (n + 2) of a power below 1
  const double dull = 3 * std::pow(2, p) / (p * std::numbers::e * ln2);
  return std::pow(std::min(1.0, factor), p) * of_value +
         ln2 * largest_exponent(factor, p) * roundings_of_exponent(shading, format) +
         ln2 * std::pow(largest_dull_factor(shading.lobes), p) * dull * of_power;
}

}  // namespace

std::string_view name(PixelPrecision precision) {
  return precision == PixelPrecision::float32 ? "float" : "half";
}

double rounding_error(const RoundedShading& shading, PixelPrecision precision, ShownScale scale) {
  const Format format = format_of(precision);
  const Elasticity elasticity = elasticity_of(scale);
  const double white = on_scale(scale, 1);
  const double factor = shading.lobes.largest_factor(), power = shading.lobes.range().most;
  const double sharpness = (power + shading.form.offset) * natural_slope;
  if (std::max({power, factor, game_normalisation(power), sharpness}) > format.largest) return white;
  const double relative = weighted_roundings(shading, format, sharpness, elasticity.power) * format.unit;
  // Covers the products of roundings, which are not counted: 2 % if the sum is at most 2 %.
  constexpr double products = 1.02;
  if (relative > products - 1) return white;
  // a subnormal lobe has an error of one step
  return std::min(white, elasticity.size * relative * products + on_scale(scale, factor * format.smallest));
}

}  // namespace shadefit::scene
