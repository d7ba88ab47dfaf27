#include "reports/io/writers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <ctime>
#include <limits>
#include <sstream>

#include "fit/support/user_error.hpp"
#include "reports/io/csv.hpp"
#include "reports/rows/tables.hpp"
#include "reports/sections/report.hpp"
#include "tests/refusal.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_lacks;

const Table sample{{"id", "value", "note"},
                   {{std::string("a"), Number{0.125, 10}, std::string("plain")},
                    {std::string("b|c"), Number{12, 10}, std::string("a \"quoted\", text")},
                    {std::string("d"), {}, {}}}};

// A table may contain cells of a foreign file: none of them can forge a line of ours.
TEST(Writers, ACellCannotForgeALineOnATerminal) {
  const Table table{{"a"}, {{std::string("x\ncheck passed\x1B[2J\xC2\x9B\xE2\x80\xAE\xE2\x80\xA8")}}};
  const std::string shown = write_console(table, Precision::report);
  EXPECT_EQ(std::count(shown.begin(), shown.end(), '\n'), 2) << shown;
  expect_has(shown, "x\\x0acheck passed\\x1b[2J\\xc2\\x9b\\xe2\\x80\\xae\\xe2\\x80\\xa8\n");
}

TEST(Writers, Csv) {
  EXPECT_EQ(write_csv(sample, Precision::report),
            "id,value,note\na,0.125,plain\nb|c,12,\"a \"\"quoted\"\", text\"\nd,,\n");
}

TEST(Writers, Markdown) {
  EXPECT_EQ(write_markdown(sample, Precision::report),
            "| id   | value | note             |\n"
            "|:-----|------:|:-----------------|\n"
            "| a    | 0.125 | plain            |\n"
            "| b\\|c |    12 | a \"quoted\", text |\n"
            "| d    |       |                  |\n");
}

// Four times the rows take four times as long: less than nine, where a table that is looked through for each
// of its rows takes sixteen. Of this thread's own time the least of three.
TEST(Writers, TimeGrowsWithTheRows) {
  const auto time_of = [](std::size_t rows, const auto& write) {
    Table table{{"id", "value"}, std::vector<std::vector<Cell>>(rows, {std::string("a"), Number{0.5, 3}})};
    double least = 1e9;
    for (int i = 0; i < 3; ++i) {
      const std::clock_t start = std::clock();
      EXPECT_GT(write(table, Precision::report).size(), rows);
      least = std::min(least, static_cast<double>(std::clock() - start));
    }
    return least;
  };
  for (const auto& write : {write_markdown, +[](const Table&t, Precision p) { return write_console(t, p); }})
    EXPECT_LT(time_of(80000, write), 9 * time_of(20000, write));
}

TEST(Writers, Latex) {
  const Table table{{"id_1", "value", "note"},
                    {{std::string("a&b%c$d#e_f{g}h"), Number{0.000012, 2}, std::string("~^\\<>|")},
                     {std::string("[x] *"), Number{-2.5, 10}, std::string("Gauß ≤ 1")},
                     {std::string("*"), {}, std::string("-8.656170")},
                     {std::string("two\nlines"), 7L, std::string("1e400")}}};
  EXPECT_EQ(
      write_latex(table, Precision::report),
      "% needs \\usepackage{booktabs}\n"
      "\\begin{tabular}{lrl}\n"
      "\\toprule\n"
      "id 1 & value & note \\\\\n"
      "\\midrule\n"
      "a\\&b\\%c\\$d\\#e\\_f\\textbraceleft{}g\\textbraceright{}h & $1.2\\times10^{-5}$ & "
      "\\textasciitilde{}\\textasciicircum{}\\textbackslash{}\\textless{}\\textgreater{}\\textbar{} \\\\\n"
      "{}[x] * & $-2.5$ & Gauß ≤ 1 \\\\\n"
      "{}* &  & $-8.656170$ \\\\\n"
      "two\\textbackslash{}x0alines & $7$ & 1e400 \\\\\n"
      "\\bottomrule\n"
      "\\end{tabular}\n");
}

