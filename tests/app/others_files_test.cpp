#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/process.hpp"
#include "tests/temporary_directory.hpp"

/// Foreign files beside ours, and places that are not files.
namespace shadefit {
namespace {

using testing::expect_refusal;
using testing::run_process;
using testing::snapshot;
using testing::TemporaryDirectory;
namespace fs = std::filesystem;

constexpr const char* material = "newmtl shiny\nNs 20\nKs 0.5 0.4 0.3\nillum 2\n";

std::vector<std::string> emit_to(const std::string& file) {
  return {"emit", "fresnel-quadratic", "--lang", "glsl", "--out", file};
}

std::string foreign_refusal(const std::string& file) {
  return "'" + file + "' was not written by shadefit: move it away, or replace it with --force";
}

TEST(OthersFiles, ASceneLeavesThemWhereTheyAre) {
  const TemporaryDirectory directory;
  const std::string scene = directory.file("a.mtl", material);
  directory.file("scene.png", "of the user\n");
  const auto before = snapshot(directory.path());
  EXPECT_EQ(run_command_line({"scene", scene, "--out", directory.path().string()}).exit_code, 0);
  auto after = snapshot(directory.path());
  for (const auto& [name, content] : before) EXPECT_EQ(after[name], content) << name;
  EXPECT_EQ(after.size(), before.size() + 3) << "the plan stands beside them";
}

TEST(OthersFiles, CodeReplacesCodeAlone) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("pair.glsl", "float mine(float c) { return c; }\n");
  expect_refusal(emit_to(file), foreign_refusal(file));
  EXPECT_EQ(run_command_line(testing::with(emit_to(file), {"--force"})).exit_code, 0);
  EXPECT_EQ(run_command_line(emit_to(file)).exit_code, 0);
  expect_refusal({"certify", "fresnel-quadratic", "--out", file}, foreign_refusal(file));
  EXPECT_TRUE(read_file(file).starts_with("// Generated "));
  EXPECT_EQ(snapshot(directory.path()).size(), 1U);
}

TEST(OthersFiles, ALinkStaysAndItsTargetIsWritten) {
  const TemporaryDirectory directory;
  fs::create_directories(directory / "there");
  fs::create_symlink("there/pair.glsl", directory / "link");
  EXPECT_EQ(run_command_line(emit_to(directory / "link")).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(directory / "link"));
  EXPECT_TRUE(read_file(directory / "there/pair.glsl").starts_with("// Generated "));
  fs::create_symlink("circle", directory / "circle");
  const Outcome outcome = run_command_line(emit_to(directory / "circle"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "shadefit: cannot write '" + (directory / "circle") + "': Too many levels of symbolic links\n");
  const std::string too_long = directory / std::string(256, 'x');
  EXPECT_EQ(run_command_line(emit_to(too_long)).err,
            "shadefit: cannot write '" + too_long + "': File name too long\n");
}

TEST(OthersFiles, WhatIsNotAFileStays) {
  const TemporaryDirectory directory;
  const std::string pipe = directory / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& file : {pipe, std::string("/dev/null"), std::string("/dev/full")})
    expect_refusal(emit_to(file), "cannot write '" + file + "': it is a device or a pipe, not a file");
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OthersFiles, WhereNobodyCanBeToldNothingIsWritten) {
  const TemporaryDirectory directory;
  const std::vector<std::string> run{"run",        "--only", "norm-lambert",
                                     "--no-plots", "--out",  directory / "out"};
  const auto break_pipe = [] {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) == 0) ::dup2(ends[1], STDOUT_FILENO);
    for (const int end : ends) ::close(end);
  };
  for (const auto& arguments : {run, emit_to(directory / "pair.glsl")}) {
    for (const auto& [prepare, fault] : std::vector<std::pair<std::function<void()>, std::string>>{
             {[] { ::close(STDOUT_FILENO); }, "Bad file descriptor"},
             {[] { testing::send_output_to("/dev/full"); }, "No space left on device"},
             {break_pipe, "Broken pipe"}}) {
      const auto finished = run_process(arguments, prepare);
      EXPECT_EQ(finished.exit_code, 2);
      EXPECT_EQ(finished.err, "shadefit: cannot write standard output: " + fault + "\n");
    }
    EXPECT_EQ(snapshot(directory.path()).size(), 0U);
  }
  // A filter without files works like other filters.
  const auto filter = run_process({"list"}, break_pipe);
  EXPECT_EQ(filter.exit_code, -1);
  EXPECT_EQ(filter.err, "");
}

// A baseline of an older version.
TEST(OthersFiles, TablesOfAnOlderVersionAreRenewed) {
  const TemporaryDirectory directory;
  fs::copy(SHADEFIT_SOURCE_DIR "/reports/baseline", directory / "baseline");
  EXPECT_EQ(run_command_line({"run", "--only", "norm-lambert", "--no-plots", "--out", directory / "baseline"})
                .exit_code,
            0);
}

}  // namespace
}  // namespace shadefit
