#include "bench/device/dispatches.hpp"

#include <algorithm>
#include <ctime>
#include <thread>

namespace shadefit::device {
namespace {

double process_seconds() {
  std::timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

bool is_the_cpu(const DeviceInfo& info) {
  return info.kind == "CPU";
}

std::string name_of_clock(const DeviceInfo& info) {
  if (is_the_cpu(info)) return "processor time of all cores";
  return info.has_timestamps ? "timestamps of the device" : "steady clock around a dispatch";
}

double seconds_of_dispatch(const DeviceInfo& info, const std::function<double()>& dispatch) {
  constexpr double least = 1e-6;
  if (!is_the_cpu(info)) return std::max(dispatch(), least);
  const double before = process_seconds();
  dispatch();
  return std::max((process_seconds() - before) / std::max(std::thread::hardware_concurrency(), 1U), least);
}

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
