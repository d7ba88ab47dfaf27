#pragma once

#include <string>

#include "fit/proof/constants.hpp"
#include "fit/scalars/symbolic.hpp"

namespace shadefit {

/// A formula with the values of constants; other variables stay.
Symbolic with_constants(const Symbolic& formula, const Constants& constants);

/// A constant's text in decimals: of a hexadecimal double its shortest decimal, any other text as it is.
std::string decimal_of(const std::string& text);

}  // namespace shadefit
