#include "reports/sections/prose.hpp"

#include <gtest/gtest.h>

namespace shadefit {
namespace {

TEST(Prose, AFullStopAndASpaceEndASentence) {
  EXPECT_EQ(sentences_of("k is 1.5. c is 0 .. 1. The end."),
            (std::vector<std::string>{"k is 1.5.", "c is 0 .. 1.", "The end."}));
  EXPECT_EQ(sentences_of(""), std::vector<std::string>{""});
}

TEST(Prose, LinesOfAListKeepTheirIndentation) {
  EXPECT_EQ(with_short_lines("One. Two.\n\n- A. B.\n  - C. D.\n"),
            "One.\nTwo.\n\n- A.\n  B.\n  - C.\n    D.\n");
}

TEST(Prose, TablesHeadingsAndPicturesStay) {
  const std::string text = "## A. B\n| a. b |\n![a. b](c)\n";
  EXPECT_EQ(with_short_lines(text), text);
}

TEST(Prose, ALongSentenceIsBrokenAtItsSemicolonsOrColons) {
  const std::string half(250, 'x');
  EXPECT_EQ(with_short_lines(half + "; " + half + "."), half + ";\n" + half + ".\n");
  EXPECT_EQ(with_short_lines("- a: " + half + ": " + half + "."), "- a:\n  " + half + ":\n  " + half + ".\n");
  EXPECT_EQ(with_short_lines("a: b; " + half + half + "."), "a: b;\n" + half + half + ".\n");
  EXPECT_EQ(with_short_lines("a; b: c."), "a; b: c.\n");
}

TEST(Prose, AnAnchorIsThatOfGitHub) {
  EXPECT_EQ(anchor("Spherical Gaussian offset (`sg-offset`)"), "spherical-gaussian-offset-sg-offset");
  EXPECT_EQ(anchor("(1 - c)^5"), "1---c5");
}

TEST(Prose, ContentsListTheHeadingsOfTwoLevels) {
  EXPECT_EQ(contents("# Title\n## First\ntext\n### Inner\n#### Deep\n"),
            "- [First](#first)\n  - [Inner](#inner)\n\n");
}

}  // namespace
}  // namespace shadefit
