#pragma once

#include <cstddef>
#include <string>

/// Where times were taken.
namespace shadefit::bench {

struct Machine {
  std::string cpu;         ///< its name as the system tells it, "unknown" where it does not
  std::string compiler;    ///< that this program was compiled with
  unsigned threads;        ///< that the machine runs at once
  std::size_t last_cache;  ///< bytes; 0 where the system does not tell
};

/// The value of the first line "model name : ..." of what /proc/cpuinfo holds; "unknown" where none is.
std::string cpu_name(const std::string& cpuinfo);

Machine this_machine();

}  // namespace shadefit::bench
