#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lint/lint_tree.hpp"
#include "lint/scan/named_numbers.hpp"
#include "tests/lint/all_known.hpp"

/// Numbers that a text gives a name.
namespace shadefit::lint {
namespace {

/// The text with the numbers at the places of their names; empty if it stays as it is.
std::string replaced(const std::string& text, CommentStyle style = CommentStyle::c) {
  const auto all = [](const Literal&) { return true; };
  const auto other = with_named_numbers(text, style, literals_of(text, style), all);
  return other ? other->text() : "";
}

TEST(NamedNumbers, StandWhereTheirNamesStood) {
  EXPECT_EQ(replaced("#define K 0.5\nx = K + K2;"), "#define K\nx = 0.5 + K2;");
  EXPECT_EQ(replaced("# define K (0.5f) // half\nx = K;"), "# define K// half\nx = 0.5f;");
  EXPECT_EQ(replaced("#define K -0.5\nx = K;"), "#define K\nx = (-0.5);");
  EXPECT_EQ(replaced("static const float K = -0.5;\nx = K*K;"),
            "static const float K =;\nx = (-0.5)*(-0.5);");
  EXPECT_EQ(replaced("constexpr float K = 0.5;\nx = K;"), "constexpr float K =;\nx = 0.5;");
  EXPECT_EQ(replaced("const std::float32_t K = 0.5;\nx = std::pow(K, K);"),
            "const std::float32_t K =;\nx = std::pow(0.5, 0.5);");
  EXPECT_EQ(replaced("const K: f32 = 0.5;\nx = K;"), "const K: f32 =;\nx = 0.5;");
  EXPECT_EQ(replaced("K = 0.5\nx = K", CommentStyle::hash), "K =\nx = 0.5");
}

TEST(NamedNumbers, OtherNamesStay) {
  EXPECT_EQ(replaced("#define K 0.5 + 1\nx = K;"), "");
  EXPECT_EQ(replaced("#define K(x) 0.5\ny = K(x);"), "");
  EXPECT_EQ(replaced("float k = 0.5;\nx = k;"), "");  // may change
  EXPECT_EQ(replaced("const float K = 0.5 * a;\nx = K;"), "");
  EXPECT_EQ(replaced("#define K 0.5\n#define K 0.6\nx = K;"), "");  // one of two
  EXPECT_EQ(replaced("#define K 0.5\n#ifdef K\nx = v.K + N::K;"), "");
  EXPECT_EQ(replaced("// #define K 0.5\nx = K;"), "");
  EXPECT_EQ(replaced("  K = 0.5\nx = K", CommentStyle::hash), "");
  EXPECT_EQ(replaced("#define K 0.5\n"), "");  // not used
}

TEST(NamedNumbers, HaveThePlacesOfTheirDefinitions) {
  const std::string text = "#define K 0.5\nx = K + 7;";
  const auto other = with_named_numbers(text, CommentStyle::c, literals_of(text, CommentStyle::c),
                                        [](const Literal&) { return true; });
  ASSERT_TRUE(other);
  const std::size_t half = other->text().find("0.5"), seven = other->text().find('7');
  EXPECT_TRUE(other->is_named(half));
  EXPECT_EQ(other->original(half), text.find("0.5"));
  EXPECT_FALSE(other->is_named(seven));
  EXPECT_EQ(other->original(seven), text.find('7'));
}

/// "LINE:COLUMN id grade" of each site.
Words sites_in(const std::string& text) {
  Words words;
  for (const LintedSite& site : lint_text(text))
    words.push_back(std::to_string(site.begin.line) + ":" + std::to_string(site.begin.column) + " " +
                    site.id + " " + std::string(name(site.grade)));
  return words;
}

TEST(NamedNumbers, AreReadInTheExpression) {
  const auto decoder = [](const std::string& threshold) {
    return sites_in(
        "#define K " + threshold + "\n#define SCALE 1.055f\nstatic const float OFFSET = 0.055;\n" +
        "float decode(float u) { return u <= K ? u / 12.92 : pow((u + OFFSET) / SCALE, 2.4); }\n");
  };
  EXPECT_EQ(decoder("0.04045"), Words{"1:11 srgb-decode-standard right"});
  EXPECT_EQ(decoder("0.4045"), Words{"1:11 srgb-decode-standard wrong"});
}

TEST(NamedNumbers, AnOperationIsWrongFarFromThem) {
  const auto curve = [](const std::string& sign) {
    return sites_in(
        "const float A = 2.51;\nconst float B = 0.03;\nconst float C = 2.43;\nconst float D = 0.59;\n" +
        std::string("const float E = 0.14;\nfloat f(float x) { return x; }\n") +
        "float aces(float x) { return (x * (A * x + B)) / (x * (C * x " + sign + " D) + E); }\n");
  };
  EXPECT_EQ(curve("+"), Words{"1:17 aces-narkowicz-five right"});
  EXPECT_EQ(curve("-"), Words{"1:17 aces-narkowicz-five wrong"});
}

TEST(NamedNumbers, AreReportedOnce) {
  const std::string term = "exp2((A * c + B) * c)";
  EXPECT_EQ(sites_in("#define A -5.55473\n#define B -6.8316\nfloat f(float c) { return " + term +
                     "; }\nfloat g(float c) { return " + term + "; }\n"),
            Words{"1:12 fresnel-quadratic wrong"});
}

}  // namespace
}  // namespace shadefit::lint
