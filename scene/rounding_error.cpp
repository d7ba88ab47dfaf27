#include "scene/rounding_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "approx/gloss.hpp"
#include "approx/lobe.hpp"
#include "approx/shading.hpp"
#include "fit/half.hpp"

namespace shadefit::scene {
namespace {

constexpr double unit = 0x1p-24;

/// v S'(v) is at most so much of white on either scale: 1, and 1.055/2.4 for the encoding.
double of_white(ShownScale scale) {
  constexpr double encoding = 1.055 / 2.4;
  return scale == ShownScale::linear ? 1 : encoding * on_scale(scale, 1);
}

/// The lobe in the scalar T, its constants computed in double and rounded to T.
template <class T>
class RoundedLobe {
 public:
  RoundedLobe(const LobeForm& form, double power) : form_(form), power_(static_cast<T>(power)) {
    for (const double slope : form.slopes) slopes_.push_back(static_cast<T>((power + form.offset) * slope));
  }
  T operator()(const T& c) const {
    switch (form_.kind) {
      case LobeKind::constant:
        return integer<T>(1);
      case LobeKind::multiplied:
        return shadefit::power(c, form_.whole);
      case LobeKind::exponential:
        return form_.is_fused ? gaussian_lobe_base_two(c, slopes_[0]) : sloped_lobe(c, slopes_);
      case LobeKind::power:
        return exp2(power_ * log2(c));
    }
    return integer<T>(0);
  }

 private:
  const LobeForm& form_;
  T power_;
  std::vector<T> slopes_;
};

double half_rounding(const LobeForm& form, const WeightedPower& lobe, ShownScale scale) {
  using Half = Eigen::half;
  const RoundedLobe<Half> rounded(form, lobe.power);
  const RoundedLobe<double> exact(form, lobe.power);
  const double normalisation = game_normalisation(lobe.power), reflectance = lobe.factor / normalisation;
  const Half half_normalisation(static_cast<float>(normalisation));
  const Half half_reflectance(static_cast<float>(reflectance));
  double largest = 0;
  constexpr int one_bits = 0x3c00;
  for (int bits = 1; bits <= one_bits; ++bits) {
    const Half c = Eigen::numext::bit_cast<Half>(static_cast<std::uint16_t>(bits));
    const auto wide = static_cast<double>(c);
    const double light = std::min(1.0, 2 * wide);
    const auto shown = static_cast<double>(
        shown_specular(half_reflectance, half_normalisation, rounded(c), Half(static_cast<float>(light))));
    const double truth = shown_specular(reflectance, normalisation, exact(wide), light);
    if (!(shown >= 0)) return on_scale(scale, 1);  // no number
    largest = std::max(largest, std::abs(on_scale(scale, shown) - on_scale(scale, truth)));
  }
  return largest;
}

}  // namespace

std::string_view name(PixelPrecision precision) {
  return precision == PixelPrecision::float32 ? "float" : "half";
}

double float_rounding(const LobeForm& form, double factor, double sharpness, ShownScale scale) {
  constexpr double rest = 14;
  double of_lobe = 0;
  const double exponent = std::max(std::log2(factor), 1 / std::numbers::ln2);
  switch (form.kind) {
    case LobeKind::constant:
      break;
    case LobeKind::multiplied:
      of_lobe = form.whole;
      break;
    case LobeKind::exponential: {
      const auto roundings = static_cast<double>(2 * form.slopes.size() + 5);
      of_lobe = std::numbers::ln2 * (exponent * roundings + (form.is_fused ? sharpness : 0));
      break;
    }
    case LobeKind::power: {
      constexpr double roundings = 4 + 2 + 1;  // log2, the power, the product
      of_lobe = std::numbers::ln2 * exponent * roundings;
      break;
    }
  }
  return of_white(scale) * (of_lobe + rest) * unit;
}

double half_rounding(const LobeForm& form, std::span<const WeightedPower> lobes, ShownScale scale) {
  double largest = 0;
  for (const WeightedPower& lobe : lobes) largest = std::max(largest, half_rounding(form, lobe, scale));
  return largest;
}

}  // namespace shadefit::scene
