#pragma once

#include "bench/forms/batch_lanes.hpp"
#include "bench/shading/kernels/full_loops.hpp"
#include "bench/shading/kernels/planned_loops.hpp"

/// The kernels of one unit.
namespace shadefit::shade {

template <class Architecture>
consteval Kernels kernels_of(forms::Width width) {
  using Floats = xsimd::batch<float, Architecture>;
  using Doubles = xsimd::batch<double, Architecture>;
  return {width, shade_with_all_terms<ReferenceForms, Doubles>, shade_with_all_terms<ReferenceForms, Floats>,
          shade_with_all_terms<PublishedForms, Floats>, shade_as_planned<Floats>};
}

}  // namespace shadefit::shade
