#pragma once

#include <gtest/gtest.h>

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

/// A text has a part, or does not.
inline void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "without '" << part << "':\n" << text;
}
inline void expect_lacks(const std::string& text, const std::string& part) {
  EXPECT_EQ(text.find(part), std::string::npos) << "with '" << part << "':\n" << text;
}

}  // namespace shadefit::testing
