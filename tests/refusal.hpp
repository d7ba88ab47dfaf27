#pragma once

#include <string>

#include "fit/support/user_error.hpp"

namespace shadefit::testing {

/// What the UserError of `work` says; empty where it throws none.
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
