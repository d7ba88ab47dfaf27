#pragma once

#include "scene/plan/shown_scale.hpp"

/// The exp2 of a processor that has no instruction for it.
namespace shadefit::scene {

struct ChosenExp2 {
  int degree;
  double error;  ///< of what is shown of a light, proven
};

/// The polynomial of the least degree that moves no value that is shown by more than `allowed`; the largest
/// of all where none is that near.
ChosenExp2 choose_exp2(double allowed, ShownScale scale);

}  // namespace shadefit::scene
