#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "approx/exp2_polynomial.hpp"
#include "approx/fresnel.hpp"
#include "approx/gloss.hpp"
#include "approx/lobe.hpp"
#include "approx/scalar.hpp"
#include "approx/shading.hpp"

/// The two ways without a plan: every term for every material, as in one shader for all.
namespace shadefit::shade {

/// The published constants, each as a type, so that the choice is at compile time.
struct PublishedOffset {
  static constexpr const Published& record = sg_offset_published[0];
};
struct PublishedFresnelA {
  static constexpr const Published& record = fresnel_published[2];
};
struct PublishedFresnelB {
  static constexpr const Published& record = fresnel_published[3];
};
static_assert(PublishedOffset::record.id == "sg-offset-mean");
static_assert(PublishedFresnelA::record.id == "fresnel-quadratic-a");
static_assert(PublishedFresnelB::record.id == "fresnel-quadratic-b");

/// A published constant in the scalar T; machine numbers get it from the compiler, as in `exp2_coefficient`.
template <class P, class T>
T published_constant() {
  constexpr std::string_view printed = P::record.printed;
  if constexpr (requires { typename Scalar<T>::Real; }) {
    using Real = typename Scalar<T>::Real;
    constexpr bool is_negative = printed.starts_with('-');
    constexpr Real size = machine_number<Real>(printed.substr(is_negative ? 1 : 0));
    return Scalar<T>::of(is_negative ? -size : size);
  } else {
    return constant<T>(printed);
  }
}

/// The part of a power's computation that is shared by its lights.
template <class T>
struct PreparedPower {
  T lobe;           ///< the lobe's argument
  T normalisation;  ///< (n + 2)/8
};

/// c^n and Schlick's weight.
struct ReferenceForms {
  template <class T>
  static PreparedPower<T> prepared(const T& power) {
    return {power, game_normalisation(power)};
  }
  static auto lobe(const auto& n_dot_h, const auto& power) { return power_lobe(n_dot_h, power); }
  static auto weight(const auto& l_dot_h) { return schlick_weight(l_dot_h); }
};

/// The forms of the post: a Spherical Gaussian by exp2 with the mean offset, and exp2 of a quadratic for
/// Schlick's weight.
struct PublishedForms {
  template <class T>
  static PreparedPower<T> prepared(const T& power) {
    const T offset = published_constant<PublishedOffset, T>();
    return {(power + offset) * (integer<T>(1) / ln2<T>()), game_normalisation(power)};
  }
  static auto lobe(const auto& n_dot_h, const auto& base_two) {
    return gaussian_lobe_base_two(n_dot_h, base_two);
  }
  template <class T>
  static T weight(const T& l_dot_h) {
    const T a = published_constant<PublishedFresnelA, T>();
    const T b = published_constant<PublishedFresnelB, T>();
    return fresnel_quadratic(l_dot_h, a, b);
  }
};

/// The three channels of a sample.
template <class Forms, class T>
std::array<T, 3> specular(const T& n_dot_h, const T& l_dot_h, const T& n_dot_l, const PreparedPower<T>& power,
                          const std::array<T, 3>& f0, const std::array<T, 3>& f90) {
  const T lobe = Forms::lobe(n_dot_h, power.lobe), weight = Forms::weight(l_dot_h);
  const auto channel = [&](std::size_t i) {
    return shown_specular(reflectance_between(f0[i], f90[i], weight), power.normalisation, lobe, n_dot_l);
  };
  return {channel(0), channel(1), channel(2)};
}

}  // namespace shadefit::shade
