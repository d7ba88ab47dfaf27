#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/command_line.hpp"
#include "reports/findings/baseline.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_refusal;
using testing::TemporaryDirectory;

TEST(BadBaseline, FilesAndFolders) {
  const TemporaryDirectory directory;
  const std::string baseline = SHADEFIT_SOURCE_DIR "/reports/baseline";
  const std::string none = directory / "none";
  expect_refusal(
      {"check", "--baseline", none},
      "baseline '" + none +
          "' is missing: name the directory with --baseline, or make one with 'shadefit run --out DIR'");
  const std::string file = directory.file("file", "");
  expect_refusal(
      {"check", "--baseline", file},
      "baseline '" + file +
          "' is not a directory: it must hold fits.csv, normalization.csv, reflectance.csv, fresnel.csv, "
          "claims.csv, better.csv");
  const std::string empty = directory / "empty";
  std::filesystem::create_directories(empty);
  expect_refusal({"check", "--baseline", empty},
                 "cannot read '" + empty + "/fits.csv': there is no such file");

  for (const File& table : read_baseline(baseline).files) directory.file("cut/" + table.name, table.content);
  const auto fits = read_file(baseline + "/fits.csv");
  const std::string cut = directory.file("cut/fits.csv", fits.substr(0, fits.size() - 10));
  expect_refusal({"check", "--baseline", directory / "cut"},
                 "'" + cut + "' line 124 is truncated: it has no end");
  directory.file("cut/fits.csv", fits.substr(0, fits.find('\n') + 1) + "sg-offset,x\n");
  expect_refusal({"check", "--baseline", directory / "cut"},
                 "'" + cut + "' line 2 has 2 cells: the header has 18");
  std::filesystem::resize_file(cut, std::uintmax_t{1} << 30);
  expect_refusal({"check", "--baseline", directory / "cut"},
                 "cannot read '" + cut + "': it has 1073741824 bytes, more than 4194304");
  directory.file("cut/fits.csv", "constant,fitted\nsg-offset,1\n");
  const Outcome other = run_command_line({"check", "--baseline", directory / "cut"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(other.err.starts_with(
      "shadefit: '" + cut + "' has other columns (constant,fitted): they must be constant,parameter,"))
      << other.err;
}

// In each case one file of the baseline is wrong; the other is the committed one.
TEST(BadBaseline, FilesThatAreNoTables) {
  const std::string baseline = SHADEFIT_SOURCE_DIR "/reports/baseline";
  const std::string fits = read_file(baseline + "/fits.csv");
  const auto second_line = fits.find('\n') + 1;
  const auto with = [&](const std::string& bytes) {
    return fits.substr(0, second_line) + bytes + fits.substr(second_line);
  };
  std::string windows = fits;
  for (std::size_t i = 0; (i = windows.find('\n', i)) != std::string::npos; i += 2)
    windows.insert(i, 1, '\r');
  const std::string quote = fits.substr(0, second_line) + "sg-offset,\"x";

  const TemporaryDirectory directory;
  for (const File& table : read_baseline(baseline).files) directory.file(table.name, table.content);
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", " is empty: a table needs a header line"},
      {"\xEF\xBB\xBF" + fits, " line 1 begins with a byte order mark: a table is plain UTF-8"},
      {windows, " line 1 has a carriage return: lines end in LF alone"},
      {with("caf\xE9"), " line 2 holds the byte 0xe9 out of place: a table is UTF-8"},
      {with("\xED\xA0\x80"), " line 2 holds the byte 0xed out of place: a table is UTF-8"},
      {with(std::string(1, '\0')), " line 2 holds the byte 0x00: a table is plain text"},
      {with("\x1B[2J"), " line 2 holds the byte 0x1b: a table is plain text"},
      {quote, " line 2 is truncated: it has no end"},
      {quote + "\n", " line 2 opens a quote and never closes it"},
      {fits + "\n", " line 125 has 1 cells: the header has 18"}};
  for (const auto& [content, rule] : cases) {
    const std::string file = directory.file("fits.csv", content);
    expect_refusal({"check", "--baseline", directory.path().string()}, "'" + file + "'" + rule);
  }
}

}  // namespace
}  // namespace shadefit
