#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "fit/least_squares/weight.hpp"
#include "fit/support/user_error.hpp"

// One input is the text of a weight: read, looked at for faults and evaluated.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shadefit;
  try {
    const Weight weight(std::string_view(reinterpret_cast<const char*>(data), size));
    const Domain domain;
    // Ends without a fault are places where it is finite.
    if (!find_fault(weight) &&
        (!std::isfinite(weight.at(domain.lower)) || !std::isfinite(weight.at(domain.upper))))
      std::abort();
  } catch (const std::invalid_argument&) {
    return 0;  // refused, as bad input has to be
  } catch (const UserError&) {
    return 0;
  }
  return 0;
}
