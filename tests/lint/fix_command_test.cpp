#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/lint/current_folder.hpp"
#include "tests/temporary_directory.hpp"

/// `lint --fix` and `lint --diff`.
namespace shadefit {
namespace {

namespace fs = std::filesystem;

using testing::expect_refusal;
using testing::StandIn;
using testing::TemporaryDirectory;

/// A pin with a cut number, a typo, a wrong digit, and numbers to leave alone.
constexpr const char* faulty =
    "float a = 1.57079f; // shadefit: acos-linear.a\n"
    "float t(float c) { return exp2((-5.55437 * c - 6.98316) * c); }\n"
    "float w(float c) { return exp2((-5.55473 * c - 6.8316) * c); }\n"
    "// exp2((-5.55473 * c - 6.8316) * c)\n"
    "float o(float c) { return exp2((-5.55473 * c + 6.98316) * c); }\n"
    "float i(float c) { return exp2((-5.55473 * c - 6.8316) * c); } // shadefit: ignore as in 2012\n";

std::string replaced(std::string text, const std::string& old, const std::string& fresh) {
  return text.replace(text.find(old), old.size(), fresh);
}

const std::string with_pins = replaced(faulty, "1.57079f", "1.5707963f");
const std::string with_wrong = replaced(with_pins, "6.8316", "6.98316");
const std::string with_typo = replaced(with_wrong, "5.55437", "5.55473");

Outcome lint_fixing(const std::string& path, const std::string& scope, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"lint", path, "--fix", scope});
  return run_command_line(more);
}

TEST(LintFix, WithoutAValueRewritesPins) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("a.glsl", faulty);
  const Outcome shown = run_command_line({"lint", "--fix", "--diff", file});
  EXPECT_NE(shown.out.find("+float a = 1.5707963f;"), std::string::npos) << shown.err;
  EXPECT_EQ(shown.out.find("+float w"), std::string::npos);
  EXPECT_EQ(read_file(file), faulty);
  run_command_line({"lint", file, "--fix"});
  EXPECT_EQ(read_file(file), with_pins);
  expect_refusal({"lint", "--fix", file},
                 "--fix '" + file + "' is unknown: it must be one of pins, typo, wrong");
}

TEST(LintFix, RewritesItsScopeAndNothingElse) {
  for (const auto& [scope, expected] :
       {std::pair("pins", with_pins), std::pair("wrong", with_wrong), std::pair("typo", with_typo)}) {
    const TemporaryDirectory folder;
    const std::string file = folder.file("a.glsl", faulty);
    const Outcome outcome = lint_fixing(folder.path().string(), scope);
    EXPECT_EQ(read_file(file), expected) << scope;
    EXPECT_EQ(outcome.exit_code, 1) << "the wrong expression is left";
    EXPECT_NE(outcome.err.find("shadefit: rewrote "), std::string::npos);
    EXPECT_EQ(testing::snapshot(folder.path()).size(), 1U) << "no file is left beside";
    // Once more changes nothing.
    EXPECT_EQ(lint_fixing(folder.path().string(), scope).err, "");
    EXPECT_EQ(read_file(file), expected);
  }
}

TEST(LintFix, TheExitCodeCountsWhatIsLeft) {
  const TemporaryDirectory folder;
  folder.file("a.glsl", "float w(float c) { return exp2((-5.55473 * c - 6.8316) * c); }\n");
  EXPECT_EQ(lint_fixing(folder.path().string(), "pins").exit_code, 1);
  const Outcome outcome = lint_fixing(folder.path().string(), "wrong");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_EQ(outcome.err, "shadefit: rewrote 1 number in 1 file\n");
  EXPECT_EQ(outcome.out, "lint passed: nothing found in 1 file\n");
}

TEST(LintFix, LeavesShortNumbersBesideWrongOnes) {
  const TemporaryDirectory folder;
  const std::string text = "float w(float c) { return exp2f((-5.5547f * c - 6.8316f) * c); }\n";
  const std::string file = folder.file("a.c", text);
  EXPECT_EQ(lint_fixing(file, "wrong").err, "shadefit: rewrote 1 number in 1 file\n");
  EXPECT_EQ(read_file(file), replaced(text, "6.8316", "6.98316"));
}

/// A program with a wrong number, and the right one.
struct Mended {
  const char* file;
  std::string text, wrong, right;
};

