#pragma once

#include <functional>
#include <string>

namespace shadefit {

/// What came of a call.
struct Outcome {
  int exit_code = 0;  ///< 0; 1 a check, a fit or a plot failed; 2 bad usage or bad input; 128 + a signal that
                      ///< interrupted it
  std::string out;    ///< for standard output
  std::string err;    ///< for standard error
  /// Puts the files that are ready in their places; empty where there are none. Call it after `out` is
  /// printed: where printing fails, no file is written. Throws UserError and Interrupted.
  std::function<void()> put = {};
};

}  // namespace shadefit
