#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/locale/encoding_utf.hpp>
#include <filesystem>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "reports/io/escape.hpp"
#include "reports/io/files.hpp"
#include "reports/io/table.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

static_assert(!fmt::is_formattable<OthersText>::value);
static_assert(!std::is_convertible_v<OthersText, std::string>);
static_assert(!std::is_convertible_v<OthersText, std::string_view>);
static_assert(!std::is_constructible_v<std::string, OthersText>);
static_assert(std::is_same_v<decltype("a" + OthersText() + std::string("b")), OthersText>);

TEST(Escape, ATextHasNoMeaningInItsPlace) {
  struct Case {
    std::string text, markdown, html, latex, gnuplot, comment, csv;
  };
  const std::vector<Case> cases{
      {"d'Eon 2014", "d'Eon 2014", "d'Eon 2014", "d'Eon 2014", "d'Eon 2014", "d'Eon 2014", "d'Eon 2014"},
      {"a\n\x1b\u202e", R"(a\\x0a\\x1b\\xe2\\x80\\xae)", R"(a\x0a\x1b\xe2\x80\xae)",
       R"(a\textbackslash{}x0a\textbackslash{}x1b\textbackslash{}xe2\textbackslash{}x80\textbackslash{}xae)",
       R"(a\\x0a\\x1b\\xe2\\x80\\xae)", R"(a\x0a\x1b\xe2\x80\xae)", R"(a\x0a\x1b\xe2\x80\xae)"},
      {"<a> & \"b\"", "&lt;a&gt; &amp; \"b\"", "&lt;a&gt; &amp; &quot;b&quot;",
       R"(\textless{}a\textgreater{} \& "b")", R"(<a> \& "b")", "<a> & \"b\"", "<a> & \"b\""},
      {"[x](y) *b* | $c$ @d", R"(\[x\](y) \*b\* &#124; &#36;c&#36; &#64;d)", "[x](y) *b* | $c$ @d",
       R"([x](y) *b* \textbar{} \$c\$ @d)", R"([x](y) *b* | $c$ \@d)", "[x](y) *b* | $c$ @d",
       "[x](y) *b* | $c$ @d"},
      {"x_1^2 {a}", R"(x\_1^2 {a})", "x_1^2 {a}",
       R"(x\_1\textasciicircum{}2 \textbraceleft{}a\textbraceright{})", R"(x\_1\^2 \{a\})", "x_1^2 {a}",
       "x_1^2 {a}"},
      {"http://a www.b", "http&#58;//a www&#46;b", "http://a www.b", "http://a www.b", "http://a www.b",
       "http://a www.b", "http://a www.b"},
      {"=1", "=1", "=1", "=1", "=1", "=1", "'=1"},
      {"  - a", R"(\- a)", "  - a", "  - a", "  - a", "  - a", "  - a"},
      {"12. a\\ ", R"(12\. a\\ )", "12. a\\ ", R"(12. a\textbackslash{} )", R"(12. a\\ )", "12. a\\.",
       "12. a\\ "},
      {"a ?\?/", "a ?\?/", "a ?\?/", "a ?\?/", "a ?\?/", "a ?\?/.", "a ?\?/"},
      {"1.5 @SUM", "1.5 &#64;SUM", "1.5 @SUM", "1.5 @SUM", R"(1.5 \@SUM)", "1.5 @SUM", "1.5 @SUM"}};
  for (const Case& c : cases) {
    EXPECT_EQ(for_markdown(c.text), c.markdown);
    EXPECT_EQ(for_html(c.text), c.html);
    EXPECT_EQ(for_latex(c.text), c.latex);
    EXPECT_EQ(for_gnuplot(c.text), c.gnuplot);
    EXPECT_EQ(for_comment(c.text), c.comment);
    EXPECT_EQ(for_csv(c.text), c.csv);
  }
}

TEST(Escape, JsonReadsBackAndIsAscii) {
  const std::string text = "\x1b\x7f\u0085\u202e\U000e0041 é \"\\";
  const std::string json = json_text({{"a", OthersText(text)}, {"b", "\xff"}});
  EXPECT_EQ(
      json,
      "{\n  \"a\": \"\\u001b\\u007f\\u0085\\u202e\\udb40\\udc41 \\u00e9 \\\"\\\\\",\n  \"b\": \"\\ufffd\"\n}\n");
  EXPECT_EQ(nlohmann::json::parse(json)["a"], text);
}

