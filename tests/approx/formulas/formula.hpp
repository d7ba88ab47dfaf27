#pragma once

#include <vector>

#include "approx/microfacet.hpp"
#include "approx/reflectance.hpp"
#include "approx/scalar.hpp"

/// A row of the table of formulas, which are tested over every scalar. This folder has two files of them.
namespace shadefit::testing {

/// Rows of decimal texts.
using Rows = std::vector<std::vector<const char*>>;

/// A formula as a callable on any scalar, with arguments that every scalar (half included) holds exactly, and
/// the relative error in units of the scalar's epsilon that rounding may cause: an exponential multiplies the
/// rounding of its argument by that argument, a difference by the ratio of its terms to it.
template <class F>
struct Formula {
  const char* name;
  F call;
  Rows arguments;
  double epsilons;
};

/// For the row of a formula: the name of a function and a call of it, of which `PART_OF` takes a member.
#define OF(function) #function, [](auto... a) -> decltype(function(a...)) { return function(a...); }
#define PART_OF(function, member) \
#function "." #member, [](auto... a) -> decltype(function(a...).member) { return function(a...).member; }
/// The same for a constant, times 1.
#define CONSTANT(function)                                                    \
#function, [](auto one) { return one * function<decltype(one)>(); }, Rows { \
    { "1" }                                                                   \
  }

template <class F>
Formula(const char*, F, Rows, double) -> Formula<F>;

template <class T>
Arc<T> arc_to(const T& angle) {
  return {angle, sin(angle), cos(angle)};
}

template <class T>
Direction<T> direction_of(const T& angle) {
  return {cos(angle), sin(angle)};
}

template <class T>
MicrofacetNormal<T> normal_of(const T& cos2) {
  return {cos2, integer<T>(1) - cos2};
}

}  // namespace shadefit::testing
