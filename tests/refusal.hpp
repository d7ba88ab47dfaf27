#pragma once

#include <string>

#include "fit/support/user_error.hpp"

namespace shadefit::testing {

/// The message of `work`'s UserError; empty if it throws none.
template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const UserError& error) {
    return error.what();
  }
  return {};
}

}  // namespace shadefit::testing
