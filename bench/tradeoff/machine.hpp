#pragma once

#include <string>

/// The machine of the times.
namespace shadefit::bench {

struct Machine {
  std::string cpu = {};                ///< its name by the system, or "unknown"
  std::string compiler = {};           ///< of the timed code; empty on a graphics device
  std::string device = "cpu";          ///< what ran the forms: the CPU, or the name of a graphics device
  std::string driver = {};             ///< the driver of that device; empty for the CPU
  std::string clock = "steady clock";  ///< which clock took the times
  bool is_graphics() const { return !driver.empty(); }
};

/// The value of the first line "model name : ..." of the text of /proc/cpuinfo, or "unknown".
std::string cpu_name(const std::string& cpuinfo);

/// The name of this machine's processor.
std::string this_cpu();

}  // namespace shadefit::bench
