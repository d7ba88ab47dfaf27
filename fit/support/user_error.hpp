#pragma once

#include <stdexcept>

/// The error that the user can correct.
namespace shadefit {

/// Bad usage or bad input. `what()` is one line that names the thing, its value and the rule that it broke;
/// the command prints it and exits with 2.
struct UserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A check failed, or something could not be proven. `what()` is one line that says which and why; the
/// command prints it and exits with 1.
struct CheckFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace shadefit
