#include "reports/io/escape.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "reports/io/files.hpp"
#include "reports/table/table.hpp"

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

TEST(Escape, JsonReadsBackAndHasNoCharacterThatIsNotShown) {
  const std::string text = "\x1b\x7f\u0085\u202e\U000e0041 é \"\\";
  const std::string json = json_text({{"a", OthersText(text)}, {"b", "\xff"}});
  EXPECT_EQ(
      json,
      "{\n  \"a\": \"\\u001b\\u007f\\u0085\\u202e\\udb40\\udc41 é \\\"\\\\\",\n  \"b\": \"\uFFFD\"\n}\n");
  EXPECT_EQ(nlohmann::json::parse(json)["a"], text);
}

// `unescaped` is for reading, for messages of errors and for the writers: whoever prints a text has no need.
TEST(Escape, FewFilesReadTextOfOthersUnescaped) {
  const std::set<std::string> allowed{
      "app/commands/proof_commands.cpp", "app/commands/study_verbs.cpp",  "app/studies/find_study.cpp",
      "bench/tradeoff/study_forms.cpp",  "fit/study/read_study.cpp",      "fit/study/require_values.cpp",
      "fit/support/others_text.hpp",     "fit/verdicts/study_claims.cpp", "lint/known/known_set.cpp",
      "reports/gallery/gallery.cpp",     "reports/io/escape.cpp",         "reports/rows/citation.cpp",
      "reports/studies/study_rows.cpp"};
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

}  // namespace
}  // namespace shadefit
