#include "reports/findings/finding.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tests/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit::findings {
namespace {

using testing::expect_has;
using testing::expect_lacks;
using testing::TemporaryDirectory;
using Json = nlohmann::json;

/// What the reader of tests/reports/findings/check_findings.py says of a text.
struct Reader {
  int exit_code;
  std::string said;
};

Reader read_by_python(const std::string& text) {
  const TemporaryDirectory directory;
  const std::string command = SHADEFIT_PYTHON " -B " SHADEFIT_SOURCE_DIR
                                              "/tests/reports/findings/check_findings.py '" +
                              directory.file("findings", text) + "' 2>&1";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string said;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    said.append(buffer.data(), n);
  return {WEXITSTATUS(::pclose(pipe)), said};
}

/// A failure, a warning, one that is known and one that is suppressed; and a rule that nothing breaks.
FindingReport usual() {
  return {"lint",
          {{"wrong-constant", "A constant has a wrong digit", "Take the published digits."},
           {"unknown-constant", "A constant has no source", "Name one."},
           {"unused", "Nothing breaks this rule", "Nothing to do."}},
          {{.rule = "wrong-constant",
            .message = "-5.55437 is -5.55473 with two digits swapped",
            .place = {"shaders/fresnel.glsl", 12, 5, 12, 13},
            .fingerprint = "wrong-constant fresnel-quadratic a"},
           {.rule = "unknown-constant",
            .level = FindingLevel::warning,
            .message = "8.35 is in no list",
            .place = {"shaders/lobe.glsl", 3}},
           {.rule = "wrong-constant",
            .message = "0.22 is 0.25",
            .place = {"shaders/bayer.glsl", 7, 1, 0, 0},
            .is_known = true},
           {.rule = "unknown-constant",
            .level = FindingLevel::note,
            .message = "1.7 is in no list",
            .place = {"shaders/lobe.glsl", 9},
            .suppressed = "measured by us"}},
          812,
          "files"};
}

/// What might break a format: quotes, ends of sections, control characters, a byte that is no UTF-8.
const std::string odd_text =
    "a \"b\" 'c' <d> & ]]> {e} | `f` *g* %h, i: j\n::error::\x01\x1b[31m \xFF \xC3\xA9";
const std::string odd_path = "a b/\xC3\xA9:,%#?\"<\x02\xFF.glsl";

FindingReport odd() {
  FindingReport report = usual();
  report.findings[0].message = report.rules[0].title = report.rules[0].help = odd_text;
  report.findings[0].place.path = odd_path;
  report.findings[0].fingerprint = odd_text;
  report.findings[3].suppressed = odd_text;
  return report;
}

FindingReport none() {
  FindingReport report = usual();
  report.findings.clear();
  return report;
}

TEST(Findings, TheFailuresAreErrorsThatNobodySetAside) {
  EXPECT_FALSE(passes(usual()));
  EXPECT_TRUE(passes(none()));
  for (const auto change : {+[](Finding& finding) { finding.is_known = true; },
                            +[](Finding& finding) { finding.suppressed = "a reason"; },
                            +[](Finding& finding) { finding.level = FindingLevel::warning; }}) {
    FindingReport report = usual();
    change(report.findings[0]);
    EXPECT_TRUE(passes(report));
  }
}

TEST(Findings, AsText) {
  EXPECT_EQ(
      write_findings(usual(), FindingFormat::text),
      "shaders/fresnel.glsl:12:5: error: -5.55437 is -5.55473 with two digits swapped [wrong-constant]\n"
      "shaders/lobe.glsl:3: warning: 8.35 is in no list [unknown-constant]\n"
      "lint failed: 1 error, 1 warning in 812 files; 1 suppressed, 1 known\n");
  FindingReport report = none();
  report.checked = 1;
  EXPECT_EQ(write_findings(report, FindingFormat::text), "lint passed: nothing found in 1 file\n");
  const std::string text = write_findings(odd(), FindingFormat::text);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
  expect_lacks(text, "\x1b");
}

TEST(Findings, AsJson) {
  const Json json = Json::parse(write_findings(usual(), FindingFormat::json));
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("passed"), false);
  EXPECT_EQ(json.at("checked"), 812);
  EXPECT_EQ(json.at("counts"),
            Json::parse(R"({"errors": 1, "warnings": 1, "notes": 0, "suppressed": 1, "known": 1})"));
  const Json& first = json.at("findings").at(0);
  EXPECT_EQ(first.at("path"), "shaders/fresnel.glsl");
  EXPECT_EQ(first.at("end_column"), 13);
  EXPECT_EQ(first.at("suppressed"), nullptr);
  EXPECT_EQ(json.at("findings").at(1).at("column"), nullptr);
  EXPECT_EQ(json.at("findings").at(3).at("suppressed"), "measured by us");
  const Json other = Json::parse(write_findings(odd(), FindingFormat::json));
  EXPECT_EQ(other.at("findings").at(0).at("path"), "a b/\xC3\xA9:,%#?\"<\x02\xEF\xBF\xBD.glsl");
}