void expect_mended(const std::vector<Mended>& programs) {
  for (const Mended& program : programs) {
    const TemporaryDirectory folder;
    const std::string file = folder.file(program.file, program.text);
    EXPECT_EQ(lint_fixing(file, "wrong").exit_code, 0) << program.text;
    EXPECT_EQ(read_file(file), replaced(program.text, program.wrong, program.right));
  }
}

// The other numbers and the place in the formula show which one it is.
TEST(LintFix, RewritesNumbersOfFewDigitsInEachLanguage) {
  expect_mended({
      {"a.glsl", "// caf\xC3\xA9\r\nfloat f(vec3 c) { return 0.299*c.r + 0.587*c.g + 0.144*c.b; }\r\n",
       "0.144", "0.114"},
      {"a.py", "def f(x):\n  return (x*(2.51*x + .3))/(x*(2.43*x + .59) + .14)  # tone", ".3", ".03"},
      {"a.rs", "fn f(x: f32) -> f32 { (x*(2.51*x + 0.03))/(x*(2.43*x + 0.95_f32) + 0.14) }\n", "0.95",
       "0.59"},
      {"a.js", "const s = `float f(float x) { return (x*(2.51*x + 0.03))/(x*(2.43*x + 0.59) + 0.41); }`;\n",
       "0.41", "0.14"},
      {"A.java", "class A { float f(float x) { return (x*(2.15f*x+.03f))/(x*(2.43f*x+.59f)+.14f); } }\n",
       "2.15f", "2.51f"},
      {"a.cu", "__device__ float f(float c) { return exp2f(fmaf(-5.5547f, c, -6.83f)*c); }\n", "6.83f",
       "6.98316f"},
      {"a.wgsl",
       "fn f(x: f32) -> f32 { let a = 2.51; let b = 0.03; let c = 2.34; let d = 0.59; let e = 0.14;\n"
       "return (x*(a*x + b))/(x*(c*x + d) + e); }\n",
       "2.34", "2.43"},
      {"a.hlsl",
       "float4 c0 = float4(-1, -0.0275, -0.572, 0.022), c1 = float4(1, 0.0425, 1.0, -0.04), r = R*c0 + c1;\n"
       "float a = min(r.x*r.x, exp2(-9.28*v))*r.x + r.y;\nfloat2 AB = float2(-1.04, 1.04)*a + r.zw;\n",
       "1.0,", "1.04,"},
  });
}

TEST(LintFix, RewritesEachComponent) {
  expect_mended({
      {"a.glsl",
       "vec3 f(vec3 u) { return mix(u/12.92, pow((u + 0.055)/1.055, vec3(2.4)), step(vec3(0.4045, 0.4045, "
       "0.4045), u)); }\n",
       "0.4045, 0.4045, 0.4045", "0.04045, 0.04045, 0.04045"},
      {"a.glsl", "vec3 f(vec3 c) { return exp2((-5.55473*c - vec3(6.8, 6.8, 6.8))*c); }\n", "6.8, 6.8, 6.8",
       "6.98316, 6.98316, 6.98316"},
  });
}

TEST(LintFix, LeavesANumberThatMayBeOfTwoSources) {
  // Poynton has 1.875992, pbrt 1.875991.
  const std::string text = "float g(vec3 c) { return dot(c, vec3(-0.969256, 1.875996, 0.041556)); }\n";
  const TemporaryDirectory folder;
  const std::string file = folder.file("a.glsl", text);
  EXPECT_NE(lint_fixing(file, "typo").out.find("1.875996 instead of "), std::string::npos);
  EXPECT_EQ(read_file(file), text);
}

TEST(LintFix, KeepsEveryOtherByte) {
  const std::string start = "\xEF\xBB\xBF// \xFF\xFE caf\xE9\r\n\r\n\tfloat a = ";
  const std::string end = "F; /* shadefit: acos-linear.a */ \r\n// no end of line \xC3";
  const TemporaryDirectory folder;
  const std::string file = folder.file("a.hlsl", start + "1.57" + end);
  EXPECT_EQ(lint_fixing(file, "pins").exit_code, 0);
  EXPECT_EQ(read_file(file), start + "1.5707963" + end);
}

