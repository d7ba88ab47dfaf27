#pragma once

#include "fit/study/study_fit.hpp"
#include "fit/study_squares/rules.hpp"

/// The optimum of a form that is linear in its parameters, where Newton's method loses digits.
namespace shadefit {

/// The optimum of a form that is linear in all parameters, by one rule after the other.
StudyFit settle_linear(const Rules& rules);

}  // namespace shadefit
