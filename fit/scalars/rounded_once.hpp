#pragma once

#include <array>
#include <functional>
#include <string>

#include "fit/scalars/symbolic.hpp"

namespace shadefit {

/// A symbolic expression in 50 digits, rounded once; `value_of(name)` gives a variable as a sum of two
/// numbers. For those who need no other use of 50 digits, whose header takes a second of a compiler.
long double rounded_once(const Symbolic& expression,
                         const std::function<std::array<long double, 2>(const std::string&)>& value_of);

/// An expression of numbers alone. Throws std::logic_error, with the name, if it has a variable.
long double rounded_once(const Symbolic& expression);

}  // namespace shadefit
