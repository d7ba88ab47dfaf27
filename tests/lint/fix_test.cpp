#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lint/fixes.hpp"
#include "lint/scan/literals.hpp"
#include "lint/scan/notation.hpp"
#include "reports/findings/unified_diff.hpp"

/// Published digits in the notation of a file.
namespace shadefit::lint {
namespace {

TEST(Rewritten, KeepsTheNotation) {
  EXPECT_EQ(rewritten("0.7754", "0.775"), "0.775");
  EXPECT_EQ(rewritten(".1565", "-0.156583"), ".156583");
  EXPECT_EQ(rewritten("0.1565f", "-.156583"), "0.156583f");
  EXPECT_EQ(rewritten("1.57_f32", "1.5707963"), "1.5707963_f32");
  EXPECT_EQ(rewritten("8.", "9"), "9.");
  EXPECT_EQ(rewritten("8.5f", "9"), "9.0f");
  EXPECT_EQ(rewritten("2", "2.4"), "2.4");
  EXPECT_EQ(rewritten("0.0", "0.055"), "0.055");
  EXPECT_EQ(rewritten("0.002", "1.5e-3"), "1.5e-3") << "the exponent as printed";
}

TEST(Rewritten, KeepsThePlaceOfThePointBeforeAnExponent) {
  EXPECT_EQ(rewritten("1.5e-3f", "0.00142"), "1.42e-3f");
  EXPECT_EQ(rewritten("1.5E-03", "0.00142"), "1.42E-03");
  EXPECT_EQ(rewritten("1.5e+2", "142"), "1.42e+2");
  EXPECT_EQ(rewritten("1.5e-3", "0.000142"), "1.42e-4") << "a slip in the exponent";
  EXPECT_EQ(rewritten("15e-4", "0.00142"), "14.2e-4");
  EXPECT_EQ(rewritten(".15e-2", "0.00142"), ".142e-2");
  EXPECT_EQ(rewritten("0.015e-1", "0.00142"), "0.0142e-1");
  EXPECT_EQ(rewritten("1500e-6", "0.002"), "2000e-6");
  EXPECT_EQ(rewritten("0e0", "0.00142"), "1.42e-3");
}

TEST(Rewritten, HasTheValueOfThePublishedNumberInEveryNotation) {
  for (const char* literal : {"1", "1.", ".5", "0.5", "12.25", "1e0", "1.5e-3", "0.05e2", "150E+01", "1.e5",
                              ".02e-07", "1_000.5", "3e10f", "0.0", "0e5", "2.5f"})
    for (const char* published : {"0.775", "-6.98316", "8", "1000", "-.156583", "1e-7", "5.4856e-13", "2.50",
                                  "0.0722", "107.5", "1.0"}) {
      const std::string text = rewritten(literal, published);
      EXPECT_EQ(digits_of(text), digits_of(published)) << literal << " " << published << " " << text;
      EXPECT_EQ(parts_of_number(text).length, text.size()) << text;
      EXPECT_EQ(parts_of_number(text).suffix, parts_of_number(literal).suffix) << text;
      EXPECT_EQ(rewritten(text, published), text) << "once more";
    }
}

LintedSite site_with(Grade grade, const std::string& text, std::size_t offset, const std::string& published) {
  LintedSite site;
  site.grade = grade;
  site.numbers = {{"a", published, text, grade, offset, true}};
  return site;
}

TEST(Fixes, TakeTheirScope) {
  const std::string text = "1.1 2.2 3.3 4.4";
  std::vector<LintedSite> sites{
      site_with(Grade::truncated, "1.1", 0, "1.111"), site_with(Grade::typo, "2.2", 4, "2.222"),
      site_with(Grade::wrong, "3.3", 8, "3.333"), site_with(Grade::truncated, "4.4", 12, "4.444")};
  sites[3].is_pinned = true;
  const auto fixed = [&](FixScope scope) { return fixed_text(text, fixes_of(sites, text, scope)); };
  EXPECT_EQ(fixed(FixScope::pins), "1.1 2.2 3.3 4.444");
  EXPECT_EQ(fixed(FixScope::wrong), "1.1 2.2 3.333 4.444");
  EXPECT_EQ(fixed(FixScope::typo), "1.1 2.222 3.333 4.444");
}

TEST(Fixes, LeaveShortNumbersBesideWorseOnes) {
  const std::string text = "1.1 2.2";
  LintedSite site = site_with(Grade::wrong, "1.1", 0, "1.111");
  site.numbers.front().grade = Grade::truncated;
  EXPECT_EQ(fixes_of({site}, text, FixScope::wrong).size(), 1U) << "it is why the site is wrong";
  site.numbers.push_back({"b", "2.222", "2.2", Grade::typo, 4, true});
  EXPECT_EQ(fixed_text(text, fixes_of({site}, text, FixScope::wrong)), "1.1 2.222");
}

TEST(Fixes, LeaveAloneWhatIsNotSure) {
  const std::string text = "3.3 * 10^-2";
  const LintedSite site = site_with(Grade::wrong, "3.3", 0, "3.333");
  const auto count = [](const std::vector<LintedSite>& sites, const std::string& of = "3.3") {
    return fixes_of(sites, of, FixScope::typo).size();
  };
  EXPECT_EQ(count({site}), 1U);
  EXPECT_EQ(count({site}, text), 0U) << "a factor follows";
  EXPECT_EQ(count({site, site_with(Grade::wrong, "3.3", 0, "3.133")}), 0U) << "two sites disagree";
  EXPECT_EQ(count({site, site}), 1U);
  std::vector<LintedSite> others(4, site);
  others[0].slip = "1 + x for 1 - x";
  others[1].is_in_comment = true;
  others[2].ignored = "a reason";
  others[3].numbers[0].is_certain = false;
  EXPECT_EQ(count(others), 0U);
  others[2].is_pinned = true;
  EXPECT_EQ(count(others), 1U);
}

TEST(UnifiedDiff, HasThreeLinesOfContext) {
  std::string before, after;
  for (int i = 1; i <= 30; ++i) {
    before += std::to_string(i) + "\n";
    after += (i == 1 || i == 8 || i == 9 || i == 15 || i == 30 ? "x" : "") + std::to_string(i) + "\n";
  }
  before.pop_back();
  after.pop_back();
  EXPECT_EQ(
      unified_diff("d/f.glsl", before, after),
      "--- a/d/f.glsl\n+++ b/d/f.glsl\n@@ -1,4 +1,4 @@\n-1\n+x1\n 2\n 3\n 4\n"
      "@@ -5,14 +5,14 @@\n 5\n 6\n 7\n-8\n-9\n+x8\n+x9\n 10\n 11\n 12\n 13\n 14\n-15\n+x15\n 16\n 17\n 18\n"
      "@@ -27,4 +27,4 @@\n 27\n 28\n 29\n-30\n\\ No newline at end of file\n+x30\n"
      "\\ No newline at end of file\n");
  EXPECT_EQ(unified_diff("f", before, before), "");
  EXPECT_EQ(unified_diff("/f", "1\r\n", "2\r\n"), "--- /f\n+++ /f\n@@ -1,1 +1,1 @@\n-1\r\n+2\r\n");
}

}  // namespace
}  // namespace shadefit::lint
