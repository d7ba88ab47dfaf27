#pragma once

#include <string_view>

namespace shadefit {

/// A binary format of IEEE 754. Its normal numbers are +-m 2^(e - digits + 1) with a whole m in
/// [2^(digits - 1), 2^digits) and e from `least_exponent` to `greatest_exponent`; below them the subnormal
/// ones have the spacing of the least.
struct BinaryFormat {
  std::string_view name;
  int digits;
  int least_exponent;
  int greatest_exponent;
};

inline constexpr BinaryFormat half_format{"half", 11, -14, 15};
inline constexpr BinaryFormat float_format{"float", 24, -126, 127};
inline constexpr BinaryFormat double_format{"double", 53, -1022, 1023};

}  // namespace shadefit
