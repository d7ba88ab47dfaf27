#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace shadefit {

/// The field that holds the digest of the others.
inline constexpr const char* digest_field = "digest";

/// CRC-32, as in zip and PNG.
unsigned crc_of(std::string_view bytes);

/// The CRC-32 of a file's fields but the digest, compact and in their order, in hexadecimal.
/// It finds accidents: a changed digit, a lost line.
std::string digest_of(nlohmann::ordered_json json);

}  // namespace shadefit
