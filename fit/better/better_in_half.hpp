#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fit/better/better.hpp"
#include "fit/rounding/rounding.hpp"
#include "fit/support/checkpoint.hpp"

/// The published curves on a GPU that computes in half: with rounded constants, and with the best constants
/// in half.
namespace shadefit {

struct CurveInHalf {
  std::string_view family;                        ///< the id
  std::string_view published;                     ///< the id of the first of the printed numbers
  std::optional<Rounded> rounded = std::nullopt;  ///< its members `published` and `best` are compared
  std::string reason = {};                        ///< why there is no result
};

/// One for each published curve of a comparison. The error is the largest over every half of the domain,
/// every operation rounded.
std::vector<CurveInHalf> curves_in_half(const Comparison& comparison,
                                        const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
