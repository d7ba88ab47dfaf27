#pragma once

#include <gtest/gtest.h>

#include <string>

namespace shadefit::testing {

/// A small study: Chebyshev's best line for x^2 on [0, 1] is x - 1/8, with error 1/8.
inline const std::string line_study = R"(schema = 1
id = "line"
[over]
x = "0:1"
[target]
formula = "x^2"
[[form]]
id = "line"
formula = "a + b x"
[[form]]
id = "slope"
formula = "a x"
[metric]
norm = "minimax"
[[published]]
form = "line"
values = { a = "-0.125", b = "1.0" }
source = "Chebyshev 1854, on mechanisms"
claim = { max_abs_error = "0.125", says = "an eighth" }
variants = [ { b = "1.1", seen = "a copy" } ]
)";

/// The text with the first `before` replaced; a failure if it is not there.
inline std::string replaced(std::string text, const std::string& before, const std::string& after) {
  const auto at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), after);
}

}  // namespace shadefit::testing
