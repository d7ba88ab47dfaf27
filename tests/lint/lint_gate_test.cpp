#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "reports/findings/finding.hpp"
#include "tests/app/refusal.hpp"
#include "tests/lint/current_folder.hpp"
#include "tests/temporary_directory.hpp"

/// Each kind of fault fails `lint` in each format, baselines hold back what is known, and no tree breaks it.
namespace shadefit {
namespace {

namespace fs = std::filesystem;

using testing::expect_refusal;
using testing::StandIn;
using testing::TemporaryDirectory;
using Words = std::vector<std::string>;

Outcome lint_in(const TemporaryDirectory& folder, Words more = {}) {
  more.insert(more.begin(), {"lint", folder.path().string()});
  return run_command_line(more);
}

constexpr const char* clean = "float f(float c) { return exp2((-5.55473 * c - 6.98316) * c); }\n";
constexpr const char* wrong_digit = "float f(float c) { return exp2((-5.55473 * c - 6.8316) * c); }\n";

struct Fault {
  std::string text, rule, fail_on;  ///< the greatest --fail-on that it fails
};

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all{
      {wrong_digit, "wrong-constant", "wrong"},
      {"float f(float c) { return exp2((-55.5473 * c - 6.98316) * c); }\n", "wrong-constant", "wrong"},
      {"float f(float c) { return exp2((-5.55473 * c + 6.98316) * c); }\n", "wrong-expression", "wrong"},
      {"float f(float c) { return exp2((-5.55437 * c - 6.98316) * c); }\n", "typo-constant", "typo"},
      {"float f(float c) { return exp2((-5.5547 * c - 6.9831) * c); }\n", "truncated-constant", "truncated"},
      // IEC 61966-2-1 as its draft of 1996 had it; the standard of 1999 has 0.0031308.
      {"float f(float c) { return c <= 0.00304 ? 12.92 * c : 1.055 * pow(c, 1.0 / 2.4) - 0.055; }\n",
       "outdated-constant", "outdated"},
      {"float a = 1.56; // shadefit: acos-linear.a\n", "pinned-constant", "wrong"},
      {"float a = 1.5707936; // shadefit: acos-linear.a\n", "pinned-constant", "typo"},
      {"float a = 1.5707963; // shadefit: acos-liner.a\n", "unknown-pin", "wrong"},
  };
  return all;
}

/// What a reader of the format takes for a failure.
std::string mark_of_failure(const findings::FindingFormat format) {
  switch (format) {
    case findings::FindingFormat::text:
      return "lint failed: 1 error in 1 file\n";
    case findings::FindingFormat::json:
      return "\"passed\": false";
    case findings::FindingFormat::sarif:
      return "\"level\": \"error\"";
    case findings::FindingFormat::github:
      return "::error file=";
    case findings::FindingFormat::markdown:
      return "### shadefit lint failed";
  }
  return "";
}

TEST(LintGate, ACleanTreePassesInEachFormat) {
  const TemporaryDirectory folder;
  folder.file("src/a.glsl", clean);
  for (const findings::FindingFormat format : findings::finding_formats) {
    const Outcome outcome =
        lint_in(folder, {"--fail-on", "truncated", "--format", std::string(name(format))});
    EXPECT_EQ(outcome.exit_code, 0) << name(format);
    EXPECT_EQ(outcome.out.find(mark_of_failure(format)), std::string::npos) << outcome.out;
  }
}

TEST(LintGate, EachFaultFailsInEachFormat) {
  for (const Fault& fault : faults()) {
    const TemporaryDirectory folder;
    folder.file("src/a.glsl", clean + fault.text);
    for (const findings::FindingFormat format : findings::finding_formats) {
      const Words options{"--fail-on", fault.fail_on, "--format", std::string(name(format))};
      const Outcome outcome = lint_in(folder, options);
      EXPECT_EQ(outcome.exit_code, 1) << name(format) << " " << fault.text << outcome.out;
      EXPECT_NE(outcome.out.find(fault.rule), std::string::npos) << outcome.out;
      EXPECT_NE(outcome.out.find(mark_of_failure(format)), std::string::npos) << outcome.out;
      const bool has_effect = outcome.out.find("; the curve moves by up to ") != std::string::npos;
      EXPECT_EQ(has_effect, fault.rule != "unknown-pin") << outcome.out;
      EXPECT_EQ(outcome.err, "");
    }
  }
}

TEST(LintGate, NoFaultFailsAboveItsGrade) {
  const Words rising{"truncated", "outdated", "typo", "wrong", "never"};
  for (const Fault& fault : faults()) {
    const TemporaryDirectory folder;
    folder.file("src/a.glsl", clean + fault.text);
    const auto above = std::find(rising.begin(), rising.end(), fault.fail_on) + 1;
    EXPECT_EQ(lint_in(folder, {"--fail-on", *above}).exit_code, 0) << fault.text << *above;
  }
}

TEST(LintGate, AnOperationOfLessEffectIsATypo) {
  const TemporaryDirectory folder;
  folder.file("a.glsl", "float f(float c) { return exp2((-5.55473 * c + 6.98316) * c); }\n");
  const Words limit{"--max-effect", "1e6", "--fail-on"};
  for (const std::string& fail_on : Words{"typo", "wrong"}) {
    Words options = limit;
    options.push_back(fail_on);
    const Outcome outcome = lint_in(folder, options);
    EXPECT_EQ(outcome.exit_code, fail_on == "typo" ? 1 : 0) << outcome.out;
    EXPECT_NE(outcome.out.find("[other-expression]"), std::string::npos) << outcome.out;
  }
}

TEST(LintGate, APinnedNumberIsReportedOnce) {
  const TemporaryDirectory folder;
  folder.file(
      "a.glsl",
      "float f(float c) {\n  float a = -5.55437; // shadefit: fresnel-quadratic.a\n"
      "  return exp2((a * c - 6.98316) * c);\n}\n"
      "float g(float c) {\n  return exp2((-5.55473 * c - 6.8316 /* shadefit: fresnel-quadratic.b */) * c);\n}\n");
  const auto json = nlohmann::json::parse(lint_in(folder, {"--format", "json"}).out);
  ASSERT_EQ(json.at("findings").size(), 2U) << json;
  EXPECT_EQ(json.at("findings").at(0).at("line"), 2);
  EXPECT_EQ(json.at("findings").at(0).at("level"), "warning");
  EXPECT_EQ(json.at("findings").at(1).at("line"), 6);
  EXPECT_EQ(json.at("findings").at(1).at("rule"), "pinned-constant");
}

TEST(LintGate, AReasonSuppressesInItsLineAndTheLineBelow) {
  const std::string fault = "exp2((-5.55473 * c - 6.8316) * c)";
  for (const std::string& text :
       Words{fault + "; // shadefit: ignore as in 2012\n", fault + "; # shadefit: ignore: as in 2012\n",
             "/* shadefit: ignore as in 2012 */\n" + fault + ";\n",
             "<!-- shadefit: ignore as in 2012 -->\r\n" + fault + ";\r\n"}) {
    const TemporaryDirectory folder;
    folder.file("a.glsl", "float f(float c) { return\n" + text + "}\n");
    const Outcome outcome = lint_in(folder, {"--format", "json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
    EXPECT_EQ(nlohmann::json::parse(outcome.out).at("findings").at(0).at("suppressed"), "as in 2012");
  }
  const TemporaryDirectory folder;
  folder.file("a.glsl", "// shadefit: ignore as in 2012\n\nfloat f(float c) { return " + fault + "; }\n");
  EXPECT_EQ(lint_in(folder).exit_code, 1) << "an empty line between";
}

TEST(LintGate, ABaselineHoldsBackWhatItKnows) {
  const TemporaryDirectory folder;
  folder.file("src/a.glsl", wrong_digit);
  const StandIn current(folder.path());
  const Words command{"lint", "src", "--format"};
  const auto in_format = [&](const std::string& format, const Words& more) {
    Words words = command;
    words.push_back(format);
    words.insert(words.end(), more.begin(), more.end());
    return run_command_line(words);
  };
  folder.file("known.json", in_format("json", {}).out);
  const Words with_known{"--baseline", "known.json"};
  EXPECT_EQ(in_format("text", with_known).exit_code, 0);
  // The same finding on another line is the same one.
  folder.file("src/a.glsl", std::string("// above\n\n") + wrong_digit);
  EXPECT_EQ(in_format("text", with_known).exit_code, 0);
  EXPECT_NE(in_format("sarif", with_known).out.find("\"baselineState\": \"unchanged\""), std::string::npos);
  // A second one of the kind is new.
  folder.file("src/a.glsl", std::string(wrong_digit) + wrong_digit);
  EXPECT_EQ(in_format("text", with_known).exit_code, 1);
  EXPECT_NE(in_format("sarif", with_known).out.find("\"baselineState\": \"new\""), std::string::npos);
}

TEST(LintGate, TheBaselineOfTheProjectHoldsInEachFolder) {
  const TemporaryDirectory folder;
  folder.file("src/a.glsl", wrong_digit);
  folder.file(".git/HEAD", "");
  folder.file(".shadefit.toml", "[lint]\npaths = [\"src\"]\n");
  const StandIn project(folder.path());
  folder.file("known.json", run_command_line({"lint", "--format", "json"}).out);
  folder.file(".shadefit.toml", "[lint]\npaths = [\"src\"]\nbaseline = \"known.json\"\n");
  EXPECT_EQ(run_command_line({"lint"}).exit_code, 0);
  const StandIn below(folder.path() / "src");
  for (const Words& words : {Words{"lint"}, Words{"lint", "a.glsl"}, Words{"lint", folder / "src"}})
    EXPECT_EQ(run_command_line(words).exit_code, 0) << words.back();
}

TEST(LintGate, BadInputIsOneLine) {
  const TemporaryDirectory folder;
  const StandIn current(folder.path());
  const Outcome missing = run_command_line({"lint", "no/such/folder"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_EQ(std::count(missing.err.begin(), missing.err.end(), '\n'), 1) << missing.err;
  EXPECT_NE(missing.err.find("no/such/folder"), std::string::npos) << missing.err;
  fs::create_symlink("nowhere.glsl", "dangling.glsl");
  EXPECT_EQ(run_command_line({"lint", "dangling.glsl"}).exit_code, 2);
  ASSERT_EQ(::mkfifo("pipe.glsl", 0600), 0);
  expect_refusal({"lint", "pipe.glsl"}, "cannot read 'pipe.glsl': it is not a regular file");
  expect_refusal({"lint", ".", "--baseline", "pipe.glsl"},
                 "cannot read 'pipe.glsl': it is not a regular file");
  folder.file("huge.glsl", "");
  fs::resize_file("huge.glsl", (std::uintmax_t{4} << 20) + 1);
  expect_refusal({"lint", "huge.glsl"}, "cannot read 'huge.glsl': it has 4194305 bytes, more than 4194304");
  EXPECT_EQ(run_command_line({"lint", "."}).exit_code, 0) << "below a folder it is only counted";
  folder.file("a.json", "{}");
  expect_refusal({"lint", ".", "--baseline", "a.json"},
                 "--baseline 'a.json' is not a report of lint: make one with --format json");
  folder.file(".shadefit.toml", "[lint]\nfail-on = \"rong\"\n");
  const Outcome broken = run_command_line({"lint", "."});
  EXPECT_EQ(broken.exit_code, 2);
  EXPECT_EQ(std::count(broken.err.begin(), broken.err.end(), '\n'), 1) << broken.err;
  EXPECT_NE(broken.err.find("did you mean 'wrong'?"), std::string::npos) << broken.err;
}

TEST(LintGate, NoTreeBreaksIt) {
  const TemporaryDirectory folder;
  folder.file("invalid.glsl", std::string("// \xFF\xC3(\xED\xA0\x80 1.5\n") + wrong_digit);
  folder.file("binary.glsl", std::string("1.5\0 6.98316", 12));
  folder.file("empty.glsl", "");
  folder.file("open.glsl", "float f(float c) { return exp2((-5.55473 * c - 6.8316");
  folder.file("huge.glsl", "");
  fs::resize_file(folder.path() / "huge.glsl", std::uintmax_t{1} << 30);  // sparse: takes no room
  fs::create_directory(folder.path() / "a");
  fs::create_directory_symlink("..", folder.path() / "a" / "up");
  fs::create_symlink("loop.glsl", folder.path() / "loop.glsl");
  fs::create_symlink("nowhere", folder.path() / "dangling.glsl");
  const Outcome outcome = lint_in(folder);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("invalid.glsl:2:"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("not read: 1 binary, 1 too large, 3 links"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("huge.glsl"), std::string::npos) << outcome.err;
  for (const char* format : {"json", "sarif", "github", "markdown"}) {
    const Outcome other = lint_in(folder, {"--format", format});
    EXPECT_EQ(other.exit_code, 1) << format;
    EXPECT_NE(other.err.find("not read: 1 binary, 1 too large, 3 links\n"), std::string::npos) << other.err;
  }
}

}  // namespace
}  // namespace shadefit
