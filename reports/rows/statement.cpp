#include "reports/rows/statement.hpp"

#include <fmt/format.h>

#include "fit/support/hex_float.hpp"

namespace shadefit {

std::string decimal_of(const std::string& text) {
  const auto exact = parse_hex(text);
  return exact ? fmt::format("{}", *exact) : text;
}

Symbolic with_constants(const Symbolic& formula, const Constants& constants) {
  return evaluate<Symbolic>(formula, [&](const std::string& variable) {
    for (const auto& [name, text] : constants) {
      if (name == variable) return Symbolic::number(decimal_of(text));
    }
    return Symbolic::variable(variable);
  });
}

}  // namespace shadefit
