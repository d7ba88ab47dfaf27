#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lint/grade/grade.hpp"
#include "lint/known/known_set.hpp"
#include "lint/pins/pin.hpp"

/// Holds pinned numbers against the constants that they are pinned to.
namespace shadefit::lint {

struct JudgedPin {
  Pin pin;
  std::string fault = {};    ///< why it pins nothing: a sentence; empty: it pins a number
  std::size_t set = 0;       ///< of `sets`, unless there is a fault
  std::size_t constant = 0;  ///< of the set
  Grade digits = Grade::right;
  GradedSite graded = {};
  std::string replaced = {};  ///< why a value that stands here was replaced by its source
};

/// A pinned number is right with the published digits, with more that round to them, or with those of the
/// nearest float; signs do not count. Any other number is graded like one that was found, at worst by its
/// effect with the other constants as published. Where several sources published the constant, it may be the
/// number of any of them.
JudgedPin judge_pin(const Pin& pin, const std::vector<KnownSet>& sets, const EffectLimits& limits);

}  // namespace shadefit::lint