TEST(Writers, LatexMathematics) {
  const std::vector<std::pair<Cell, std::string>> cases{
      {word("x = 0.775"), "$x = 0.775$"},
      {word("A = 1.2e-05, x = -8.656170"), "$A = 1.2\\times10^{-5}$, $x = -8.656170$"},
      {word("(a+2)/(8 pi)"), "$\\frac{a + 2}{8 \\pi}$"},
      {word("c^k ~ exp((k+x)(c-1))"), "$c^{k} \\approx e^{\\left(k + x\\right) \\left(c - 1\\right)}$"},
      {word("cosine, k = 6.22 to 10.2"), "cosine, k = 6.22 to 10.2"},  // words stay words
      {word("at c"), "at $c$"},
      {word("at least"), "at least"},
      {word("x = "), "x = "},
      {word("norm-phong"), "norm-phong"},
      {word(""), ""},
      {all_of(1e160), "$1\\times10^{160}$"},
      {all_of(-1.5e-12), "$-1.5\\times10^{-12}$"},
      {all_of(1e20), "$1\\times10^{20}$"},
      {all_of(3e-100), "$3\\times10^{-100}$"},
      {all_of(-0.0), "$0$"},
      {all_of(std::numeric_limits<double>::infinity()), "inf"}};
  for (const auto& [cell, latex] : cases) {
    const std::string out = write_latex({{"v"}, {{cell}}}, Precision::report);
    expect_has(out, "\\midrule\n" + latex + " \\\\\n");
  }
}

TEST(Writers, LatexNamesOfAStudy) {
  const Table table{{"k0", "note"}, {{1L, std::string("k0 r^2")}}};
  const std::vector<std::string> names{"k0", "r"};
  expect_has(write_latex(table, Precision::report, names), "$k_{0}$ & note");
  expect_has(write_latex(table, Precision::report, names), "$k_{0} r^{2}$");
  expect_has(write_latex(table, Precision::report), "k0 r\\textasciicircum{}2");
}

/// The characters of LaTeX's own that are left once escaped ones are taken away.
std::string unescaped(const std::string& text) {
  std::string rest;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
    } else {
      rest += text[i];
    }
  }
  return rest;
}

// What a run writes for LaTeX: rows with as many cells as the tabular has columns, braces and $ in pairs.
TEST(Writers, LatexTablesOfARunAreWellFormed) {
  std::istringstream tables(write_latex_tables(compute_results({})));
  std::ptrdiff_t columns = 0, rows = 0, tabulars = 0;
  for (std::string line; std::getline(tables, line);) {
    const std::string rest = unescaped(line);
    const auto count = [&](char c) { return std::count(rest.begin(), rest.end(), c); };
    EXPECT_EQ(count('{'), count('}')) << line;
    EXPECT_EQ(count('$') % 2, 0) << line;
    EXPECT_EQ(count('#') + count('~') + count('_') + count('<') + count('>') + count('|'), 0) << line;
    if (line.starts_with("\\begin{tabular}{")) {
      columns = std::ssize(line) - std::ssize(std::string("\\begin{tabular}{}"));
      ++tabulars;
    } else if (line.ends_with("\\\\")) {
      EXPECT_EQ(count('&') + 1, columns) << line;
      ++rows;
    }
  }
  EXPECT_EQ(tabulars, 3) << "summary, normalisations, ledger";
  EXPECT_GT(rows, 50);
  EXPECT_EQ(write_latex_tables(compute_results({"fresnel-one-term"})).find("closed"), std::string::npos)
      << "without normalisations there is no table of them";
}

TEST(Writers, Console) {
  EXPECT_EQ(write_console(sample, Precision::report),
            "id   value  note\n"
            "a    0.125  plain\n"
            "b|c     12  a \"quoted\", text\n"
            "d\n");
}

TEST(Writers, Json) {
  EXPECT_EQ(
      write_json(sample).dump(),
      R"([{"id":"a","value":0.125,"note":"plain"},{"id":"b|c","value":12.0,"note":"a \"quoted\", text"},)"
      R"({"id":"d","value":null,"note":null}])");
}

