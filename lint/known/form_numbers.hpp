#pragma once

#include "lint/known/known_set.hpp"

namespace shadefit::lint {

/// Makes constants of the numbers that stand in the text of a form: 0.1003 in (0.1003 + b x)/(1 + m x). Each
/// comes before the constant that follows it in the form. Numbers of one or two digits and simple fractions
/// stay in the form: a program may write them in another way. So do those of a condition.
void name_form_numbers(KnownSet& set);

}  // namespace shadefit::lint
