#pragma once

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace shadefit {

/// CRC-32, as in zip and PNG.
inline unsigned crc_of(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return static_cast<unsigned>(crc.checksum());
}

/// The field that holds the digest of the others.
inline constexpr const char* digest_field = "digest";

/// The CRC-32 of a file's fields but the digest, compact and in their order, in hexadecimal.
/// It finds accidents: a changed digit, a lost line.
inline std::string digest_of(nlohmann::ordered_json json) {
  json.erase(digest_field);
  return fmt::format("{:08x}", crc_of(json.dump()));
}

}  // namespace shadefit
