#include "fit/formula/named_formulas.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "approx/encoding.hpp"
#include "approx/fresnel.hpp"
#include "approx/gloss.hpp"
#include "approx/lobe.hpp"
#include "approx/phase.hpp"
#include "approx/phong_blinn.hpp"
#include "approx/von_mises_fisher.hpp"

namespace shadefit {
namespace {

/// A template of approx/ with the names of its arguments.
template <class... T>
NamedFormula recorded(std::string_view name, Symbolic (*formula)(const T&...),
                      const std::vector<std::string>& arguments) {
  const auto at_variables = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return formula(Symbolic::variable(arguments.at(I))...);
  };
  return {name, {arguments, at_variables(std::index_sequence_for<T...>{})}};
}

std::vector<NamedFormula> record_all() {
  using S = Symbolic;
  return {
      recorded("power_lobe", &power_lobe<S>, {"c", "k"}),
      recorded("power_lobe_near_peak", &power_lobe_near_peak<S>, {"y", "k"}),
      recorded("gaussian_lobe", &gaussian_lobe<S>, {"c", "k", "x"}),
      recorded("gaussian_lobe_near_peak", &gaussian_lobe_near_peak<S>, {"y", "k", "x"}),
      recorded("scaled_gaussian_lobe", &scaled_gaussian_lobe<S>, {"c", "k", "A", "x"}),
      recorded("lobe_log_ratio", &lobe_log_ratio<S>, {"c", "y", "k"}),
      recorded("lobe_error", &lobe_error<S>, {"base", "change", "ratio_minus_one"}),
      recorded("scaled_lobe_error", &scaled_lobe_error<S>, {"base", "A", "change", "ratio_minus_one"}),
      recorded("half_angle_power", &half_angle_power<S>, {"y", "k"}),
      recorded("blinn_lobe", &blinn_lobe<S>, {"y", "k", "x"}),
      recorded("blinn_lobe_of_cosine", &blinn_lobe_of_cosine<S>, {"c", "k", "x"}),
      recorded("log_half_cosine", &log_half_cosine<S>, {"y", "half_remainder"}),
      recorded("phong_blinn_log_ratio", &phong_blinn_log_ratio<S>, {"lobe_log_ratio", "half_remainder", "k"}),
      recorded("schlick_weight", &schlick_weight<S>, {"c"}),
      recorded("schlick_reflectance", &schlick_reflectance<S>, {"f0", "weight"}),
      recorded("schlick_reflectance_of_gloss", &schlick_reflectance_of_gloss<S>, {"f0", "g", "weight"}),
      recorded("weight_of_reflectance", &weight_of_reflectance<S>, {"F", "f0"}),
      recorded("reflectance_at_normal", &reflectance_at_normal<S>, {"n"}),
      recorded("dielectric_reflectance", &dielectric_reflectance<S>, {"c", "n"}),
      recorded("conductor_reflectance_at_normal", &conductor_reflectance_at_normal<S>, {"n", "k"}),
      recorded("fresnel_one_term", &fresnel_one_term<S>, {"c", "A"}),
      recorded("fresnel_quadratic", &fresnel_quadratic<S>, {"c", "a", "b"}),
      recorded("fresnel_cubic", &fresnel_cubic<S>, {"c", "a", "b", "d"}),
      recorded("fresnel_quartic", &fresnel_quartic<S>, {"c", "a", "b", "d", "g"}),
      recorded("fresnel_fourth", &fresnel_fourth<S>, {"c", "s"}),
      recorded("fresnel_square", &fresnel_square<S>, {"c", "a", "b"}),
      recorded("fresnel_rational", &fresnel_rational<S>, {"c", "a"}),
      recorded("henyey_greenstein", &henyey_greenstein<S>, {"c", "g"}),
      recorded("schlick_phase", &schlick_phase<S>, {"c", "k"}),
      recorded("von_mises_fisher", &von_mises_fisher<S>, {"c", "k"}),
      recorded("srgb_encode", &srgb_encode<S>, {"x"}),
      recorded("srgb_decode", &srgb_decode<S>, {"x"}),
      recorded("gaussian_lobe_base_two", &gaussian_lobe_base_two<S>, {"c", "a"}),
  };
}

}  // namespace

std::span<const NamedFormula> named_formulas() {
  static const std::vector<NamedFormula> all = record_all();
  return all;
}

const NamedFormula* find_formula(std::string_view name) {
  const auto all = named_formulas();
  const auto found = std::ranges::find(all, name, &NamedFormula::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace shadefit
