#include <gtest/gtest.h>

#include <filesystem>
#include <string>

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

}  // namespace
}  // namespace shadefit
