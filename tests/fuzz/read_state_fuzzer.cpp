#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "bench/exhaustive/state_file.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/digest.hpp"

namespace {

/// The text with the digest that its fields have, so that what lies behind the check of the digest is
/// reached.
std::string signed_again(const std::string& text) {
  auto json = nlohmann::ordered_json::parse(text, nullptr, false);
  if (!json.is_object()) return text;
  json.erase(shadefit::digest_field);
  json[shadefit::digest_field] = shadefit::digest_of(json);
  return json.dump();
}

}  // namespace

// One input is the state of an exhaustive search: refused, or read back as it was written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shadefit;
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const bool is_signed : {false, true}) {
    try {
      const bench::Sweep sweep = bench::parse_state(is_signed ? signed_again(text) : text, "a");
      const std::string written = bench::state_text(sweep);
      if (bench::state_text(bench::parse_state(written, "a")) != written) std::abort();
    } catch (const UserError&) {
      continue;  // refused, as bad input has to be
    }
  }
  return 0;
}
