#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fit/study/measured_rows.hpp"
#include "fit/support/user_error.hpp"

// One input is a file of measured rows of the variable x.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shadefit;
  try {
    // In parts: the first byte tells their length.
    const std::size_t length = size == 0 ? 1 : std::size_t{1} + *data;
    std::string_view rest(reinterpret_cast<const char*>(data), size);
    const auto next = [&] {
      const std::string part(rest.substr(0, length));
      rest.remove_prefix(part.size());
      return part;
    };
    const MeasuredRows rows = read_measured_rows(next, "fuzzed", {"x"});
    if (rows.value.empty() || rows.value.size() != rows.places.front().size()) __builtin_trap();
  } catch (const UserError&) {
    return 0;  // refused, as bad input has to be
  }
  return 0;
}
