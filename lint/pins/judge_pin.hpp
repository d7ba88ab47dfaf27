#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lint/grade/grade.hpp"
#include "lint/known/known_set.hpp"
#include "lint/pins/pin.hpp"

/// Compares pinned numbers with the constants that they are pinned to.
namespace shadefit::lint {

struct JudgedPin {
  Pin pin;
  std::string fault = {};    ///< why it pins nothing: a sentence; empty: it pins a number
  std::size_t set = 0;       ///< of `sets`, unless there is a fault
  std::size_t constant = 0;  ///< of the set
  Grade digits = Grade::right;
  GradedSite graded = {};
  std::string replaced = {};  ///< why the source replaced a value that is found here
};

/// A pinned number is right if it has the published digits, more digits that round to them, or those of the
/// nearest float; signs do not count. Any other number is graded like one that was found, at worst by its
/// effect with the other constants as published. If several sources published the constant, the number of any
/// of them will do.
JudgedPin judge_pin(const Pin& pin, const std::vector<KnownSet>& sets, const EffectLimits& limits);

}  // namespace shadefit::lint
