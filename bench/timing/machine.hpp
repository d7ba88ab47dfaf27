#pragma once

#include <cstddef>
#include <string>

/// The machine of the times.
namespace shadefit::bench {

struct Machine {
  std::string cpu;         ///< its name by the system, or "unknown"
  std::string compiler;    ///< of this program
  unsigned threads;        ///< that the machine runs in parallel
  std::size_t last_cache;  ///< bytes; 0 if unknown
  /// What the times are of, by its name, and the driver that runs it: on the CPU there is none.
  std::string device = "cpu", driver = {};
  std::string clock = "steady clock";  ///< that the times are of
  bool is_graphics() const { return !driver.empty(); }
};

/// The value of the first line "model name : ..." of the text of /proc/cpuinfo, or "unknown".
std::string cpu_name(const std::string& cpuinfo);

Machine this_machine();

}  // namespace shadefit::bench
