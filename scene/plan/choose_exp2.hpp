#pragma once

#include "scene/plan/shown_scale.hpp"

/// exp2 for a processor without an instruction for it.
namespace shadefit::scene {

struct ChosenExp2 {
  int degree;
  double error;  ///< of the displayed value of a light, proven
};

/// The polynomial of the lowest degree that changes no displayed value by more than `allowed`; the highest
/// degree if none is accurate enough.
ChosenExp2 choose_exp2(double allowed, ShownScale scale);

}  // namespace shadefit::scene
