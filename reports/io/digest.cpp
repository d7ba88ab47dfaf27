#include "reports/io/digest.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>

namespace shadefit {

unsigned crc_of(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return static_cast<unsigned>(crc.checksum());
}

std::string digest_of(nlohmann::ordered_json json) {
  json.erase(digest_field);
  return fmt::format("{:08x}", crc_of(json.dump()));
}

}  // namespace shadefit
