#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fit/study/measured_rows.hpp"
#include "fit/support/user_error.hpp"

// One input is a file of measured rows of the variable x.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shadefit;
  try {
    const MeasuredRows rows =
        read_measured_rows({reinterpret_cast<const char*>(data), size}, "fuzzed", {"x"});
    if (rows.value.empty() || rows.value.size() != rows.places.front().size()) __builtin_trap();
  } catch (const UserError&) {
    return 0;  // refused, as bad input has to be
  }
  return 0;
}
