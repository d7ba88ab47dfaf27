#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fit/ledger/claim.hpp"

/// Named conversions of a code of an 8-bit texture to linear light. The records on colour charts are judged
/// under these.
namespace shadefit {

struct TransferFunction {
  std::string name;    ///< as the record writes it
  double gamma = 0;    ///< the exponent of a power; 0: the sRGB function
  double codes = 255;  ///< the divisor of a code
};

/// "sRGB", "gamma 2.2", each with or without " of code/256" (without it 255). Throws std::invalid_argument
/// for anything else.
TransferFunction transfer_function(std::string_view name);

/// The inputs "convention", that of stored codes, and "other conventions" of a record.
std::vector<TransferFunction> conventions_of(const Claim& claim);

}  // namespace shadefit
