#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "tests/refusal.hpp"

namespace shadefit::testing {

/// The line of an error. One that begins with an option or says what the command needs points to the help of
/// the command, unless it already says what to see.
inline std::string line_of_error(const std::vector<std::string>& arguments, const std::string& line) {
  const std::string command = arguments.empty() ? "-" : arguments.front();
  const bool is_of_option = line.starts_with("--");
  const bool points = (is_of_option || line.starts_with(command + " needs ")) && !command.starts_with('-') &&
                      line.find("see 'shadefit ") == std::string::npos;
  return "shadefit: " + line + (points ? " (see 'shadefit help " + command + "')\n" : "\n");
}

/// The command refuses an error of the user: exit 2, that one line, nothing on standard output.
inline void expect_refusal(const std::vector<std::string>& arguments, const std::string& line) {
  const Outcome outcome = run_command_line(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << line;
  EXPECT_EQ(outcome.out, "") << line;
  EXPECT_EQ(outcome.err, line_of_error(arguments, line));
}

/// A call with more words.
inline std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// What a command prints with --json; the command has to succeed, in silence.
inline nlohmann::json json_of(const std::vector<std::string>& arguments) {
  const Outcome outcome = run_command_line(with(arguments, {"--json"}));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  return nlohmann::json::parse(outcome.out);
}

}  // namespace shadefit::testing
