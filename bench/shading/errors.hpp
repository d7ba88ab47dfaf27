#pragma once

#include <span>
#include <vector>

#include "bench/shading/ways.hpp"
#include "fit/support/checkpoint.hpp"
#include "scene/plan/shown_scale.hpp"

/// The errors of the ways: each sample under one light, against the reference.
namespace shadefit::shade {

/// Over all samples and channels.
struct Errors {
  double most = 0, mean = 0;              ///< in linear values
  double most_codes = 0, mean_codes = 0;  ///< in 8-bit sRGB codes, not rounded

  double most_on(scene::ShownScale scale) const {
    return scale == scene::ShownScale::linear ? most : most_codes;
  }
};

/// The errors of each way.
std::vector<Errors> errors_of(const Workload& workload, const ReferenceWay& reference,
                              std::span<const Way> ways, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit::shade
