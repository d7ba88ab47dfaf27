#include "lint/tree/glob.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lint/tree/ignore_rules.hpp"
#include "lint/tree/source_language.hpp"

namespace shadefit::lint {
namespace {

bool is_match(const std::string& glob, const std::string& text) {
  return matches(parse_glob(glob), text);
}

// The examples of gitignore(5); tests/lint/git_ignore_test.cpp compares random ones with git.
TEST(Glob, StarsBetweenSlashesMatchFolders) {
  EXPECT_TRUE(is_match("**/foo", "foo"));
  EXPECT_TRUE(is_match("**/foo", "a/b/foo"));
  EXPECT_FALSE(is_match("**/foo", "a/xfoo"));
  EXPECT_TRUE(is_match("abc/**", "abc/x/y"));
  EXPECT_FALSE(is_match("abc/**", "abc"));
  EXPECT_TRUE(is_match("a/**/b", "a/b"));
  EXPECT_TRUE(is_match("a/**/b", "a/x/y/b"));
  EXPECT_FALSE(is_match("a/**/b", "a/xb"));
  EXPECT_FALSE(is_match("?a/x**y", "1a/x/y")) << "other stars count as one";
  EXPECT_TRUE(is_match("foo/*", "foo/test.json"));
  EXPECT_FALSE(is_match("foo/*", "foo/bar/hello.c"));
}

TEST(Glob, SetsHaveRangesClassesAndEscapes) {
  EXPECT_TRUE(is_match("[a-c]x", "bx"));
  EXPECT_FALSE(is_match("[!a-c]x", "bx"));
  EXPECT_TRUE(is_match("[]-]", "-"));
  EXPECT_TRUE(is_match("[[:digit:]][[:xdigit:]]", "7f"));
  EXPECT_FALSE(is_match("[[:digit:]]", "x"));
  EXPECT_FALSE(is_match("[!x]", "/")) << "no set holds a '/'";
  EXPECT_TRUE(is_match("\\*", "*"));
  EXPECT_FALSE(is_match("\\*", "a"));
  for (const char* malformed : {"[a", "[[:digits:]]", "[a\\", "[!]", "a\\", "[[:digit:]"})
    EXPECT_FALSE(parse_glob(malformed).is_valid) << malformed;
}

// Ways that branch at each star would take longer than the universe has existed.
TEST(Glob, AHostileGlobTakesNoLongerThanItsLengthTimesThatOfTheText) {
  std::string glob = "?", folders = "?";
  for (int i = 0; i < 40; ++i) {
    glob += "*a";
    folders += "/**/*a";
  }
  EXPECT_FALSE(is_match(glob + "b?", std::string(2000, 'a')));
  std::string path = "x";
  while (path.size() < 2000) path += "/a";
  EXPECT_FALSE(is_match(folders + "b?", path));
}

TEST(IgnoreRules, TheLastThatMatchesDecides) {
  const auto rules = parse_ignore_rules("*.h\n!keep.h\n# no rule\n\\#x\nbuild/\n/top\n");
  const auto said = [&](const char* path, bool is_folder = false) { return verdict(rules, path, is_folder); };
  EXPECT_EQ(rules.size(), 5U);
  EXPECT_EQ(said("a/b.h"), IgnoreVerdict::ignored);
  EXPECT_EQ(said("a/keep.h"), IgnoreVerdict::kept);
  EXPECT_EQ(said("a/b.c"), IgnoreVerdict::none);
  EXPECT_EQ(said("#x"), IgnoreVerdict::ignored);
  EXPECT_EQ(said("a/build", true), IgnoreVerdict::ignored);
  EXPECT_EQ(said("a/build", false), IgnoreVerdict::none);
  EXPECT_EQ(said("top"), IgnoreVerdict::ignored);
  EXPECT_EQ(said("a/top"), IgnoreVerdict::none);
}

TEST(IgnoreRules, ALineLongerThanAnyPathIsNone) {
  EXPECT_EQ(parse_ignore_rules(std::string(4096, 'a')).size(), 1U);
  EXPECT_TRUE(parse_ignore_rules(std::string(4097, 'a')).empty());
}

TEST(SourceLanguage, FollowsTheEndingOfTheName) {
  struct Case {
    const char* name;
    std::optional<SourceLanguage> language;
  };
  const std::vector<Case> cases{{"pbr.glsl", SourceLanguage::glsl},
                                {"fog_fragment.glsl.js", SourceLanguage::javascript},
                                {"pbr.fragment.fx", SourceLanguage::glsl},
                                {"common.fx", SourceLanguage::hlsl},
                                {"BRDF.USH", SourceLanguage::hlsl},
                                {"sky.gdshader", SourceLanguage::glsl},
                                {"bxdf.h", SourceLanguage::c_family},
                                {"README.md", SourceLanguage::markdown},
                                {"a.png", std::nullopt},
                                {"glsl", std::nullopt},
                                {".glsl", std::nullopt},
                                {"", std::nullopt},
                                {"a.", std::nullopt}};
  for (const Case& one : cases) {
    const auto found = language_of(one.name);
    const auto language = found ? std::optional(found->language) : std::nullopt;
    EXPECT_EQ(language, one.language) << one.name;
  }
  for (const SourceLanguage language : source_languages) EXPECT_EQ(language_named(name(language)), language);
  EXPECT_FALSE(language_named("cobol"));
}

}  // namespace
}  // namespace shadefit::lint
