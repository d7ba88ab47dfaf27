#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/proof/constants.hpp"
#include "fit/proof/interval.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"

namespace shadefit {

/// The value of a constant's text: a hexadecimal double exactly, a decimal number enclosed. Empty for other
/// text or beyond the range of a double.
inline std::optional<Interval> enclosed_constant(const std::string& text) {
  if (const auto exact = parse_hex(text)) return Interval(*exact);
  if (!parse_number(text)) return std::nullopt;
  return constant<Interval>(text);
}

/// The values of constants whose texts are valid.
inline std::vector<Interval> enclosed_constants(const Constants& constants) {
  std::vector<Interval> values;
  for (const auto& [name, text] : constants) values.push_back(enclosed_constant(text).value());
  return values;
}

}  // namespace shadefit
