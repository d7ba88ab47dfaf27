#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string>
#include <vector>

#include "fit/support/user_error.hpp"

namespace shadefit {

/// The one of `all` whose name the text is; throws UserError, naming the option and all of them, where none
/// is.
template <class T, std::size_t N>
T parse_name(const std::string& option, const std::string& text, const std::array<T, N>& all) {
  std::vector<std::string> known;
  for (const T& value : all) {
    if (text == name(value)) return value;
    known.emplace_back(name(value));
  }
  throw UserError(
      fmt::format("{} '{}' is unknown: it must be one of {}", option, text, fmt::join(known, ", ")));
}

}  // namespace shadefit
