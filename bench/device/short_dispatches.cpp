#include <algorithm>

#include "bench/device/vulkan_device.hpp"

namespace shadefit::device {

void in_short_dispatches(std::uint64_t count, std::uint64_t most,
                         const std::function<double(std::uint64_t, std::uint64_t)>& run) {
  // A dispatch may take four times as long as predicted and still stay below the limit.
  constexpr double wanted = longest_dispatch / 4;
  std::uint64_t n = std::min<std::uint64_t>(most, 4096);
  for (std::uint64_t from = 0; from < count;) {
    n = std::min({n, most, count - from});
    const double seconds = run(from, n);
    from += n;
    const double growth = seconds > 0 ? std::clamp(wanted / seconds, 0.25, 4.0) : 4.0;
    n = std::max<std::uint64_t>(threads_per_group,
                                static_cast<std::uint64_t>(static_cast<double>(n) * growth));
  }
}

}  // namespace shadefit::device
