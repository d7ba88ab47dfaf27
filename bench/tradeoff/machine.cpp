#include "bench/tradeoff/machine.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

namespace shadefit::bench {

std::string cpu_name(const std::string& cpuinfo) {
  std::istringstream lines(cpuinfo);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("model name")) continue;
    const auto colon = line.find(':');
    const auto first = colon == std::string::npos ? colon : line.find_first_not_of(" \t", colon + 1);
    if (first == std::string::npos) continue;
    return line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
  }
  return "unknown";
}

std::string this_cpu() {
  std::ifstream file("/proc/cpuinfo");
  return cpu_name(std::string(std::istreambuf_iterator<char>(file), {}));
}

}  // namespace shadefit::bench
