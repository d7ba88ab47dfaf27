#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/command_line.hpp"

namespace shadefit::testing {

/// The command refuses what is the user's to mend: exit 2, that one line, nothing on standard output.
inline void expect_refusal(const std::vector<std::string>& arguments, const std::string& line) {
  const Outcome outcome = run_command_line(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << line;
  EXPECT_EQ(outcome.out, "") << line;
  EXPECT_EQ(outcome.err, "shadefit: " + line + "\n");
}

}  // namespace shadefit::testing
