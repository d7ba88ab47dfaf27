#pragma once

#include <string>
#include <vector>

namespace shadefit::side_by_side {

/// A finished process.
struct Finished {
  bool is_well = false;  ///< exit code 0
  double seconds = 0;    ///< from its start to its end, by the clock
  std::string output;    ///< its standard output; its standard error is discarded
};

/// Runs a program, found by PATH, to its end.
Finished run(const std::vector<std::string>& arguments);

}  // namespace shadefit::side_by_side
