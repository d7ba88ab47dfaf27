#pragma once

#include <functional>
#include <string>

namespace shadefit {

/// The outcome of a call.
struct Outcome {
  int exit_code = 0;  ///< 0; 1 a check, a fit or a plot failed; 2 bad usage or bad input; 128 + a signal that
                      ///< interrupted it
  std::string out;    ///< for standard output
  std::string err;    ///< for standard error
  /// Writes the files; empty if there are none. Call it after `out` is printed: if printing fails, no file is
  /// written. Throws UserError and Interrupted.
  std::function<void()> put = {};
};

}  // namespace shadefit