TEST(Findings, AsSarifByTheSchemaOfTheStandard) {
  for (const FindingReport& report : {usual(), odd(), none()}) {
    const Reader reader = read_by_python(write_findings(report, FindingFormat::sarif));
    EXPECT_EQ(reader.exit_code, 0) << reader.said;
  }
}

TEST(Findings, SarifHasWhatCodeHostsRead) {
  const Json log = Json::parse(write_findings(usual(), FindingFormat::sarif));
  const Json& run = log.at("runs").at(0);
  EXPECT_EQ(run.at("columnKind"), "unicodeCodePoints");
  EXPECT_EQ(run.at("automationDetails").at("id"), "shadefit/lint/");
  const Json& results = run.at("results");
  ASSERT_EQ(results.size(), 4U);
  for (const Json& result : results) {
    const Json& rule = run.at("tool").at("driver").at("rules").at(result.at("ruleIndex").get<std::size_t>());
    EXPECT_EQ(rule.at("id"), result.at("ruleId"));
    EXPECT_GT(result.at("locations").at(0).at("physicalLocation").at("region").at("startLine"), 0);
  }
  EXPECT_EQ(results[0].at("partialFingerprints").at("shadefit/v1"), "wrong-constant fresnel-quadratic a");
  EXPECT_EQ(results[0].at("baselineState"), "new");
  EXPECT_EQ(results[0].at("suppressions"), Json::array());
  EXPECT_EQ(results[2].at("baselineState"), "unchanged");
  EXPECT_EQ(results[3].at("suppressions").at(0).at("justification"), "measured by us");
}

TEST(Findings, APlaceWithoutALineIsTheFirst) {
  FindingReport report = usual();
  report.findings.resize(1);
  report.findings[0].place = {"proof.json"};
  const Json log = Json::parse(write_findings(report, FindingFormat::sarif));
  EXPECT_EQ(log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"],
            Json::parse(R"({"startLine": 1})"))
      << "code hosts want a region";
  EXPECT_TRUE(write_findings(report, FindingFormat::text).starts_with("proof.json: error: "));
  EXPECT_TRUE(write_findings(report, FindingFormat::github).starts_with("::error file=proof.json,title="));
}