// `unescaped` is for reading, for messages of errors and for the writers: whoever prints a text has no need.
TEST(Escape, FewFilesReadTextOfOthersUnescaped) {
  const std::set<std::string> allowed{
      "app/commands/proof_commands.cpp", "app/commands/study_verbs.cpp",    "app/studies/find_study.cpp",
      "bench/tradeoff/timed_forms.cpp",  "fit/catalogue/read_families.cpp", "fit/study/read_study.cpp",
      "fit/study/require_values.cpp",    "fit/support/others_text.hpp",     "fit/verdicts/study_claims.cpp",
      "lint/scan/known_set.cpp",         "reports/studies/gallery.cpp",     "reports/io/escape.cpp",
      "reports/rows/citation.cpp",       "reports/studies/study_rows.cpp"};
  std::set<std::string> found;
  for (const char* folder : {"app", "bench", "fit", "lint", "reports", "scene"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(SHADEFIT_SOURCE_DIR) / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".hpp") continue;
      if (read_file(entry.path().string()).find("unescaped()") != std::string::npos)
        found.insert(std::filesystem::relative(entry.path(), SHADEFIT_SOURCE_DIR).generic_string());
    }
  }
  EXPECT_EQ(found, allowed);
}

std::string encoded(char32_t point) {
  const std::u32string_view text(&point, 1);
  return boost::locale::conv::utf_to_utf<char>(text.data(), text.data() + text.size());
}

TEST(Utf8, TakesNothingThatIsNoCodePoint) {
  for (const char* whole : {"a", "\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"})
    EXPECT_EQ(first_code_point(whole).length, std::string(whole).size());
  for (const char* not_one : {"", "\xC3",
                              "\xC3"
                              "a",
                              "\xA9", "\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFF"})
    EXPECT_EQ(first_code_point(not_one).length, 0U) << not_one;
}

// What can end or turn a line, or has no width, by Unicode's names for it; everything beside them is shown.
TEST(Utf8, WhatCouldForgeALineIsEscaped) {
  for (const char32_t point :
       {0x00U,   0x1BU,   0x7FU,   0x85U,   0x9BU,   0xADU,   0x061CU, 0x180EU,  0x200BU, 0x200CU, 0x200DU,
        0x200EU, 0x200FU, 0x2028U, 0x2029U, 0x202AU, 0x202BU, 0x202CU, 0x202DU,  0x202EU, 0x2060U, 0x2066U,
        0x2067U, 0x2068U, 0x2069U, 0x3164U, 0xFEFFU, 0xFFF9U, 0xFFFBU, 0xE0001U, 0xE007FU}) {
    const std::string bytes = encoded(point);
    const std::string shown = printable("a" + bytes + "b");
    EXPECT_EQ(shown.size(), 2 + 4 * bytes.size()) << static_cast<unsigned>(point);
    EXPECT_EQ(shown.find(bytes), std::string::npos) << static_cast<unsigned>(point);
  }
  for (const char32_t point : {0x20U, 0x7EU, 0xA0U, 0xACU, 0xAEU, 0xE9U, 0x061BU, 0x061DU, 0x200AU, 0x2010U,
                               0x2027U, 0x202FU, 0x205FU, 0x2070U, 0x3042U, 0xFF21U, 0x1F600U}) {
    const std::string bytes = encoded(point);
    EXPECT_EQ(printable(bytes), bytes) << static_cast<unsigned>(point);
  }
}

TEST(Utf8, OneLineShowsNoControlCharacterAndIsBounded) {
  EXPECT_EQ(one_line("a\x1B[2J\r\n\x7F\xC2\x9B\xFF \xC3\xA9"),
            "a\\x1b[2J\\x0d\\x0a\\x7f\\xc2\\x9b\\xff \xC3\xA9");
  EXPECT_EQ(one_line(std::string(600, 'x')), std::string(600, 'x'));
  EXPECT_EQ(one_line(std::string(301, 'x') + std::string(300, 'y')),
            std::string(300, 'x') + " .. " + std::string(300, 'y'));
  const auto repeated = [](const std::string& what, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += what;
    return text;
  };
  const std::string smile = "\xF0\x9F\x98\x80";
  EXPECT_EQ(one_line(repeated(smile, 1000)), repeated(smile, 75) + " .. " + repeated(smile, 75));
  EXPECT_EQ(one_line("a" + repeated(smile, 1000) + "b"),
            "a" + repeated(smile, 74) + " .. " + repeated(smile, 74) + "b")
      << "no code point is cut";
  EXPECT_EQ(one_line(repeated("x", 5000) + "\n"), repeated("x", 300) + " .. " + repeated("x", 299) + "\\x0a");
  EXPECT_EQ(one_line(repeated("\x80", 5000)), " .. ") << "of none but rests of code points nothing is left";
  EXPECT_EQ(printable(std::string(601, 'x') + "\n"), std::string(601, 'x') + "\\x0a") << "a path is whole";
}

}  // namespace
}  // namespace shadefit
