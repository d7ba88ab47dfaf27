#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

#include "app/commands/command_line.hpp"
#include "tests/temporary_directory.hpp"

/// `lint` as a gate: it passes a clean tree, and it can fail.
namespace shadefit {
namespace {

using testing::TemporaryDirectory;

Outcome lint(const std::string& text, const std::vector<std::string>& options = {}) {
  const TemporaryDirectory folder;
  std::ofstream(folder.path() / "a.glsl") << text;
  std::vector<std::string> arguments{"lint", folder.path().string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_command_line(arguments);
}

constexpr const char* right = "float f(float c) { return exp2((-5.55473 * c - 6.98316) * c); }\n";
constexpr const char* wrong = "float f(float c) { return exp2((-5.55473 * c - 6.8316) * c); }\n";

TEST(LintCommand, TakesItsLimits) {
  const std::string typo = "float f(float c) { return exp2((-5.55437 * c - 6.98316) * c); }\n";
  EXPECT_EQ(lint(typo).exit_code, 0);
  EXPECT_EQ(lint(typo, {"--max-effect", "1e-7"}).exit_code, 1);
  EXPECT_EQ(lint("float f(float c) { return exp((-5.55473 * c - 6.98316) * c); }\n").exit_code, 1);
  EXPECT_NE(lint(right, {"--all"}).out.find("fresnel-quadratic"), std::string::npos);
}

TEST(LintCommand, ShowsTheShareOfItsFiles) {
  const TemporaryDirectory folder;
  constexpr int files = 100;
  for (int i = 0; i < files; ++i) std::ofstream(folder.path() / (std::to_string(i) + ".glsl")) << right;
  std::vector<std::string> lines;
  const Progress progress = [&](const std::string& line) { lines.push_back(line); };
  EXPECT_EQ(prepare_command_line({"lint", folder.path().string()}, keep_going, progress).exit_code, 0);
  const auto is_there = [&](const std::string& begin) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.starts_with(begin); });
  };
  EXPECT_TRUE(is_there("reading the source tree"));
  EXPECT_TRUE(is_there("lint 0 %"));
  EXPECT_TRUE(is_there("lint 50 %")) << lines.size();
  EXPECT_EQ(lines.back(), "") << "the line is removed";
}

TEST(LintCommand, BadInput) {
  EXPECT_EQ(run_command_line({"lint", "/no/such/path"}).exit_code, 2);
  EXPECT_EQ(lint(right, {"--fail-on", "rong"}).exit_code, 2);
  EXPECT_EQ(lint(right, {"--baseline", "/no/such/file"}).exit_code, 2);
  EXPECT_EQ(lint(right, {"--max-effect", "-1"}).exit_code, 2);
}

TEST(LintCommand, EndsWithWhatToDo) {
  const TemporaryDirectory folder;
  const std::string file = folder.file("a.glsl", wrong);
  EXPECT_TRUE(
      run_command_line({"lint", file})
          .out.ends_with(
              "lint failed: 1 error in 1 file\nNext: shadefit explain fresnel-quadratic\n      shadefit lint " +
              file +
              " --fix wrong (with --diff it only shows the change)\n      shadefit better fresnel-quadratic\n"));
  EXPECT_TRUE(lint(right).out.ends_with("lint passed: nothing found in 1 file\n"));
  const std::string luma = "float y(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0772)); }\n";
  EXPECT_NE(lint(luma).out.find("Next: shadefit explain luma-709\n"), std::string::npos) << lint(luma).out;
  EXPECT_EQ(lint(luma).out.find("better"), std::string::npos) << "an exact constant has no better one";
  EXPECT_EQ(lint(wrong, {"--format", "json"}).out.find("Next:"), std::string::npos);
  EXPECT_EQ(lint(std::string("// shadefit: ignore for the test\n") + wrong).out.find("Next:"),
            std::string::npos);
}

/// Standard input with this text, until the end of the block.
class StandardInput {
 public:
  explicit StandardInput(const std::string& text) : saved_(::dup(STDIN_FILENO)) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return;
    EXPECT_EQ(::write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
    ::close(ends[1]);
    ::dup2(ends[0], STDIN_FILENO);
    ::close(ends[0]);
  }
  ~StandardInput() {
    ::dup2(saved_, STDIN_FILENO);
    ::close(saved_);
  }
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;

 private:
  int saved_;
};

TEST(LintCommand, ReadsStandardInput) {
  {
    const StandardInput input(wrong);
    const Outcome outcome = run_command_line({"lint", "-"});
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("<stdin>:1:34: error: fresnel-quadratic: ")) << outcome.out;
    EXPECT_EQ(outcome.out.find("--fix"), std::string::npos) << outcome.out;
  }
  const std::string python = "# exp2((-5.55473 * c - 6.8316) * c)\n";
  {
    const StandardInput input(python);
    EXPECT_EQ(run_command_line({"lint", "-", "--language", "python"}).exit_code, 0) << "a comment";
  }
  EXPECT_EQ(
      run_command_line({"lint", "-", "a.glsl"}).err,
      "shadefit: '-' reads standard input: it goes with no other PATH (a file of this name is './-')\n");
  EXPECT_EQ(run_command_line({"lint", "-", "--diff"}).exit_code, 2);
}

}  // namespace
}  // namespace shadefit