TEST(Findings, PathsOfSarifAreUris) {
  const auto artifact_of = [](const std::string& path) {
    FindingReport report = usual();
    report.findings[0].place.path = path;
    const Json log = Json::parse(write_findings(report, FindingFormat::sarif));
    return log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"];
  };
  EXPECT_EQ(artifact_of(odd_path).at("uri"), "a%20b/%C3%A9%3A%2C%25%23%3F%22%3C%02%FF.glsl");
  EXPECT_EQ(artifact_of(odd_path).at("uriBaseId"), "%SRCROOT%");
  EXPECT_EQ(artifact_of("/tables/a b.csv"), Json::parse(R"({"uri": "file:///tables/a%20b.csv"})"));
}

TEST(Findings, AsWorkflowCommands) {
  EXPECT_EQ(
      write_findings(usual(), FindingFormat::github),
      "::error file=shaders/fresnel.glsl,line=12,endLine=12,col=5,endColumn=13,title=A constant has a wrong "
      "digit::-5.55437 is -5.55473 with two digits swapped [wrong-constant]\n"
      "::warning file=shaders/lobe.glsl,line=3,title=A constant has no source::8.35 is in no list "
      "[unknown-constant]\n"
      "lint failed: 1 error, 1 warning in 812 files; 1 suppressed, 1 known\n");
  FindingReport note = usual();
  note.findings.resize(1);
  note.findings[0].level = FindingLevel::note;
  EXPECT_TRUE(write_findings(note, FindingFormat::github).starts_with("::notice file="));
}

TEST(Findings, WorkflowCommandsAreEscaped) {
  FindingReport report = usual();
  report.findings.resize(1);
  report.findings[0].message = "50 %\r\nat a:b,c\x1b";
  report.findings[0].place = {"a,b:c%.glsl", 1};
  report.rules[0].title = "x: y, z\n";
  EXPECT_EQ(write_findings(report, FindingFormat::github),
            "::error file=a%2Cb%3Ac%25.glsl,line=1,title=x%3A y%2C z%0A::50 %25%0D%0Aat a:b,c\\x1b "
            "[wrong-constant]\n"
            "lint failed: 1 error in 812 files\n");
}

TEST(Findings, AsMarkdown) {
  EXPECT_EQ(write_findings(usual(), FindingFormat::markdown),
            R"(### shadefit lint failed: 1 error, 1 warning in 812 files; 1 suppressed, 1 known

| level   | place                     | rule             | finding                                      |
|:--------|:--------------------------|:-----------------|:---------------------------------------------|
| error   | shaders/fresnel.glsl:12:5 | wrong-constant   | -5.55437 is -5.55473 with two digits swapped |
| warning | shaders/lobe.glsl:3       | unknown-constant | 8.35 is in no list                           |

Suppressed:

| level | place               | rule             | finding           | reason         |
|:------|:--------------------|:-----------------|:------------------|:---------------|
| note  | shaders/lobe.glsl:9 | unknown-constant | 1.7 is in no list | measured by us |
)");
  EXPECT_EQ(write_findings(none(), FindingFormat::markdown),
            "### shadefit lint passed: nothing found in 812 files\n");
}

/// What GitHub takes: ten annotations of a step, https://docs.github.com/actions (10 errors, 10 warnings); a
/// summary of 1 MiB; SARIF of 10 MB when compressed, with 25 000 results of a run.
TEST(Findings, AThousandAreWhatGitHubTakes) {
  FindingReport thousand = usual();
  thousand.findings.assign(1000, thousand.findings[1]);
  thousand.findings[998].level = FindingLevel::error;
  for (Finding& finding : thousand.findings) finding.message = std::string(300, 'm');
  const std::string commands = write_findings(thousand, FindingFormat::github);
  EXPECT_TRUE(commands.starts_with("::error ")) << "the most severe first";
  EXPECT_EQ(std::ranges::count(commands, '\n'), 12);
  expect_has(commands, "\n990 more have no annotation\nlint failed: 1 error, 999 warnings in 812 files");
  const std::string summary = write_findings(thousand, FindingFormat::markdown);
  EXPECT_EQ(std::ranges::count(summary, '\n'), 1004) << "all, below three lines and two of the table's head";
  EXPECT_LT(summary.size(), 1u << 20);
  EXPECT_LT(write_findings(thousand, FindingFormat::sarif).size(), 10'000'000);
}

TEST(Findings, MarkdownShowsOddTextsAndLeavesRowsOut) {
  const std::string text = write_findings(odd(), FindingFormat::markdown);
  expect_has(text, "&lt;d&gt; &amp; \\]\\]&gt; {e} &#124; \\`f\\` \\*g\\* %h, i: j\\\\x0a::error::");
  FindingReport many = usual();
  many.findings.assign(20'000, many.findings[0]);
  const std::string cut = write_findings(many, FindingFormat::markdown);
  EXPECT_LT(cut.size(), 1u << 19);
  const auto rows = std::ranges::count(cut, '\n') - 6;
  EXPECT_TRUE(cut.ends_with("|\n\n" + std::to_string(20'000 - rows) + " more are not shown.\n")) << rows;
}

}  // namespace
}  // namespace shadefit::findings
