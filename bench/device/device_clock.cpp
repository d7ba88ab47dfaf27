#include "bench/device/device_clock.hpp"

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

}  // namespace shadefit::device