TEST(Writers, CsvReadsBack) {
  const auto table = parse_csv(write_csv(sample, Precision::report), "sample");
  EXPECT_EQ(table.columns, sample.columns);
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"b|c", "12", "a \"quoted\", text"}));
}

TEST(Csv, RefusesWhatIsCutOffOrMalformed) {
  for (const auto& [content, fault] : std::vector<std::pair<std::string, std::string>>{
           {"", "is empty: a table needs a header line"},
           {"a,b\n1,2", "line 2 is truncated: it has no end"},
           {"a,b\n1\n", "line 2 has 1 cells: the header has 2"},
           {"a,b\n1,2\n1,2,3\n", "line 3 has 3 cells: the header has 2"},
           {"a,b\n1,\"2\n", "line 2 opens a quote and never closes it"},
           {"a,b\n1,\"2\"3\n", "line 2 has text after a closing quote"},
           {"a,b\n1,2\"3\"\n", "line 2 has a quote inside a cell that is not quoted"},
           {"a,b\r\n1,2\r\n", "line 1 has a carriage return: lines end in LF alone"},
           {"\xEF\xBB\xBF,b\n", "line 1 begins with a byte order mark: a table is plain UTF-8"},
           {std::string("a,b\n1,\0\n", 8), "line 2 holds the byte 0x00: a table is plain text"},
           {"a,b\n1,2\n\"3", "line 3 is truncated: it has no end"},
           {"a,b\n1,\x1B[2J\n", "line 2 holds the byte 0x1b: a table is plain text"},
           {"a,b\n1,\xED\xA0\x80\n", "line 2 holds the byte 0xed out of place: a table is UTF-8"},
           {"a,b\n1,\xE9t\xE9\n", "line 2 holds the byte 0xe9 out of place: a table is UTF-8"}})
    EXPECT_EQ(testing::refusal([&, text = content] { parse_csv(text, "t.csv"); }), "'t.csv' " + fault);
}

TEST(FitsTable, HasTheColumnsThatOthersRelyOn) {
  const auto table = fits_table({}).table;
  EXPECT_EQ(write_csv(table, Precision::report),
            "constant,parameter,exponent,published,fitted,deviation,verdict,target,form,domain,measure,norm,"
            "rms_error,"
            "max_abs_error,max_abs_error_at,published_max_abs_error,digits,source\n");
  EXPECT_EQ(write_csv(normalisation_table({}), Precision::report),
            "constant,exponent,closed_form,integral,relative_difference,estimated_error,verdict\n");
}

TEST(FitsTable, PublishedNumbersHaveDeviationVerdictAndTheirOwnError) {
  const auto results = compute_results({"fresnel-quadratic"});
  const auto csv = parse_csv(write_csv(fits_table(results.refits).table, Precision::report), "fits");
  ASSERT_EQ(csv.rows.size(), 6U) << "two parameters, three measures";
  EXPECT_EQ(csv.rows[0],
            (std::vector<std::string>{
                "fresnel-quadratic", "a", "", "-5.55473", "-5.554727813", "2.187e-06", "confirmed",
                "(1 - c)^5", "exp2((a c + b) c)", "0:1", "cosine", "least-squares", "0.002238390271",
                "0.003766385943", "0.055357", "0.00376641274", "14",
                "Lagarde 2012, Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel, "
                "seblagarde.wordpress.com/2012/06/03/"
                "spherical-gaussien-approximation-for-blinn-phong-phong-and-fresnel"}));
  EXPECT_EQ(csv.rows[2][6], "other-objective")
      << "the angle measure does not give the printed digits, the cosine does";
}

TEST(FitsTable, AFitThatFailedHasItsStatusAndNoNumbers) {
  FitCache fits(*find_family("sg-offset"));
  const Refit failed = refit(fits, {1e160}, {}, std::array{Metric{}});
  const auto csv = parse_csv(write_csv(fits_table({failed}).table, Precision::full), "fits");
  ASSERT_EQ(csv.rows.size(), 1U);
  EXPECT_EQ(csv.rows[0][4], "");
  EXPECT_EQ(csv.rows[0][6], "degenerate");
  EXPECT_EQ(csv.rows[0][12], "");
}

