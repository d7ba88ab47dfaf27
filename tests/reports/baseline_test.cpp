#include "reports/findings/baseline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "fit/support/decimal.hpp"
#include "reports/io/csv.hpp"
#include "reports/sections/prose.hpp"
#include "reports/sections/report.hpp"
#include "tests/reports/all_results.hpp"

namespace shadefit {
namespace {

using testing::all_results;

Baseline committed() {
  return read_baseline(SHADEFIT_SOURCE_DIR "/reports/baseline");
}

std::string csv_of(const CsvTable& table) {
  std::string out;
  const auto line = [&](const std::vector<std::string>& cells) {
    for (const auto& cell : cells) {
      if (&cell != &cells.front()) out += ',';
      out += cell.find(',') == std::string::npos ? cell : '"' + cell + '"';
    }
    out += '\n';
  };
  line(table.columns);
  for (const auto& row : table.rows) line(row);
  return out;
}

TEST(Baseline, IsWhatIsComputed) {
  const CheckedTables checked = compare(committed(), all_results());
  EXPECT_TRUE(checked.drifts.empty());
  EXPECT_GT(checked.cells, 900U);
}

TEST(Baseline, TheCommittedReportIsTheOneThatIsWritten) {
  EXPECT_TRUE(read_file(SHADEFIT_SOURCE_DIR "/reports/baseline/report.md") == write_report(all_results()))
      << "renew it with ./run run --no-plots --out reports/baseline";
}

TEST(Baseline, TheReportHasNoLongLineOutsideItsTables) {
  std::istringstream lines(write_report(all_results()));
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(line.starts_with('|') || line.size() <= 400) << line;
}

TEST(Baseline, EachLinkWithinTheReportHasItsHeading) {
  const std::string report = write_report(all_results());
  std::set<std::string> anchors;
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("##")) anchors.insert(anchor(line.substr(line.find(' ') + 1)));
  }
  std::size_t links = 0;
  for (std::size_t at = 0; (at = report.find("](#", at)) != std::string::npos; ++links) {
    at += 3;
    const std::string to = report.substr(at, report.find(')', at) - at);
    EXPECT_TRUE(anchors.contains(to)) << to;
  }
  EXPECT_GT(links, anchors.size() / 2);
}

/// The number with its last significant digit changed by one.
std::string mutated(const std::string& number) {
  const auto mantissa_end = std::min(number.find('e'), number.size());
  const auto digit = number.find_last_of("0123456789", mantissa_end - 1);
  std::string changed = number;
  changed[digit] = changed[digit] == '9' ? '8' : static_cast<char>(changed[digit] + 1);
  return changed;
}

// One column at a time: each changed number must be one drift. A number that names its row, such as an
// exponent, makes one row new and another one missing. It gets one more digit, so that no row takes the name
// of another.
TEST(Baseline, EachNumberChangedIsCaught) {
  const Baseline original = committed();
  std::ptrdiff_t numbers = 0;
  for (std::size_t file = 0; file < original.files.size(); ++file) {
    const CsvTable table = parse_csv(original.files[file].content, "baseline");
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      constexpr std::array names{"exponent", "view_angle", "wavelength", "ior"};
      const bool is_key = std::find(names.begin(), names.end(), table.columns[column]) != names.end();
      CsvTable changed = table;
      std::ptrdiff_t expected = 0;
      for (auto& row : changed.rows) {
        if (!parse_number(row[column])) continue;
        ++expected;
        row[column] = is_key ? row[column] + "7" : mutated(row[column]);
      }
      numbers += expected;
      Baseline baseline = original;
      baseline.files[file].content = csv_of(changed);
      const auto drifts = compare(baseline, all_results()).drifts;
      const auto caught = std::count_if(drifts.begin(), drifts.end(), [&](const Drift& d) {
        return d.file == original.files[file].name &&
               (is_key ? d.column.empty() : d.column == table.columns[column]);
      });
      EXPECT_EQ(caught, is_key ? 2 * expected : expected)
          << original.files[file].name << " " << table.columns[column];
    }
  }
  EXPECT_GT(numbers, 2000);
}

/// The committed baseline with one text replaced by another in fits.csv.
std::vector<Drift> drifts_after(const std::string& from, const std::string& to) {
  Baseline baseline = committed();
  auto& content = baseline.files[0].content;
  const auto at = content.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  content.replace(at, from.size(), to);
  return compare(baseline, all_results()).drifts;
}

TEST(Baseline, DriftsHaveTheEffectOnTheCurve) {
  const auto drifts = drifts_after("-5.554727813", "-5.554367813");
  ASSERT_EQ(drifts.size(), 1U);
  EXPECT_EQ(drifts[0].row, "fresnel-quadratic a cosine");
  EXPECT_EQ(drifts[0].column, "fitted");
  EXPECT_EQ(drifts[0].before, "-5.554367813");
  EXPECT_EQ(drifts[0].after, "-5.554727813");
  EXPECT_EQ(
      drifts[0].effect,
      "moves the curve by up to 0.0017 codes of 8-bit sRGB (absolute: 3.7e-06 at c = 0.284; relative: 0.00013 "
      "at c = 0.725; half float: 0.48 ulps)");
}

TEST(Baseline, DriftsOfOtherCells) {
  EXPECT_EQ(drifts_after("0.08112825865", "0.08")[0].effect, "relative change 0.014");
  EXPECT_EQ(drifts_after("0.08112825865", "0")[0].effect, "from 0 by 0.081");
  EXPECT_EQ(drifts_after("-0.520273417", "-0.5")[0].effect, "relative change -0.041") << "it falls";
  EXPECT_EQ(drifts_after("0.08112825865", "0.081128258650")[0].effect,
            "the same number, written differently");
  EXPECT_EQ(drifts_after("confirmed", "refuted")[0].effect, "another word");
}

TEST(Baseline, RowsMissingOrNewAreDrifts) {
  Baseline baseline = committed();
  auto& content = baseline.files[1].content;
  content.erase(content.find("norm-ndf,0.1"), content.find("norm-ndf,1,") - content.find("norm-ndf,0.1"));
  auto drifts = compare(baseline, all_results()).drifts;
  ASSERT_EQ(drifts.size(), 1U);
  EXPECT_EQ(drifts[0].row, "norm-ndf 0.1");
  EXPECT_EQ(drifts[0].effect, "the baseline has no such row");

  baseline = committed();
  baseline.files[1].content += "norm-none,1,1,1,0,1e-12,confirmed\n";
  drifts = compare(baseline, all_results()).drifts;
  ASSERT_EQ(drifts.size(), 1U);
  EXPECT_EQ(drifts[0].effect, "a row that is no longer computed");
}

TEST(Baseline, ReflectancesAreNamedByTheirViewAngle) {
  Baseline baseline = committed();
  auto& content = baseline.files[2].content;
  const std::string cell = "norm-phong,8,45,0.992521818";
  ASSERT_NE(content.find(cell), std::string::npos);
  content.replace(content.find(cell), cell.size(), "norm-phong,8,45,0.982521818");
  const auto drifts = compare(baseline, all_results()).drifts;
  ASSERT_EQ(drifts.size(), 1U);
  EXPECT_EQ(drifts[0].file, "reflectance.csv");
  EXPECT_EQ(drifts[0].row, "norm-phong 8 45");
  EXPECT_EQ(drifts[0].column, "reflectance");
  EXPECT_EQ(drifts[0].effect, "relative change 0.01");
}

}  // namespace
}  // namespace shadefit
