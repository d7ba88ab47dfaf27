#include "reports/studies/gallery.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fit/better/prove_contenders.hpp"
#include "fit/better/round_contenders.hpp"
#include "fit/scalars/half.hpp"
#include "reports/figures/pictures.hpp"
#include "reports/studies/html.hpp"
#include "tests/refusal.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_lacks;

TEST(Html, WritesNumbersAndVerdicts) {
  // An index has links, and what looks like one is text.
  const Table index{{"id", "source"}, {{word("a-b"), word("<a href=x>")}}};
  EXPECT_NE(html_table(index, true).find("<td><a href=\"a-b.html\">a-b</a></td><td>&lt;a href=x&gt;</td>"),
            std::string::npos)
      << html_table(index, true);
  const Table table{{"x", "verdict"},
                    {{Number{0.5, 4}, word("refuted")}, {Number{2, 4}, word("other-objective: minimax")}}};
  const std::string html = html_table(table, true);
  expect_has(html, "<td class=\"number\"><a href=\"0.5.html\">0.5</a></td>");
  expect_has(html, "<td class=\"refuted\">refuted</td>");
  expect_has(html, "<td class=\"partly\">other-objective: minimax</td>");
  expect_has(html, "<button type=\"button\">x</button>");
  const std::string plain = html_table(table, false);
  expect_lacks(plain, "<button");
  expect_has(plain, "<td class=\"number\">0.5</td>");
}

/// A page has no address outside itself: it works without a network.
TEST(Html, StandsAlone) {
  const std::string page = html_page(OthersText("a & b"), "<p>text</p>");
  expect_has(page, "<title>a &amp; b</title>");
  for (const char* outside : {"http:", "https:", "src=", "@import", "url("}) expect_lacks(page, outside);
}

/// x^2 by a line on [0, 1]: the best is x - 1/8, with error 1/8.
GalleryEntry parabola() {
  GalleryEntry entry;
  entry.file.id = "parabola";
  entry.file.title = OthersText("a parabola by a line");
  entry.file.study = {.target = "x^2", .form = "", .over = {{"x", "0", "1"}}};
  entry.file.forms = {{"line", "a x + b"}};
  entry.file.published = {{.form = "line",
                           .values = {{"a", "1.00"}, {"b", "-0.05"}},
                           .source = OthersText("Doe 2020"),
                           .where = {OthersText("doe/lines@1234 a/b: f"), OthersText("doe/lines@1234 c")}}};
  return entry;
}

GalleryEntry compared(GalleryEntry entry) {
  entry.comparisons = {compare_study(entry.file, entry.file.study)};
  return entry;
}

TEST(Gallery, HasARowForEachPublishedSet) {
  GalleryEntry entry = compared(parabola());
  const std::vector<JudgedStudy> studies{judged_study(entry)};
  const Table table = gallery_table(studies);
  ASSERT_EQ(table.rows.size(), 1U);
  const auto cell = [&](const char* column) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), column);
    return text(table.rows.front()[static_cast<std::size_t>(found - table.columns.begin())],
                Precision::report);
  };
  EXPECT_EQ(cell("id"), "parabola");
  EXPECT_EQ(cell("used_in"), "doe/lines");
  EXPECT_EQ(cell("published"), "0.2");
  EXPECT_EQ(cell("best"), "0.125");
  EXPECT_EQ(cell("ratio"), "1.6");
  EXPECT_EQ(cell("best_form"), "line, minimax");

  const auto files = gallery_files(studies);
  ASSERT_EQ(files.size(), 3U);
  const std::string& page = files.back().content;
  EXPECT_EQ(files.back().name, "parabola.html");
  for (const char* part :
       {"<svg", "polyline class=\"curve-2\"", "float parabola(float x)", "Doe 2020", "refuted"})
    expect_has(page, part);
}