TEST(Report, NamesTheMetricAndTheVerdictOfEachPublishedValue) {
  const auto results = compute_results({});
  const std::string report = write_report(results);
  for (
      const char* part :
      {"**`sg-offset-mean`** is printed as **0.775**",
       "The fits give 0.7753642585 under the cosine measure, 0.6577007134 under the angle",
       "Verdict: **confirmed**; the printed digits come out under the cosine measure",
       "Verdict: **other-objective**; not a best fit: its digits are those of the convention offset x = 1, "
       "6/ln 2 = 8.656170245",
       "| cosine          |          0.75 |         0.75 |      0.203125 |     0.203125 |", "5.55437",
       "boksajak/brdf", "## Normalisation",
       "is itself off by up to 0.0357 in reflectance on glass (n = 1.5).\nThe published $2^{\\left(a c + b\\right) c}$ (a = "
       "-5.55473, b = -6.98316) is at most 0.00362 from Schlick's formula.\nSchlick's formula is up to 9.9 times as far "
       "from the exact reflectance.\nThe published curve closest to the exact reflectance of that glass is "
       "$2^{-A c}$ (A = 8.35), off by 0.00706.\n",
       "## Exact Fresnel", "aluminium at 652.25 nm, n = 1.5724, k = 7.7354, f0 = 0.9054:",
       "$2^{\\left(a c + b\\right) c}$, refitted: a = -3103.676224, b = -19.75309694",
       "Under the angle measure the best value is the printed one at k = 6.6",
       // one id, one verdict: the ledger's, which includes the integrals
       "| norm-blinn-phong-cheap | (a+8)/(8 pi)                     | 8 of 8 within 0.1      | conditional "}) {
    expect_has(report, part);
  }
  // Nor does a row of its integrals confirm it.
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);)
    EXPECT_FALSE(line.starts_with("| norm-blinn-phong-cheap") && line.ends_with("| confirmed |")) << line;
  EXPECT_TRUE(report.ends_with("Journal of Computer Graphics Techniques 3(2), pp. 48-107\n"));
  EXPECT_FALSE(report.ends_with("\n\n"));
  expect_lacks(report, "\r");
}

TEST(Report, DoesNotDependOnTheLocale) {
  const std::string before = write_report(compute_results({"fresnel-one-term"}));
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_ALL, locale);  // where it is not installed the call changes nothing
    EXPECT_EQ(write_report(compute_results({"fresnel-one-term"})), before) << locale;
  }
  std::setlocale(LC_ALL, "C");
}

TEST(Results, OnlyWhatIsNamedIsComputed) {
  const auto only = compute_results({"norm-phong", "fresnel-quadratic-b"});
  ASSERT_EQ(only.refits.size(), 1U);
  EXPECT_EQ(only.refits[0].family->id, "fresnel-quadratic");
  EXPECT_EQ(only.normalisations.size(), 8U);
  EXPECT_EQ(only.reflectances.size(), 4U);
  EXPECT_TRUE(all_checks_passed(only));
  EXPECT_THROW(compute_results({"norm-fong"}), UserError);
}

TEST(Results, AFailedCheckIsSeen) {
  auto results = compute_results({"norm-lambert", "fresnel-one-term"});
  results.normalisations[0].verdict = Verdict::refuted;
  EXPECT_FALSE(all_checks_passed(results));
  results.normalisations[0].verdict = Verdict::confirmed;
  results.refits[0].fits[0].fit.status = Status::ambiguous;
  EXPECT_FALSE(all_checks_passed(results));
  expect_has(write_report(results), "Not every fit converged");
  results.normalisations[0].verdict = std::nullopt;
  EXPECT_FALSE(all_checks_passed(results));
  expect_has(write_csv(normalisation_table(results.normalisations), Precision::report), "not-converged");
}

}  // namespace
}  // namespace shadefit
