#pragma once

#include <string>
#include <vector>

namespace shadefit::side_by_side {

/// A finished process.
struct Finished {
  bool is_well = false;  ///< exit code 0
  double seconds = 0;    ///< from its start to its end, by the clock
  /// The largest resident set, in 10^6 bytes. Linux includes the memory of this process at the start in the
  /// peak of its child. So the peak is an upper bound, and exact if the child becomes larger than its parent.
  double peak_mb = 0;
  std::string output;  ///< its standard output; its standard error is discarded
};

/// Runs a program, found by PATH, to its end, without input.
Finished run(const std::vector<std::string>& arguments);

}  // namespace shadefit::side_by_side
