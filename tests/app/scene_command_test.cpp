#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "app/command_line.hpp"
#include "reports/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_refusal;
using testing::snapshot;
using testing::TemporaryDirectory;

constexpr const char* two_materials =
    "newmtl wall\nNs 50\nKs 0 0 0\nillum 2\n"
    "newmtl floor\nNs 1\nKs 0.5 0.5 0.5\nillum 2\n";

TEST(SceneCommand, SaysWhatIsNeeded) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.mtl", two_materials);
  const Outcome outcome = run_command_line({"scene", file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("2 materials, 1 light, tolerance 0.003922 in linear values\n\nterm "))
      << outcome.out;
  EXPECT_NE(outcome.out.find("skipped for 1 of 2 materials"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nFits run 0, skipped 10.\n"), std::string::npos) << outcome.out;
  EXPECT_EQ(snapshot(directory.path()).size(), 1U) << "nothing is written unless it is asked for";
}

TEST(SceneCommand, WritesThePlan) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.mtl", two_materials);
  const Outcome outcome = run_command_line({"scene", file, "--out", directory / "plan", "--lights", "4"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.ends_with("\nPlan: " + (directory / "plan") + "/scene.md, scene.csv, scene.json\n"))
      << outcome.out;
  const auto written = nlohmann::json::parse(read_file(directory / "plan/scene.json"));
  EXPECT_EQ(written.at("lights"), 4);
  EXPECT_EQ(written.at("materials").size(), 2U);
  EXPECT_EQ(written.at("materials").at(0).at("lobe"), false);
  EXPECT_LE(written.at("error").get<double>(), written.at("tolerance").get<double>());
  EXPECT_TRUE(read_file(directory / "plan/scene.csv")
                  .starts_with("term,verdict,form,error,reason\nspecular,replace,"));
  EXPECT_TRUE(read_file(directory / "plan/scene.md").starts_with("# What this scene needs\n"));
  const Outcome printed = run_command_line({"scene", file, "--json", "--lights", "4"});
  EXPECT_EQ(printed.out, read_file(directory / "plan/scene.json"));
}

TEST(SceneCommand, BadInput) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("a.mtl", two_materials);
  expect_refusal({"scene", file, "--tolerance", "0"}, "--tolerance '0' must be greater than 0 and at most 1");
  expect_refusal({"scene", file, "--tolerance", "1/0"},
                 "--tolerance '1/0' must be greater than 0 and at most 1");
  expect_refusal({"scene", file, "--tolerance", "2"}, "--tolerance '2' must be greater than 0 and at most 1");
  expect_refusal({"scene", file, "--lights", "0"}, "--lights '0' must be a whole number from 1 to 1000000");
  expect_refusal({"scene", file, "--lights", "1.5"},
                 "--lights '1.5' must be a whole number from 1 to 1000000");
  expect_refusal({"scene", file, "--alpha", "cubed"},
                 "--alpha 'cubed' is unknown: it must be roughness or roughness-squared");
  const std::string empty = directory.file("empty.mtl", "");
  expect_refusal({"scene", empty}, "'" + empty + "' holds no material");
}

}  // namespace
}  // namespace shadefit
