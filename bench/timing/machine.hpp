#pragma once

#include <cstddef>
#include <string>

/// The machine of the times.
namespace shadefit::bench {

struct Machine {
  std::string cpu;                     ///< its name by the system, or "unknown"
  std::string compiler;                ///< of this program
  unsigned threads;                    ///< that the machine runs in parallel
  std::size_t last_cache;              ///< bytes; 0 if unknown
  std::string device = "cpu";          ///< what ran the forms: the CPU, or the name of a graphics device
  std::string driver = {};             ///< the driver of that device; empty for the CPU
  std::string clock = "steady clock";  ///< which clock took the times
  bool is_graphics() const { return !driver.empty(); }
};

/// The value of the first line "model name : ..." of the text of /proc/cpuinfo, or "unknown".
std::string cpu_name(const std::string& cpuinfo);

Machine this_machine();

}  // namespace shadefit::bench