TEST(LintFix, KeepsPermissionsAndLinks) {
  const TemporaryDirectory folder;
  const std::string target = folder.file("real/a.glsl", faulty), link = folder / "link.glsl";
  fs::create_symlink("real/a.glsl", link);
  ::chmod(target.c_str(), 0750);
  lint_fixing(link, "typo");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(read_file(target), with_typo);
  EXPECT_EQ(fs::status(target).permissions(), static_cast<fs::perms>(0750));
}

TEST(LintFix, WritesFilesOfSeveralFolders) {
  const TemporaryDirectory folder;
  for (const char* name : {"a.glsl", "b/a.glsl", "b/c/a.glsl"}) folder.file(name, faulty);
  EXPECT_EQ(lint_fixing(folder.path().string(), "pins").err, "shadefit: rewrote 3 numbers in 3 files\n");
  for (const char* name : {"a.glsl", "b/a.glsl", "b/c/a.glsl"})
    EXPECT_EQ(read_file(folder / name), with_pins);
}

TEST(LintFix, RemovesWhatAKilledRunLeft) {
  const TemporaryDirectory folder;
  folder.file("a/fixed.glsl", with_typo);  // nothing is left to fix there
  folder.file("b/faulty.glsl", faulty);
  // Linux has no process with this number: the largest is 2^22.
  const std::string gone = ".shadefit-99999999-0", here = fmt::format(".shadefit-{}-0", ::getppid());
  for (const char* place : {"a/", "b/"}) folder.file(place + gone, faulty);
  const std::vector<std::string> kept{"a/" + here, "a/.shadefit-99999999-0.glsl", "a/.shadefit-cache"};
  for (const std::string& file : kept) folder.file(file, "of others");
  fs::create_directory(folder / "a/.shadefit-99999999-1");
  run_command_line({"lint", folder.path().string(), "--diff"});
  EXPECT_TRUE(fs::exists(folder / ("a/" + gone))) << "--diff writes nothing";
  lint_fixing(folder.path().string(), "typo");
  for (const char* place : {"a/", "b/"}) EXPECT_FALSE(fs::exists(folder / (place + gone))) << place;
  for (const std::string& file : kept) EXPECT_TRUE(fs::exists(folder / file)) << file;
  EXPECT_TRUE(fs::exists(folder / "a/.shadefit-99999999-1"));
}

TEST(LintDiff, ShowsWhatFixWouldDoAndWritesNothing) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("a.glsl", faulty);
  const Outcome alone = run_command_line({"lint", file, "--diff"});
  EXPECT_EQ(alone.exit_code, 1);
  EXPECT_EQ(alone.out, lint_fixing(file, "pins", {"--diff"}).out);
  EXPECT_NE(alone.out.find("\n-float a = 1.57079f; // shadefit: acos-linear.a\n"
                           "+float a = 1.5707963f; // shadefit: acos-linear.a\n"),
            std::string::npos)
      << alone.out;
  EXPECT_EQ(read_file(file), faulty);
  EXPECT_EQ(alone.put, nullptr);
  folder.file("a.glsl", with_pins);
  const Outcome nothing = run_command_line({"lint", file, "--diff"});
  EXPECT_EQ(nothing.exit_code, 0);
  EXPECT_EQ(nothing.out, "");
}

TEST(LintDiff, IsTakenByGit) {
  for (const char* end : {"\n", "\r\n", ""}) {
    const TemporaryDirectory folder;
    const StandIn current(folder.path());
    const std::string text = replaced(faulty, " as in 2012\n", end);
    folder.file("src/a.glsl", text);
    folder.file("lint.diff", lint_fixing("src", "typo", {"--diff"}).out);
    ASSERT_EQ(std::system("git apply --whitespace=nowarn lint.diff"), 0);
    const std::string patched = read_file("src/a.glsl");
    folder.file("src/a.glsl", text);
    lint_fixing("src", "typo");
    EXPECT_EQ(patched, read_file("src/a.glsl"));
    EXPECT_NE(patched, text);
  }
}

TEST(LintDiff, TakesNoFormat) {
  const TemporaryDirectory folder;
  folder.file("a.glsl", faulty);
  const std::string path = folder.path().string();
  expect_refusal({"lint", path, "--diff", "--format", "json"},
                 "--diff prints a diff: it takes no --format json");
  expect_refusal({"lint", path, "--fix", "all"},
                 "--fix 'all' is unknown: it must be one of pins, typo, wrong");
}

}  // namespace
}  // namespace shadefit
