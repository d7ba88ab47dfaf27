#pragma once

#include <functional>
#include <string>

#include "fit/scalars/multiprecision.hpp"
#include "fit/scalars/symbolic.hpp"

namespace shadefit {

/// A symbolic expression in 50 digits; `value_of(name)` gives a variable. The same as `evaluate<Decimal50>`,
/// which takes five seconds to compile: so it is compiled once, here.
Decimal50 in_50_digits(const Symbolic& expression,
                       const std::function<Decimal50(const std::string&)>& value_of);

/// An expression of numbers alone. Throws std::logic_error, with the name, if it has a variable.
Decimal50 in_50_digits(const Symbolic& expression);

}  // namespace shadefit
