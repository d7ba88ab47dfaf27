#pragma once

#include <string>

#include "fit/support/user_error.hpp"

namespace shadefit::testing {

/// The message of the Refusal that `work` throws; empty if it throws none.
template <class Refusal = UserError, class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const Refusal& error) {
    return error.what();
  }
  return {};
}

}  // namespace shadefit::testing
