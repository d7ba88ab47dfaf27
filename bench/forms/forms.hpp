#pragma once

#include <array>
#include <cstddef>

#include "approx/arithmetic.hpp"
#include "approx/exp2_polynomial.hpp"
#include "approx/fresnel.hpp"
#include "approx/gloss.hpp"
#include "approx/light_sum.hpp"
#include "approx/lobe.hpp"
#include "approx/phase.hpp"
#include "approx/phong_blinn.hpp"

/// The timed forms. Each joins a formula of approx/ with its precomputation, done once per array.
///
/// A form brings
/// - `id`; `arguments`: what it reads of each element; `has_exp2`: see `FormOf`;
/// - `parameters`: how many numbers it is given, those of its target before its own;
/// - `prepared`: those from which an element is computed, of the parameters, once;
/// - a call operator, the formula, over any scalar.
namespace shadefit::forms {

/// The inputs of a form for each element.
enum class Arguments {
  cosine,            ///< c
  cosine_and_code,   ///< c and an 8-bit gloss
  normal_to_lights,  ///< a normal, for each of the lights that are among the parameters
};

/// What a form reads, how many numbers it is given, and whether it needs an exp2 and no other function, so
/// that a polynomial can replace it.
template <Arguments A, std::size_t N, bool by_exp2 = false>
struct FormOf {
  static constexpr Arguments arguments = A;
  static constexpr std::size_t parameters = N;
  static constexpr bool has_exp2 = by_exp2;
};

/// A form of the cosine whose constants are used as they are given.
template <std::size_t N, bool by_exp2 = false>
struct AsGiven : FormOf<Arguments::cosine, N, by_exp2> {
  template <class T>
  static std::array<T, N> prepared(const std::array<T, N>& p) {
    return p;
  }
};

// The lobe c^k: k, then the form's.

struct LobePower : AsGiven<1> {
  static constexpr const char* id = "lobe-pow";
  auto operator()(const auto& c, const auto& p) const { return power_lobe(c, p[0]); }
};

/// c^k as a GPU computes it.
struct LobeExp2Log2 : AsGiven<1> {
  static constexpr const char* id = "lobe-exp2-log2";
  auto operator()(const auto& c, const auto& p) const { return power_by_exp2(c, p[0]); }
};

/// c^16 by four squarings; k has to be 16.
struct LobeSquarings : AsGiven<1> {
  static constexpr const char* id = "lobe-squarings";
  static constexpr int exponent = 16;
  auto operator()(const auto& c, const auto&) const { return power(c, exponent); }
};

/// exp2(A c - A), A = (k + x)/ln 2.
struct LobeGaussian : FormOf<Arguments::cosine, 2, true> {  // k, x
  static constexpr const char* id = "sg";
  template <class T>
  static std::array<T, 1> prepared(const std::array<T, 2>& p) {
    return {base_two_power(T(p[0] + p[1]))};
  }
  auto operator()(const auto& c, const auto& p) const { return gaussian_lobe_base_two(c, p[0]); }
};

/// exp2(A (c - 1)): the same, robust near the peak.
struct LobeGaussianOfDifference : LobeGaussian {
  static constexpr const char* id = "sg-difference";
  auto operator()(const auto& c, const auto& p) const {
    return gaussian_lobe_base_two_of_difference(c, p[0]);
  }
};

/// s exp2(A c - A).
struct LobeScaledGaussian : FormOf<Arguments::cosine, 3, true> {  // k, s, x
  static constexpr const char* id = "sg-scaled";
  template <class T>
  static std::array<T, 2> prepared(const std::array<T, 3>& p) {
    return {p[1], base_two_power(T(p[0] + p[2]))};
  }
  template <class T>
  T operator()(const T& c, const std::array<T, 2>& p) const {
    return p[0] * gaussian_lobe_base_two(c, p[1]);
  }
};

/// The Phong lobe by Blinn's, ((1 + c)/2)^(x k/2).
struct LobeBlinn : AsGiven<2> {  // k, x
  static constexpr const char* id = "phong-blinn";
  auto operator()(const auto& c, const auto& p) const { return blinn_lobe_of_cosine(c, p[0], p[1]); }
};

// The lobe with k = 2^(d g + f), g = code/255: d, f, then the form's.

/// 255, the largest code.
template <class T>
T largest_code() {
  return integer<T>(255);
}

struct GlossPower : FormOf<Arguments::cosine_and_code, 2> {
  static constexpr const char* id = "gloss-pow";
  /// The doublings of one code.
  template <class T>
  static std::array<T, 2> prepared(const std::array<T, 2>& p) {
    return {p[0] / largest_code<T>(), p[1]};
  }
  auto operator()(const auto& c, const auto& code, const auto& p) const {
    return power_lobe(c, decode_gloss(code, p[0], p[1]));
  }
};

/// exp2(A c - A), A = 2^(d g + m) + x/ln 2; m, the `base_two_first` of f, is a constant of the form.
struct GlossGaussian : FormOf<Arguments::cosine_and_code, 4, true> {  // d, f, m, x
  static constexpr const char* id = "gloss-sg";
  template <class T>
  static std::array<T, 3> prepared(const std::array<T, 4>& p) {
    return {p[0] / largest_code<T>(), p[2], base_two_power(p[3])};
  }
  template <class T>
  static T base_two(const T& code, const std::array<T, 3>& p) {
    return decode_gloss(code, p[0], p[1]) + p[2];
  }
  auto operator()(const auto& c, const auto& code, const auto& p) const {
    return gaussian_lobe_base_two(c, base_two(code, p));
  }
};

// Schlick's weight (1-c)^5.

struct SchlickPower : AsGiven<0> {
  static constexpr const char* id = "schlick-pow";
  template <class T>
  T operator()(const T& c, const std::array<T, 0>&) const {
    return power(T(integer<T>(1) - c), integer<T>(5));
  }
};

/// By three multiplications.
struct SchlickMultiplied : AsGiven<0> {
  static constexpr const char* id = "schlick";
  auto operator()(const auto& c, const auto&) const { return schlick_weight(c); }
};

struct FresnelOneTermForm : AsGiven<1, true> {
  static constexpr const char* id = "fresnel-one-term";
  auto operator()(const auto& c, const auto& p) const { return fresnel_one_term(c, p[0]); }
};

struct FresnelQuadraticForm : AsGiven<2, true> {
  static constexpr const char* id = "fresnel-quadratic";
  auto operator()(const auto& c, const auto& p) const { return fresnel_quadratic(c, p[0], p[1]); }
};

struct FresnelCubicForm : AsGiven<3, true> {
  static constexpr const char* id = "fresnel-cubic";
  auto operator()(const auto& c, const auto& p) const { return fresnel_cubic(c, p[0], p[1], p[2]); }
};

struct FresnelQuarticForm : AsGiven<4, true> {
  static constexpr const char* id = "fresnel-quartic";
  auto operator()(const auto& c, const auto& p) const { return fresnel_quartic(c, p[0], p[1], p[2], p[3]); }
};

struct FresnelFourthForm : AsGiven<1> {
  static constexpr const char* id = "fresnel-fourth";
  auto operator()(const auto& c, const auto& p) const { return fresnel_fourth(c, p[0]); }
};

struct FresnelSquareForm : AsGiven<2> {
  static constexpr const char* id = "fresnel-square";
  auto operator()(const auto& c, const auto& p) const { return fresnel_square(c, p[0], p[1]); }
};

struct FresnelRationalForm : AsGiven<1> {
  static constexpr const char* id = "fresnel-rational";
  auto operator()(const auto& c, const auto& p) const { return fresnel_rational(c, p[0]); }
};

// Phase functions: g, then the form's.

struct HenyeyGreensteinPower : AsGiven<1> {
  static constexpr const char* id = "hg-pow";
  auto operator()(const auto& c, const auto& p) const { return henyey_greenstein(c, p[0]); }
};

struct HenyeyGreensteinRoot : AsGiven<1> {
  static constexpr const char* id = "hg-sqrt";
  auto operator()(const auto& c, const auto& p) const { return henyey_greenstein_by_sqrt(c, p[0]); }
};

struct SchlickPhase : FormOf<Arguments::cosine, 3> {  // g, a, b
  static constexpr const char* id = "schlick-phase";
  template <class T>
  static std::array<T, 1> prepared(const std::array<T, 3>& p) {
    return {schlick_phase_parameter(p[0], p[1], p[2])};
  }
  auto operator()(const auto& c, const auto& p) const { return schlick_phase(c, p[0]); }
};

// The sum of the highlights of lights: k, x, y and z of each light, then the form's. `prepared` and the
// formula are of one light: k, x, y, z, then the form's.

struct PhongPower : FormOf<Arguments::normal_to_lights, 4> {
  static constexpr const char* id = "phong-pow";
  template <class T>
  static std::array<T, 4> prepared(const std::array<T, 4>& p) {
    return {p[1], p[2], p[3], p[0]};
  }
  auto operator()(const auto& normal, const auto& p) const {
    return power_lobe(lit_cosine(normal, {p[0], p[1], p[2]}), p[3]);
  }
};

/// n.l^16 by four squarings; k has to be 16.
struct PhongSquarings : PhongPower {
  static constexpr const char* id = "phong-squarings";
  auto operator()(const auto& normal, const auto& p) const {
    return power(lit_cosine(normal, {p[0], p[1], p[2]}), LobeSquarings::exponent);
  }
};

struct PhongGaussian : FormOf<Arguments::normal_to_lights, 5, true> {  // and x
  static constexpr const char* id = "phong-sg";
  template <class T>
  static std::array<T, 4> prepared(const std::array<T, 5>& p) {
    return scaled_light({p[1], p[2], p[3]}, base_two_power(T(p[0] + p[4])));
  }
  auto operator()(const auto& normal, const auto& p) const { return highlight_by_exp2(normal, p); }
};

/// Sixteen multiply-adds, each of which waits for the one before: the unit of every time. A polynomial
/// of degree 16 by Horner's rule, from [0, 1] to [0, 1].
struct MultiplyAdds : AsGiven<0> {
  static constexpr const char* id = "multiply-adds";
  static constexpr int count = 16;
  /// The highest coefficient, and four that come again and again: exact in half, and 1 in sum.
  template <class T>
  static std::array<T, 5> prepared(const std::array<T, 0>&) {
    const auto part = [](int n) { return T(integer<T>(n) / integer<T>(64)); };
    return {part(16), part(1), part(2), part(3), part(6)};
  }
  template <class T>
  T operator()(const T& c, const std::array<T, 5>& p) const {
    T value = p[0];
    for (int i = 0; i < count; ++i) value = value * c + p[static_cast<std::size_t>(1 + i % 4)];
    return value;
  }
};

template <class... Forms>
struct FormList {};

/// The forms of the catalogue, target by target.
using AllForms =
    FormList<LobePower, LobeExp2Log2, LobeSquarings, LobeGaussian, LobeGaussianOfDifference,
             LobeScaledGaussian, LobeBlinn, GlossPower, GlossGaussian, SchlickPower, SchlickMultiplied,
             FresnelOneTermForm, FresnelQuadraticForm, FresnelCubicForm, FresnelQuarticForm,
             FresnelFourthForm, FresnelSquareForm, FresnelRationalForm, HenyeyGreensteinPower,
             HenyeyGreensteinRoot, SchlickPhase, PhongPower, PhongSquarings, PhongGaussian>;

}  // namespace shadefit::forms
