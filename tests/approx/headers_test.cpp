#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

namespace shadefit {
namespace {

/// Includes of approx/ itself, or of the standard library, whose headers alone are one word of small letters:
/// other libraries' are named with a folder (boost/..), a suffix (mpfi.h) or a capital (Eigen).
bool is_allowed(const std::string& line) {
  return std::regex_match(line,
                          std::regex(R"(#include ("approx/([a-z_0-9]+/)?[a-z_0-9]+\.hpp"|<[a-z_0-9]+>))"));
}

TEST(Headers, OfApproxIncludeOnlyApproxAndTheStandardLibrary) {
  int includes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SHADEFIT_SOURCE_DIR "/approx")) {
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      if (!std::regex_search(line, std::regex(R"(^\s*#\s*include)"))) continue;
      ++includes;
      EXPECT_TRUE(is_allowed(line)) << entry.path() << ": " << line;
    }
  }
  EXPECT_GT(includes, 0);
}

TEST(Headers, WhatIsNotAllowedIsSeen) {
  for (const char* line : {"#include <boost/math/constants.hpp>", "#include <mpfi.h>", "#include <Eigen>",
                           "#include \"fit/scalars/jet.hpp\"", "#include \"approx/../fit/jet.hpp\""}) {
    EXPECT_FALSE(is_allowed(line)) << line;
  }
  EXPECT_TRUE(is_allowed("#include <cmath>"));
  EXPECT_TRUE(is_allowed("#include \"approx/phong_blinn.hpp\""));
  EXPECT_TRUE(is_allowed("#include \"approx/records/claim.hpp\""));
}

}  // namespace
}  // namespace shadefit