/// x itself is exact at both ends of x^2, as no other line is: the best line has half its error and neither
/// end.
TEST(Gallery, ABetterSetKeepsWhatThePublishedOneHas) {
  GalleryEntry entry = parabola();
  entry.file.published.front().values = {{"a", "1"}, {"b", "0"}};
  entry = compared(entry);
  const StudyComparison& comparison = entry.comparisons.front();
  const StudyContender& published = comparison.contenders.front();
  EXPECT_EQ(to_text(published.properties), "exact at x = 0, exact at x = 1, rises, not negative, at most 1");
  EXPECT_EQ(better_at_the_same_cost(comparison, published), nullptr);
  const StudyContender* least = least_error_at_the_same_cost(comparison, published);
  ASSERT_NE(least, nullptr);
  EXPECT_EQ(to_text(lost_properties(published.properties, least->properties)),
            "exact at x = 0, exact at x = 1, not negative");
  const auto kept = std::find_if(
      comparison.contenders.begin(), comparison.contenders.end(), [](const StudyContender& contender) {
        return contender.origin == "minimax, exact at x = 0, exact at x = 1, form rises";
      });
  ASSERT_NE(kept, comparison.contenders.end()) << "the fit under constraints";
  EXPECT_NEAR(kept->values[0], 1, 1e-14);
  EXPECT_NEAR(kept->max_error.magnitude, 0.25, 1e-14);
  EXPECT_NEAR(kept->effect.absolute.magnitude, 0.25, 1e-14);
}

TEST(Gallery, ProvesTheErrorsThatItShows) {
  GalleryEntry entry = compared(parabola());
  StudyComparison& comparison = entry.comparisons.front();
  prove_contenders(comparison);
  const StudyContender* published = first_published(comparison);
  const StudyContender* best = better_at_the_same_cost(comparison, *published);
  // x - 0.05 - x^2 is 0.2 at x = 1/2; the best line is off by 1/8.
  for (const auto& [contender, error] : {std::pair{published, 0.2}, std::pair{best, 0.125}}) {
    ASSERT_TRUE(contender->proof) << error;
    EXPECT_LE(contender->proof->lower, error + 1e-15);
    EXPECT_GE(contender->proof->upper, error - 1e-15);
    EXPECT_LE(contender->proof->upper - contender->proof->lower, 1e-4 * error);
  }
  const std::string page = judged_study(entry).page;
  for (const char* part :
       {"Largest error, proven: 0.2 to 0.2", "that it keeps: rises (proven), at most 1 (proven)<",
        "Its properties: rises (proven), at most 1 (proven)<"})
    expect_has(page, part);
  for (const StudyContender& other : comparison.contenders)
    EXPECT_EQ(other.proof.has_value(), &other == published || &other == best) << other.origin.unescaped();
}

/// The largest error of a x + b for x^2, at every half of [0, 1].
double parabola_in_half(double a, double b) {
  double largest = 0;
  for (std::uint16_t bits = 0; bits <= 0x3c00; ++bits) {
    const auto x = Eigen::numext::bit_cast<Eigen::half>(bits);
    const auto form = static_cast<double>(round_to_half(a) * x + round_to_half(b));
    largest = std::max(largest, std::abs(form - static_cast<double>(x) * static_cast<double>(x)));
  }
  return largest;
}

