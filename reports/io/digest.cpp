#include "reports/io/digest.hpp"

#include <array>
#include <boost/crc.hpp>
#include <cstdio>

namespace shadefit {

unsigned crc_of(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return static_cast<unsigned>(crc.checksum());
}

std::string digest_of(nlohmann::ordered_json json) {
  json.erase(digest_field);
  std::array<char, 9> text{};
  std::snprintf(text.data(), text.size(), "%08x", crc_of(json.dump()));
  return text.data();
}

}  // namespace shadefit
