#include "reports/digest.hpp"

#include <array>
#include <boost/crc.hpp>
#include <cstdio>

namespace shadefit {

std::string digest_of(nlohmann::ordered_json json) {
  json.erase(digest_field);
  const std::string bytes = json.dump();
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  std::array<char, 9> text{};
  std::snprintf(text.data(), text.size(), "%08x", static_cast<unsigned>(crc.checksum()));
  return text.data();
}

}  // namespace shadefit
