#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/docs/markdown.hpp"
#include "tests/temporary_directory.hpp"

/// The recipes of docs/ci.md pass a clean project and fail one with a fault.
namespace shadefit {
namespace {

namespace fs = std::filesystem;

using testing::TemporaryDirectory;

constexpr const char* clean = "float f(float c) { return exp2((-5.55473 * c - 6.98316) * c); }\n";
constexpr const char* faulty = "float f(float c) { return exp2((-5.55473 * c - 6.8316) * c); }\n";

std::vector<std::string> lines_of_file(const std::string& name) {
  std::ifstream in(fs::path(SHADEFIT_SOURCE_DIR) / name, std::ios::binary);
  return testing::lines_of({std::istreambuf_iterator<char>(in), {}});
}

/// The value behind "KEY: " or "- " at the start of a line of YAML.
std::string behind(const std::string& line, const std::string& key) {
  std::string text = line.substr(std::min(line.find_first_not_of(' '), line.size()));
  if (text.starts_with("- ")) text = text.substr(2);
  return text.starts_with(key) ? text.substr(key.size()) : "";
}

/// The commands of the blocks of YAML that run shadefit.
std::vector<std::string> yaml_commands() {
  std::vector<std::string> commands;
  for (const testing::CodeBlock& block : testing::read_code_blocks(lines_of_file("docs/ci.md"))) {
    for (const std::string& line : block.lines) {
      if (!line.starts_with(' ')) continue;
      const std::string run = behind(line, "run: ");
      const std::string command = run.empty() ? behind(line, "") : run;
      if (command.starts_with("shadefit ")) commands.push_back(command);
    }
  }
  return commands;
}

/// The whole command of the hook, as pre-commit joins it.
std::string hook_command() {
  std::string entry, arguments;
  for (const std::string& line : lines_of_file(".pre-commit-hooks.yaml")) {
    if (const auto value = behind(line, "entry: "); !value.empty()) entry = value;
    if (const auto value = behind(line, "args: "); !value.empty())
      arguments = value.substr(1, value.size() - 2);
  }
  return entry + " " + arguments;
}

/// A project with one shader, and a shell in it that finds shadefit.
class Project {
 public:
  explicit Project(const std::string& shader) {
    folder_.file("project/src/a.glsl", shader);
    fs::create_directory(folder_.path() / "bin");
    fs::create_symlink(SHADEFIT_COMMAND, folder_.path() / "bin" / "shadefit");
  }

  /// The exit code of a command.
  int run(const std::string& command) const {
    const std::string folder = folder_.path().string();
    return WEXITSTATUS(
        std::system(("exec >'" + folder + "/log' 2>&1; cd '" + folder + "/project' && export PATH='" +
                     folder + "/bin':$PATH GITHUB_STEP_SUMMARY=summary.md\n" + command)
                        .c_str()));
  }

  fs::path path() const { return folder_.path() / "project"; }
  void write(const std::string& name, const std::string& text) const {
    folder_.file("project/" + name, text);
  }
  std::string log() const {
    std::ifstream in(folder_.path() / "log");
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  TemporaryDirectory folder_;
};

TEST(CiRecipes, EachCommandFailsForAFaultAlone) {
  std::vector<std::string> commands = yaml_commands();
  ASSERT_EQ(commands.size(), 4U) << "three of GitHub, one of GitLab";
  commands.push_back(hook_command());
  for (const std::string& command : commands) {
    const bool only_reports = command.find("--fail-on never") != std::string::npos;
    EXPECT_EQ(Project(clean).run(command), 0) << command;
    const Project project(faulty);
    EXPECT_EQ(project.run(command), only_reports ? 0 : 1) << command << project.log();
    const auto to_file = command.rfind("> ");
    if (to_file == std::string::npos) continue;
    const std::string file = command.ends_with("\"") ? "summary.md" : command.substr(to_file + 2);
    EXPECT_GT(fs::file_size(project.path() / file), 100U) << file;
  }
}

TEST(CiRecipes, TheTestOfCMakeFailsForAFaultAlone) {
  std::string recipe;
  for (const testing::CodeBlock& block : testing::read_code_blocks(lines_of_file("docs/ci.md")))
    if (!block.lines.empty() && block.lines.front().starts_with("find_program"))
      for (const std::string& line : block.lines) recipe += line + "\n";
  ASSERT_FALSE(recipe.empty());
  for (const char* shader : {clean, faulty}) {
    const Project project(shader);
    project.write(
        "CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.25)\nproject(a LANGUAGES NONE)\nenable_testing()\n" + recipe);
    // Debian's cmake alone brings no make.
    EXPECT_EQ(project.run("cmake -G Ninja -S . -B build"), 0) << project.log();
    const int code = project.run("ctest --test-dir build --no-tests=error");
    EXPECT_EQ(code == 0, shader == clean) << project.log();
  }
}

}  // namespace
}  // namespace shadefit
