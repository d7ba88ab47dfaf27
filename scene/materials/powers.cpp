#include "scene/materials/powers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "approx/gloss.hpp"
#include "approx/microfacet.hpp"

namespace shadefit::scene {
namespace {

/// The value of a texel's code.
double value_of_code(std::size_t code) {
  return static_cast<double>(code) / 255;
}

}  // namespace

double power_of_roughness(double stored, const Conventions& conventions) {
  const double roughness = std::max(stored, conventions.min_roughness);
  const double alpha = conventions.is_roughness_squared ? roughness * roughness : roughness;
  // The limit of the exponent, without a division by zero or by a subnormal number.
  if (alpha * alpha < std::numeric_limits<double>::min()) return std::numeric_limits<double>::infinity();
  return blinn_phong_exponent(alpha);
}

double power_of_gloss(double gloss, const Conventions& conventions) {
  if (conventions.is_gloss_exponential) return decode_gloss(gloss, 10.0, 1.0);
  return power_of_roughness(1 - gloss, conventions);
}

std::vector<PowerShare> power_shares(const Histogram& texels, double factor, const PowerOf& power) {
  std::map<double, std::uint64_t> counts;
  std::uint64_t all = 0;
  for (std::size_t code = 0; code < texels.size(); ++code) {
    if (texels[code] == 0) continue;
    counts[power(value_of_code(code) * factor)] += texels[code];
    all += texels[code];
  }
  std::vector<PowerShare> shares;
  for (const auto& [exponent, count] : counts)
    shares.push_back({exponent, static_cast<double>(count) / static_cast<double>(all)});
  return shares;
}

void take_powers(Material& material, std::vector<PowerShare> powers, PowerTexture texture) {
  material.power_texture = powers.size() > 1 ? texture : PowerTexture::none;
  material.powers = std::move(powers);
}

Histogram unknown_texture() {
  Histogram texels;
  texels.fill(1);
  return texels;
}

Range range_of_texture(const Histogram& texels, double factor) {
  const auto is_used = [](std::uint32_t count) { return count > 0; };
  const auto first = std::find_if(texels.begin(), texels.end(), is_used);
  const auto last = std::find_if(texels.rbegin(), texels.rend(), is_used);
  const auto least = static_cast<std::size_t>(first - texels.begin());
  const auto most = static_cast<std::size_t>(texels.rend() - last) - 1;
  return {value_of_code(least) * factor, value_of_code(most) * factor};
}

void limit_powers(Material& material, std::string_view what) {
  auto& powers = material.powers;
  const double largest = powers.back().power;
  if (largest <= most_power) return;
  double beyond = 0;
  while (!powers.empty() && powers.back().power >= most_power) {
    beyond += powers.back().share;
    powers.pop_back();
  }
  powers.push_back({most_power, beyond});
  material.remarks.push_back(fmt::format("{} = {:g} is taken for {:g}", what, largest, most_power));
}

}  // namespace shadefit::scene
