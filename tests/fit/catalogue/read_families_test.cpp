#include "fit/catalogue/read_families.hpp"

#include <gtest/gtest.h>

#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "tests/app/studies/line_study.hpp"

namespace shadefit {
namespace {

using testing::replaced;

std::string file_of(const std::string& name) {
  return read_file(SHADEFIT_SOURCE_DIR "/studies/catalogue/" + name + ".toml");
}

TEST(Families, ThatOnlyCompareComeLast) {
  std::vector<std::string> ids;
  for (const Family& family : families()) {
    ids.push_back(family.id);
    ASSERT_EQ(family.starts.size(), 3U) << family.id;
    for (const auto& start : family.starts) EXPECT_EQ(start.size(), family.parameters.size()) << family.id;
    EXPECT_EQ(family.has_exponent(), !family.study.near_peak.form.empty()) << family.id;
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"sg-offset", "fresnel-one-term", "fresnel-quadratic",
                                           "phong-blinn", "sg-scaled", "fresnel-cubic", "fresnel-quartic",
                                           "fresnel-fourth", "fresnel-square", "fresnel-rational"}));
}

TEST(Families, OfAFileAreRead) {
  Catalogue catalogue;
  read_families(file_of("fresnel"), "fresnel", catalogue);
  EXPECT_EQ(catalogue.families.size(), 7U);
  ASSERT_EQ(catalogue.published.size(), 4U);
  EXPECT_EQ(catalogue.published[2].id, "fresnel-quadratic-a")
      << "several values: the parameter follows the id";
  EXPECT_EQ(catalogue.published[2].variants.size(), 1U);
  EXPECT_NEAR(catalogue.published[1].convention.value.value(), 8.656170, 5e-7);
}

TEST(Families, WordsThatNobodyKnowsAreRefusedWithTheirLine) {
  const auto expect_refusal = [](const std::string& from, const std::string& to) {
    Catalogue catalogue;
    try {
      read_families(replaced(file_of("sg-offset"), from, to), "sg-offset", catalogue);
      ADD_FAILURE() << to << " was read";
    } catch (const UserError& error) {
      EXPECT_NE(std::string(error.what()).find("catalogue 'sg-offset', line "), std::string::npos)
          << error.what();
    }
  };
  expect_refusal("statement = \"mean\"", "statement = \"median\"");
  expect_refusal("near_peak = \"gaussian", "near_paek = \"gaussian");
}

}  // namespace
}  // namespace shadefit