TEST(Gallery, ShowsConstantsInFloatAndHalf) {
  GalleryEntry entry = compared(parabola());
  StudyComparison& comparison = entry.comparisons.front();
  prove_contenders(comparison);
  round_contenders(comparison);
  const StudyContender* published = first_published(comparison);
  for (const StudyContender* contender : {published, better_at_the_same_cost(comparison, *published)}) {
    ASSERT_GE(contender->formats.size(), 2U) << contender->origin.unescaped();
    const ContenderInFormat &in_float = contender->formats[0], &in_half = contender->formats[1];
    EXPECT_EQ(in_float.evidence, ContenderInFormat::Evidence::proven);
    EXPECT_GT(in_float.bound, contender->proof->upper) << "rounding adds to the error in real numbers";
    // the product is below 1, and so is the sum; b may be off by 2^-28
    EXPECT_LE(in_float.bound, contender->proof->upper + 2.1 * 0x1p-24);
    EXPECT_EQ(in_half.evidence, ContenderInFormat::Evidence::every_number);
    EXPECT_NEAR(in_half.bound, parabola_in_half(contender->values[0], contender->values[1]), 1e-15);
  }
  EXPECT_EQ(published->formats[0].constants, (Constants{{"a", "1"}, {"b", "-0.05"}}));
  const std::string page = judged_study(entry).page;
  expect_has(page, "<h2>In float and half</h2>");
  expect_has(page, "<td>every half of the range</td>");

  // 7e4 is beyond half.
  entry.file.published.front().values = {{"a", "1.00"}, {"b", "-70000"}};
  entry = compared(entry);
  round_contenders(entry.comparisons.front());
  const auto& formats = first_published(entry.comparisons.front())->formats;
  ASSERT_EQ(formats.size(), 2U);
  EXPECT_EQ(formats[0].reason, "no bound proven");
  EXPECT_EQ(formats[1].reason, "b overflows: the largest is 65504");
}

TEST(Gallery, SaysWhyConstantsAreNotRounded) {
  GalleryEntry entry = parabola();
  const auto page = [&entry](const char* target) {
    entry = compared(entry);
    entry.comparisons.front().study.target = target;  // now, because fits to a nested integral take long
    round_contenders(entry.comparisons.front());
    return judged_study(entry).page;
  };
  constexpr const char* lead = "The constants are not rounded to float and half: ";
  expect_lacks(page("x^2"), lead);
  EXPECT_NE(page("2 integral(integral(1, t, 0, s), s, 0, x)")
                .find(std::string(lead) + "an 'integral' inside another one has no proof"),
            std::string::npos);
  entry.file.published.clear();
  expect_has(page("x^2"), std::string(lead) + "the study has no published set.");
}

/// Of x^2 shown as greys, a line is off by many codes; of x^2 + 3 nothing is shown.
TEST(Gallery, ShowsGreysWhereTheyAreSeen) {
  GalleryEntry entry = compared(parabola());
  const std::string page = judged_study(entry).page;
  expect_has(page, "As greys");
  EXPECT_NE(page.find("fill=\"rgb(255,255,255)\""), std::string::npos) << "the target at 1";
  // The largest change is 0.2, at 1/2: the sRGB code of 0.45 is 178.7, that of 0.25 is 136.96.
  expect_has(page, "from the target: 0.2 (as a linear grey ");
  entry.file.is_encoded = true;
  entry = compared(entry);
  const std::string encoded = judged_study(entry).page;
  EXPECT_NE(encoded.find("from the target: 0.2 (51 codes of 8 bits, "), std::string::npos) << "0.2 of 255";
  expect_has(encoded, "255 times a value is its code");
  entry.file.study.target = "x^2 + 3";
  entry = compared(entry);
  expect_lacks(judged_study(entry).page, "As greys");
}

/// The target peaks at x = 1/1000, between the first two places of the picture, which are 1/240 apart.
TEST(Gallery, ACurveGoesThroughAPeakBetweenItsPlaces) {
  GalleryEntry entry = parabola();
  entry.file.study.target = "1/(1 + 1000000 (x - 1/1000)^2)";
  entry.file.forms = {{"constant", "a"}};
  entry.file.published = {{.form = "constant", .values = {{"a", "0"}}, .source = OthersText("Doe 2020")}};
  entry = compared(entry);
  const StudyComparison& comparison = entry.comparisons.front();
  const StudyContender* published = first_published(comparison);
  ASSERT_NEAR(published->max_error.magnitude, 1, 1e-6);
  const std::string svg = error_curve_svg(comparison, {published});
  // -1 of +-1.05 in the 200 units below 10; 0.001 of 596 units right of 112
  EXPECT_NE(svg.find(" 112.6,205.2 "), std::string::npos) << svg.substr(0, 800);
}

