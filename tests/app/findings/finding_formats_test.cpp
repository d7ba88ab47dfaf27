#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/commands/command_line.hpp"
#include "reports/findings/baseline.hpp"
#include "reports/findings/finding.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

// --format of the commands that check: a planted fault is exit 1 in each format, and its place is the
// fault's.
namespace shadefit {
namespace {

using findings::FindingFormat;
using testing::expect_has;
using testing::expect_refusal;
using testing::TemporaryDirectory;
using Words = std::vector<std::string>;

const std::string committed = SHADEFIT_SOURCE_DIR "/reports/baseline";

Outcome in_format(Words words, std::string_view format) {
  words.insert(words.end(), {"--format", std::string(format)});
  return run_command_line(words);
}

/// Runs a command in each format: exit 0 and no finding without a fault, exit 1 and this rule with it.
/// Nothing is on standard error but in text, the form of before.
void expect_in_each_format(const Words& words, const std::string& rule, bool is_faulty) {
  for (const FindingFormat format : findings::finding_formats) {
    const Outcome outcome = in_format(words, name(format));
    EXPECT_EQ(outcome.exit_code, is_faulty ? 1 : 0) << name(format) << outcome.err;
    if (format == FindingFormat::text) {
      const Outcome usual = run_command_line(words);
      EXPECT_EQ(usual.out, outcome.out);
      EXPECT_EQ(usual.err, outcome.err);
      continue;
    }
    EXPECT_EQ(outcome.err, "") << name(format);
    EXPECT_TRUE(outcome.out.ends_with('\n'));
    if (is_faulty) {
      expect_has(outcome.out, rule);
    }
    if (format == FindingFormat::json) {
      const auto json = nlohmann::json::parse(outcome.out);
      EXPECT_EQ(json.at("passed"), !is_faulty);
      EXPECT_EQ(json.at("findings").size(), is_faulty ? 1U : 0U);
    }
  }
}

/// The only finding of a command, as JSON.
nlohmann::json finding_of(const Words& words) {
  const auto json = nlohmann::json::parse(in_format(words, "json").out);
  EXPECT_EQ(json.at("findings").size(), 1U);
  return json.at("findings").at(0);
}

/// The line of a text with this part, from 1.
long line_with(const std::string& text, const std::string& part) {
  return 1 + std::count(text.begin(), text.begin() + static_cast<long>(text.find(part)), '\n');
}

TEST(FindingFormats, OfCheck) {
  const TemporaryDirectory directory;
  for (const File& table : read_baseline(committed).files) directory.file(table.name, table.content);
  const Words command{"check", "--baseline", directory.path().string()};
  expect_in_each_format(command, "changed-cell", false);

  std::string fits = read_file(committed + "/fits.csv");
  const std::string wrong = "0.7875446198";
  directory.file("fits.csv", fits.replace(fits.find("0.7875446197"), wrong.size(), wrong));
  expect_in_each_format(command, "changed-cell", true);
  const auto finding = finding_of(command);
  EXPECT_EQ(finding.at("path"), directory / "fits.csv");
  EXPECT_EQ(finding.at("line"), line_with(fits, wrong));
  EXPECT_EQ(finding.at("fingerprint"), "changed-cell fits.csv sg-offset x 5 cosine fitted");
}

// A number may change by a share of it; on both sides of the limit, in each format.
TEST(FindingFormats, OfCheckWithALimit) {
  const TemporaryDirectory directory;
  for (const File& table : read_baseline(committed).files) directory.file(table.name, table.content);
  const std::string original = read_file(committed + "/fits.csv");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string fits = original;
    directory.file("fits.csv", fits.replace(fits.find(from), from.size(), to));
  };
  const auto limited = [&](const std::string& share) {
    return Words{"check", "--baseline", directory.path().string(), "--fail-above", share};
  };
  with("0.7875446197", "0.77");  // 0.7875446197 / 0.77 - 1 is 2.28 %
  for (const FindingFormat format : findings::finding_formats) {
    EXPECT_EQ(in_format(limited("2.3%"), name(format)).exit_code, 0) << name(format);
    EXPECT_EQ(in_format(limited("2.2%"), name(format)).exit_code, 1) << name(format);
  }
  EXPECT_EQ(finding_of(limited("2.3%")).at("level"), "note");
  EXPECT_EQ(finding_of(limited("2.2%")).at("level"), "error");
  const std::string said = ": 1 difference from " + directory.path().string();
  EXPECT_TRUE(run_command_line(limited("2.3%")).out.ends_with("check passed" + said + ", 0 above 2.3 %\n"));
  EXPECT_TRUE(run_command_line(limited("2.2%")).out.ends_with("check failed" + said + ", 1 above 2.2 %\n"));
  with("0.7875446197", "0");  // from 0, each change is too large
  EXPECT_EQ(run_command_line(limited("99999%")).exit_code, 1);
  with("confirmed", "refuted");  // a word has no share
  EXPECT_EQ(run_command_line(limited("99999%")).exit_code, 1);
  expect_refusal({"check", "--fail-above", "1"},
                 "--fail-above '1' must be a percentage above 0, such as 10%");
}

// Lines above it move a finding, and its fingerprint stays.
TEST(FindingFormats, OfCheckWithRowsThatAreNewOrLost) {
  const TemporaryDirectory directory;
  for (const File& table : read_baseline(committed).files) directory.file(table.name, table.content);
  const Words command{"check", "--baseline", directory.path().string()};
  const std::string table = read_file(committed + "/normalization.csv"),
                    row = "norm-none,1,1,1,0,1e-12,confirmed\n";
  directory.file("normalization.csv", table + row);
  const auto last = finding_of(command);
  EXPECT_EQ(last.at("rule"), "changed-row");
  EXPECT_EQ(last.at("line"), line_with(table + row, row));
  std::string moved = table;
  moved.insert(moved.find('\n') + 1, row);
  directory.file("normalization.csv", moved);
  const auto first = finding_of(command);
  EXPECT_EQ(first.at("line"), 2);
  EXPECT_EQ(first.at("fingerprint"), last.at("fingerprint"));

  directory.file("normalization.csv", table.substr(0, table.rfind('\n', table.size() - 2) + 1));
  const auto lost = finding_of(command);
  EXPECT_EQ(lost.at("rule"), "changed-row");
  EXPECT_EQ(lost.at("line"), 1) << "the header: the row has no place";
}

TEST(FindingFormats, OfCheckOfAStudy) {
  const TemporaryDirectory directory;
  const std::string folder = directory / "a b";
  ASSERT_EQ(run_command_line({"run", "acos-linear", "--no-plots", "--out", folder}).exit_code, 0);
  const Words command{"check", "acos-linear", "--baseline", folder};
  expect_in_each_format(command, "changed-cell", false);
  std::string table = read_file(folder + "/better.csv");
  const std::string digits = "0.0090";
  ASSERT_NE(table.find(digits), std::string::npos) << table;
  directory.file("a b/better.csv", table.replace(table.find(digits), digits.size(), "0.0091"));
  expect_in_each_format(command, "changed-cell", true);
  EXPECT_EQ(finding_of(command).at("line"), line_with(table, "0.0091"));
  expect_has(in_format(command, "sarif").out, "a%20b/better.csv");
}

// What is no finding but a wrong call is one line on standard error in each format.
TEST(FindingFormats, BadInputIsNoFinding) {
  const TemporaryDirectory directory;
  for (const FindingFormat format : findings::finding_formats) {
    const Outcome outcome = in_format({"check", "--baseline", directory / "none"}, name(format));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("shadefit: baseline '")) << outcome.err;
  }
  expect_refusal({"check", "--format", "xml"},
                 "--format 'xml' is unknown: it must be one of text, json, sarif, github, markdown");
}

}  // namespace
}  // namespace shadefit
