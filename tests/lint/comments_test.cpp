#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lint/expression/program_text.hpp"
#include "lint/lint_tree.hpp"
#include "tests/lint/all_known.hpp"

/// Formulas and sets in comments.
namespace shadefit::lint {
namespace {

/// "id grade", with ": slip" of an operation, of each site. All have to be in comments.
Words notes_in(const std::string& text) {
  Words words;
  for (const LintedSite& site : lint_text(text)) {
    EXPECT_TRUE(site.is_in_comment) << text;
    words.push_back(site.id + " " + std::string(name(site.grade)) +
                    (site.slip.empty() ? "" : ": " + site.slip));
  }
  return words;
}

TEST(Comments, AreProgramsByteForByte) {
  EXPECT_EQ(comment_as_program("// by exp2(a * x) for"), ";  by;exp2(a * x);for");
  EXPECT_EQ(comment_as_program("/** acos: a x. The\n * next */"), ";   acos; a;x; The\n   next ; ");
  EXPECT_EQ(comment_as_program("x = 1 // y"), "x = 1 ;  y");
  EXPECT_EQ(comment_as_program(""), "");
}

TEST(Comments, MayHaveAFormulaInProse) {
  const Words wrong{"fresnel-quadratic wrong"};
  EXPECT_EQ(notes_in("// exp2((-5.55473 * c - 6.8316) * c)\n"), wrong);
  EXPECT_EQ(notes_in("// Schlick's term by exp2((-5.55473 * c - 6.8316) * c) for c\n"), wrong);
  EXPECT_EQ(notes_in("/* The term:\n * f = exp2((-5.55473 * c - 6.8316) * c)\n */\n"), wrong);
  EXPECT_EQ(notes_in("// by exp2((-5.55473 * c - 6.98316) * c)\n"), Words{"fresnel-quadratic right"});
  EXPECT_EQ(notes_in("// by exp2((-5.55473 * c + 6.98316) * c)\n"),
            Words{"fresnel-quadratic wrong: a c - b for a c + b"});
}

TEST(Comments, MayHaveAWholeSet) {
  EXPECT_EQ(notes_in("// acos: 1.5707288, -0.2121144, 0.0742610, -0.0178293\n"), Words{"acos-cubic typo"});
  // A part of it may be an older one, or the number may go on in the next line.
  EXPECT_EQ(notes_in("// acos: 1.5707288, -0.2121144, 0.0742601\n"), Words{});
  EXPECT_EQ(notes_in("// acos: 1.5707288, -0.2121144, 0.0742610, -0.0187\n"), Words{});
}

}  // namespace
}  // namespace shadefit::lint
