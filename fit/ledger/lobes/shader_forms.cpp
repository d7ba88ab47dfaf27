#include "fit/ledger/lobes/shader_forms.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "approx/arithmetic.hpp"
#include "approx/cost.hpp"
#include "approx/environment_map.hpp"
#include "approx/fresnel.hpp"
#include "approx/gloss.hpp"
#include "approx/lobe.hpp"
#include "fit/support/format.hpp"

namespace shadefit {
namespace {

Symbolic v(std::string_view name) {
  return Symbolic::variable(name);
}

Symbolic cosine() {
  return v("c");
}

/// x/ln 2 with the published mean offset: a number.
Symbolic offset_of_sharpness() {
  return base_two_power(constant<Symbolic>(sg_offset_published[0].printed));
}

Symbolic complement_of_cosine() {
  return integer<Symbolic>(1) - cosine();
}

/// The decode of the post: a power from 2 to 2048, or that power for exp2.
Symbolic decoded(const Symbolic& first) {
  return decode_gloss(v("g"), integer<Symbolic>(10), first);
}

Symbolic decoded_power() {
  return decoded(integer<Symbolic>(1));
}

Symbolic decoded_power_for_exp2() {
  return decoded(base_two_first(integer<Symbolic>(1)));
}

/// The normalisation (s + 2)/8 as one multiply-add: of s with the factor 1/8, of s/ln 2 with ln 2/8.
Symbolic normalisation(const Symbolic& power, const Symbolic& factor) {
  return base_two_normalisation(power, factor, integer<Symbolic>(1) / integer<Symbolic>(4));
}

Symbolic normalisation_of_power(const Symbolic& s) {
  return normalisation(s, integer<Symbolic>(1) / integer<Symbolic>(8));
}

Symbolic normalisation_of_sharpness(const Symbolic& a) {
  return normalisation(a, base_two_normalisation_factor<Symbolic>());
}

/// The specular term of the post: gloss decode, normalisation, lobe and their product.
Symbolic specular_by_pow() {
  const Symbolic s = decoded_power();
  return normalisation_of_power(s) * power_by_exp2(cosine(), s);
}

Symbolic specular_by_gaussian() {
  const Symbolic a = decoded_power_for_exp2();
  return normalisation_of_sharpness(a) * gaussian_lobe_base_two(cosine(), a);
}

/// (1-c)^n by exp2 and log2.
Symbolic schlick_by_pow(int n) {
  return power_by_exp2(complement_of_cosine(), integer<Symbolic>(n));
}

Symbolic mip_level_of_known_width(bool is_successor_given) {
  const auto width = integer<Symbolic>(128);  // any number: constants cost nothing
  return is_successor_given ? mip_level_of_successor(width, v("s1")) : mip_level_of_power(width, v("s"));
}

struct Form {
  std::string_view name;
  Symbolic (*result)();
};

constexpr std::array counted_forms{
    Form{"pow", [] { return power_by_exp2(cosine(), v("k")); }},
    Form{"gaussian", [] { return gaussian_lobe_base_two(cosine(), v("A")); }},
    Form{"gaussian-of-power", [] { return gaussian_lobe_base_two(cosine(), base_two_power(v("k"))); }},
    Form{"gaussian-with-offset",
         [] { return gaussian_lobe_base_two(cosine(), v("A") + offset_of_sharpness()); }},
    Form{"gloss-decode", decoded_power},
    Form{"gloss-decode-to-sharpness", decoded_power_for_exp2},
    Form{"normalisation", [] { return normalisation_of_power(v("s")); }},
    Form{"normalisation-of-sharpness", [] { return normalisation_of_sharpness(v("A")); }},
    Form{"specular-pow", specular_by_pow},
    Form{"specular-gaussian", specular_by_gaussian},
    Form{"schlick-pow", [] { return schlick_by_pow(5); }},
    Form{"reflectance-pow", [] { return schlick_reflectance(v("F0"), schlick_by_pow(5)); }},
    Form{"reflectance-one-term",
         [] { return schlick_reflectance(v("F0"), fresnel_one_term(cosine(), v("A"))); }},
    Form{"schlick-squaring", [] { return schlick_weight(cosine()); }},
    Form{"fresnel-one-term", [] { return fresnel_one_term(cosine(), v("A")); }},
    Form{"fresnel-quadratic", [] { return fresnel_quadratic(cosine(), v("a"), v("b")); }},
    Form{"power-four-exp2", [] { return schlick_by_pow(4); }},
    Form{"power-four-exp2-of-complement", [] { return power_by_exp2(v("y"), integer<Symbolic>(4)); }},
    Form{"power-four-squaring", [] { return power(complement_of_cosine(), 4); }},
    Form{"mip-level", [] { return mip_level_of_known_width(false); }},
    Form{"mip-level-of-successor", [] { return mip_level_of_known_width(true); }},
};

using Components = std::array<Symbolic, 3>;

Components vector(const std::string& name) {
  return {v(fmt::format("{}x", name)), v(fmt::format("{}y", name)), v(fmt::format("{}z", name))};
}

Symbolic phong_gaussian(const Components& light) {
  return phong_by_exp2(scaled_reflection(vector("r"), v("A")), light);
}

Symbolic phong_pow(const Components& light) {
  return power_by_exp2(phong_cosine(vector("r"), light), v("k"));
}

}  // namespace

std::vector<Symbolic> shader_form(std::string_view name, int lights) {
  for (const Form& form : counted_forms) {
    if (form.name == name) return {form.result()};
  }
  if (name != "phong-gaussian" && name != "phong-pow")
    throw std::invalid_argument(fmt::format("no shader form '{}'", name));
  std::vector<Symbolic> results;
  for (int i = 0; i < lights; ++i) {
    const Components light = vector(fmt::format("l{}", i));
    results.push_back(name == "phong-pow" ? phong_pow(light) : phong_gaussian(light));
  }
  return results;
}

}  // namespace shadefit
