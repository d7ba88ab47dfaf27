#include "bench/shading/measure.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

#include "approx/microfacet.hpp"
#include "bench/shading/kernels/full_terms.hpp"
#include "fit/scalars/symbolic.hpp"

namespace shadefit::shade {
namespace {

Symbolic variable(const char* name) {
  return Symbolic::variable(name);
}

std::array<Symbolic, 3> channels(const std::string& name) {
  return {Symbolic::variable(name + "r"), Symbolic::variable(name + "g"), Symbolic::variable(name + "b")};
}

/// Instructions, EXP2 and LOG2 counted as four each, as `choose_lobe` counts.
int cost_of(std::span<const Symbolic> results) {
  const Operations counted = count_operations(results);
  return counted.total() + 3 * (counted.exp2 + counted.log2);
}

Symbolic decoded_power() {
  return blinn_phong_exponent(variable("alpha"));
}

/// The lobe of a plan; constants of a material are variables.
Symbolic lobe_of(const PlannedMaterial& m) {
  scene::LobeConstants<Symbolic> constants;
  for (int i = 0; i < m.slope_count; ++i)
    constants.slopes.push_back(Symbolic::variable("s" + std::to_string(i)));
  if (m.is_power_of_pixel)
    constants.exponent = m.offset == 0 ? decoded_power() : decoded_power() + variable("x");
  else if (m.kind == scene::LobeKind::power)
    constants.exponent = variable("n");
  return scene::planned_lobe({.kind = m.kind, .whole = m.whole, .is_fused = m.is_fused}, variable("c"),
                             constants);
}

}  // namespace

int full_operations(bool is_power_of_pixel) {
  const Symbolic power = variable("n");
  const PreparedPower<Symbolic> prepared = is_power_of_pixel
                                               ? ReferenceForms::prepared(decoded_power())
                                               : PreparedPower<Symbolic>{power, variable("normalisation")};
  const auto shown = specular<ReferenceForms>(variable("c"), variable("l.h"), variable("n.l"), prepared,
                                              channels("f0"), channels("f90"));
  return cost_of(shown);
}

int planned_operations(const PlannedMaterial& m) {
  const Symbolic lobe = lobe_of(m), n_dot_l = variable("n.l");
  const Symbolic light = m.kind == scene::LobeKind::constant ? n_dot_l : seen_light(n_dot_l, variable("c"));
  const auto f0 = channels("f0"), f90 = channels("f90");
  std::vector<Symbolic> shown;
  for (std::size_t i = 0; i < (m.is_coloured ? 3U : 1U); ++i) {
    const Symbolic reflectance =
        m.has_fresnel ? reflectance_between(f0[i], f90[i], schlick_weight(variable("l.h"))) : f0[i];
    // A material's normalisation is within its reflectances.
    shown.push_back(m.is_power_of_pixel
                        ? shown_specular(reflectance, game_normalisation(decoded_power()), lobe, light)
                        : min(reflectance * lobe * light, integer<Symbolic>(1)));
  }
  return cost_of(shown);
}

}  // namespace shadefit::shade
