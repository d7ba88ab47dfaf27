#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "approx/arithmetic.hpp"
#include "approx/fresnel.hpp"
#include "approx/gloss.hpp"
#include "approx/light_sum.hpp"
#include "approx/lobe.hpp"
#include "approx/phase.hpp"
#include "approx/phong_blinn.hpp"

/// The timed forms, by the formulas of approx/.
namespace shadefit::forms {

/// The inputs of a form for each element.
enum class Arguments {
  cosine,            ///< c
  cosine_and_code,   ///< c and an 8-bit gloss
  normal_to_lights,  ///< a normal, for each of the lights that are among the parameters
};

/// The power of the fixed lobe and of the highlights: 2^4, which four squarings compute.
inline constexpr int fixed_exponent = 16;

template <class Formula>
struct Form {
  const char* id;
  Arguments arguments;  ///< what it reads of each element
  /// Whether it needs an exp2 and no other function, so that a polynomial can replace it.
  bool has_exp2;
  /// How many numbers it is given: those of its target, then its own. A target of lights has k, then x, y and
  /// z for each of them; the formula gets those of one light.
  std::size_t parameters;
  Formula formula;  ///< of the inputs and the parameters, over any scalar
};
template <class Formula>
Form(const char*, Arguments, bool, std::size_t, Formula) -> Form<Formula>;

/// The forms, target by target.
inline constexpr std::tuple all_forms{
    // The lobe c^k: k, then the form's.
    Form{"lobe-pow", Arguments::cosine, false, 1,
         [](const auto& c, const auto& p) { return power_lobe(c[0], p[0]); }},
    // c^k as a GPU computes it.
    Form{"lobe-exp2-log2", Arguments::cosine, false, 1,
         [](const auto& c, const auto& p) { return power_by_exp2(c[0], p[0]); }},
    Form{"lobe-squarings", Arguments::cosine, false, 1,
         [](const auto& c, const auto&) { return power(c[0], fixed_exponent); }},
    // exp2(A c - A), A = (k + x)/ln 2.
    Form{"sg", Arguments::cosine, true, 2,  // k, x
         []<class T>(const std::array<T, 1>& c, const auto& p) {
           return gaussian_lobe_base_two(c[0], base_two_power(T(p[0] + p[1])));
         }},
    // exp2(A (c - 1)): the same, robust near the peak.
    Form{"sg-difference", Arguments::cosine, true, 2,  // k, x
         []<class T>(const std::array<T, 1>& c, const auto& p) {
           return gaussian_lobe_base_two_of_difference(c[0], base_two_power(T(p[0] + p[1])));
         }},
    // s exp2(A c - A).
    Form{"sg-scaled", Arguments::cosine, true, 3,  // k, s, x
         []<class T>(const std::array<T, 1>& c, const auto& p) -> T {
           return p[1] * gaussian_lobe_base_two(c[0], base_two_power(T(p[0] + p[2])));
         }},
    // The Phong lobe by Blinn's, ((1 + c)/2)^(x k/2).
    Form{"phong-blinn", Arguments::cosine, false, 2,  // k, x
         [](const auto& c, const auto& p) { return blinn_lobe_of_cosine(c[0], p[0], p[1]); }},

    // The lobe with k = 2^(d g + f), g = code/255: d, f, then the form's.
    Form{"gloss-pow", Arguments::cosine_and_code, false, 2,
         []<class T>(const std::array<T, 2>& in, const auto& p) {
           return power_lobe(in[0], decode_gloss(in[1], T(p[0] / integer<T>(255)), p[1]));
         }},
    // exp2(A c - A), A = 2^(d g + m) + x/ln 2; m, the `base_two_first` of f, is a constant of the form.
    Form{"gloss-sg", Arguments::cosine_and_code, true, 4,  // d, f, m, x
         []<class T>(const std::array<T, 2>& in, const auto& p) {
           const T base_two = decode_gloss(in[1], T(p[0] / integer<T>(255)), p[2]) + base_two_power(p[3]);
           return gaussian_lobe_base_two(in[0], base_two);
         }},

    // Schlick's weight (1-c)^5.
    Form{"schlick-pow", Arguments::cosine, false, 0,
         []<class T>(const std::array<T, 1>& c, const auto&) {
           return power(T(integer<T>(1) - c[0]), integer<T>(5));
         }},
    // By three multiplications.
    Form{"schlick", Arguments::cosine, false, 0,
         [](const auto& c, const auto&) { return schlick_weight(c[0]); }},
    Form{"fresnel-one-term", Arguments::cosine, true, 1,
         [](const auto& c, const auto& p) { return fresnel_one_term(c[0], p[0]); }},
    Form{"fresnel-quadratic", Arguments::cosine, true, 2,
         [](const auto& c, const auto& p) { return fresnel_quadratic(c[0], p[0], p[1]); }},
    Form{"fresnel-cubic", Arguments::cosine, true, 3,
         [](const auto& c, const auto& p) { return fresnel_cubic(c[0], p[0], p[1], p[2]); }},
    Form{"fresnel-quartic", Arguments::cosine, true, 4,
         [](const auto& c, const auto& p) { return fresnel_quartic(c[0], p[0], p[1], p[2], p[3]); }},
    Form{"fresnel-fourth", Arguments::cosine, false, 1,
         [](const auto& c, const auto& p) { return fresnel_fourth(c[0], p[0]); }},
    Form{"fresnel-square", Arguments::cosine, false, 2,
         [](const auto& c, const auto& p) { return fresnel_square(c[0], p[0], p[1]); }},
    Form{"fresnel-rational", Arguments::cosine, false, 1,
         [](const auto& c, const auto& p) { return fresnel_rational(c[0], p[0]); }},

    // Phase functions: g, then the form's.
    Form{"hg-pow", Arguments::cosine, false, 1,
         [](const auto& c, const auto& p) { return henyey_greenstein(c[0], p[0]); }},
    Form{"hg-sqrt", Arguments::cosine, false, 1,
         [](const auto& c, const auto& p) { return henyey_greenstein_by_sqrt(c[0], p[0]); }},
    Form{"schlick-phase", Arguments::cosine, false, 3,  // g, a, b
         [](const auto& c, const auto& p) {
           return schlick_phase(c[0], schlick_phase_parameter(p[0], p[1], p[2]));
         }},

    // The highlight of a light: k, x, y, z, then the form's.
    Form{"phong-pow", Arguments::normal_to_lights, false, 4,
         [](const auto& normal, const auto& p) {
           return power_lobe(lit_cosine(normal, {p[1], p[2], p[3]}), p[0]);
         }},
    Form{"phong-squarings", Arguments::normal_to_lights, false, 4,
         [](const auto& normal, const auto& p) {
           return power(lit_cosine(normal, {p[1], p[2], p[3]}), fixed_exponent);
         }},
    Form{"phong-sg", Arguments::normal_to_lights, true, 5,  // and x
         []<class T>(const std::array<T, 3>& normal, const auto& p) {
           return highlight_by_exp2(normal, scaled_light({p[1], p[2], p[3]}, base_two_power(T(p[0] + p[4]))));
         }},
};

}  // namespace shadefit::forms