/// x y by a constant 1/4 on the unit square: too large at the origin, too small at (1, 1), where the error is
/// largest.
TEST(Gallery, HasAMapOfTwoVariables) {
  GalleryEntry entry = parabola();
  entry.file.study.target = "x y";
  entry.file.study.over = {{"x", "0", "1"}, {"y", "0", "1"}};
  entry.file.forms = {{"constant", "a"}};
  entry.file.published = {{.form = "constant", .values = {{"a", "0.25"}}, .source = OthersText("Doe 2020")}};
  entry = compared(entry);
  const std::string svg =
      heat_map_svg(entry.comparisons.front(), {first_published(entry.comparisons.front())});
  EXPECT_NE(svg.find("at most 0.75"), std::string::npos) << svg.substr(0, 400);
  EXPECT_NE(
      svg.find("class=\"under\" x=\"378.0\" y=\"32.0\" width=\"12.0\" height=\"12.0\" fill-opacity=\"1.00\""),
      std::string::npos)
      << "the upper right cell is the worst";
  EXPECT_NE(
      svg.find("class=\"over\" x=\"90.0\" y=\"320.0\" width=\"12.0\" height=\"12.0\" fill-opacity=\"0.33\""),
      std::string::npos)
      << "the lower left cell";
  // 0.25 is code 137: 137 from the target at the origin, 118 from it at (1, 1).
  expect_has(judged_study(entry).page, "Left to right over x, at y = 0, where the published values");
}

/// x + y - a x y is x + y where x or y is 0, and at no other edge of the square.
TEST(Gallery, ExactEdgesAreKept) {
  GalleryEntry entry = parabola();
  entry.file.study.target = "x + y - x^2 y^2";
  entry.file.study.over = {{"x", "0", "1"}, {"y", "0", "1"}};
  entry.file.forms = {{"bilinear", "x + y - a x y"}, {"moved", "x + y - a"}};
  entry.file.published = {{.form = "bilinear", .values = {{"a", "0.3"}}, .source = OthersText("Doe 2020")}};
  entry = compared(entry);
  const StudyComparison& comparison = entry.comparisons.front();
  const StudyContender& published = *first_published(comparison);
  EXPECT_EQ(to_text(published.properties), "exact at x = 0, exact at y = 0, not negative");
  for (const StudyContender& contender : comparison.contenders) {
    if (contender.form != "moved") continue;
    EXPECT_EQ(to_text(lost_properties(published.properties, contender.properties)),
              "exact at x = 0, exact at y = 0, not negative");
  }
  const StudyContender* best = better_at_the_same_cost(comparison, published);
  ASSERT_NE(best, nullptr);
  EXPECT_EQ(best->form, "bilinear");
}

/// Rows have no values between them.
TEST(Gallery, SaysWhyALargestErrorIsNotProven) {
  GalleryEntry entry = parabola();
  entry.file.study.over = {{"x", "", ""}};
  entry.file.study.rows = std::make_shared<const MeasuredRows>(MeasuredRows{
      .file = OthersText("rows.csv"), .places = {{0, 0.5, 1}}, .value = {0, 0.25, 1}, .sigma = {}});
  entry = compared(entry);
  prove_contenders(entry.comparisons.front());
  expect_has(judged_study(entry).page, "Largest error, sampled: the error is known at the rows alone");
}

/// A gain of less than 1 % is not called better.
TEST(Gallery, LeavesRoundedConstantsAlone) {
  GalleryEntry entry = parabola();
  entry.file.published.front().values = {{"a", "1.000"}, {"b", "-0.125"}};
  entry.file.norm = Norm::minimax;
  entry = compared(entry);
  const StudyComparison& comparison = entry.comparisons.front();
  ASSERT_NE(comparison.contenders.front().published, nullptr);
  EXPECT_EQ(better_at_the_same_cost(comparison, comparison.contenders.front()), nullptr);
}

}  // namespace
}  // namespace shadefit
