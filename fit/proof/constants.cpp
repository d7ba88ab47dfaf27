#include "fit/proof/constants.hpp"

#include <algorithm>

#include "fit/proof/enclosed_constant.hpp"

namespace shadefit {

std::string fault_of_constants(const Constants& given, std::span<const std::string> known,
                               const std::string& form) {
  for (const auto& [name, value] : given) {
    if (std::ranges::find(known, name) == known.end())
      return "parameter '" + name + "' is unknown: " + form + " has none of that name";
    if (enclosed_constant(value)) continue;
    const bool is_hexadecimal = value.find("0x") != std::string::npos;
    return "parameter " + name + " '" + value + "' is not " +
           (is_hexadecimal ? "a hexadecimal double as shadefit prints it" : "a finite number");
  }
  for (const std::string& name : known) {
    const auto count = std::ranges::count(given, name, [](const auto& p) { return p.first; });
    if (count == 0) return "parameter '" + name + "' of " + form + " is missing";
    if (count > 1) return "parameter '" + name + "' is given twice";
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i].first != known[i]) return "parameter '" + given[i].first + "' is out of order";
  }
  return "";
}

Constants in_order(Constants given, std::span<const std::string> known) {
  const auto rank = [&](const auto& constant) {
    return std::ranges::find(known, constant.first) - known.begin();
  };
  std::ranges::stable_sort(given, {}, rank);
  return given;
}

}  // namespace shadefit
