#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fit/better/better.hpp"
#include "fit/rounding/rounding.hpp"
#include "fit/support/checkpoint.hpp"

/// The published curves where a GPU computes in half: rounded as they are, and the best constants that half
/// can hold.
namespace shadefit {

struct CurveInHalf {
  std::string_view family;                        ///< the id
  std::string_view published;                     ///< the id of the first of the printed numbers
  std::optional<Rounded> rounded = std::nullopt;  ///< `published` and `best` of it are what is compared
  std::string reason = {};                        ///< why there is none
};

/// One for each published curve of a comparison. The error is the largest over every half of the domain,
/// every operation rounded.
std::vector<CurveInHalf> curves_in_half(const Comparison& comparison,
                                        const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
