#include "reports/files.hpp"

#include <gtest/gtest.h>

#include "fit/user_error.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::TemporaryDirectory;
namespace fs = std::filesystem;

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const UserError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(Files, WritesAllAndLeavesNothingBeside) {
  const TemporaryDirectory directory;
  write_files(directory / "a/b", {{"one", "1\n"}, {"two", "2\n"}});
  EXPECT_EQ(read_file(directory / "a/b/one"), "1\n");
  write_files(directory / "a/b", {{"one", "new\n"}, {"two", ""}});
  EXPECT_EQ(read_file(directory / "a/b/one"), "new\n");
  EXPECT_EQ(read_file(directory / "a/b/two"), "");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory / "a/b"), fs::directory_iterator()), 2);
}

TEST(Files, RefusesADirectoryThatIsAFileOrLiesBelowOne) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("file", "x");
  EXPECT_EQ(refusal([&] { require_directory(file); }),
            "output directory '" + file + "' is no directory: it must be a directory, or free to become one");
  EXPECT_EQ(refusal([&] {
              write_files(file + "/x/y", {{"one", "1"}});
            }),
            "output directory '" + file + "/x/y' lies below '" + file +
                "', which is no directory: it must be a directory, or free to become one");
  EXPECT_EQ(refusal([&] { require_directory(""); }), "output directory '' is empty: name a directory");
  EXPECT_EQ(refusal([&] { require_directory(directory / "new/one"); }), "nothing was refused");
  EXPECT_FALSE(fs::exists(directory / "new")) << "asking creates nothing";
  EXPECT_EQ(read_file(file), "x");
}

TEST(Files, AFailureLeavesOldFilesAndNothingHalfWritten) {
  const TemporaryDirectory directory;
  directory.file("out/one", "old\n");
  fs::create_directories(directory / "out/two");
  EXPECT_EQ(refusal([&] {
              write_files(directory / "out", {{"one", "new\n"}, {"two", "new\n"}});
            }),
            "cannot write '" + (directory / "out/two") + "': it is a directory");
  EXPECT_EQ(read_file(directory / "out/one"), "old\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory / "out"), fs::directory_iterator()), 2);
}

TEST(Files, WritesThroughNothingThatIsAlreadyThere) {
  const TemporaryDirectory directory;
  const std::string precious = directory.file("precious", "kept");
  const auto partial = directory.path() / (".one." + std::to_string(::getpid()) + ".partial");
  fs::create_symlink(precious, partial);
  EXPECT_EQ(refusal([&] {
              write_files(directory.path(), {{"one", "new\n"}});
            }),
            "cannot write '" + (directory / "one") + "': File exists");
  EXPECT_EQ(read_file(precious), "kept");
  EXPECT_TRUE(fs::is_symlink(partial)) << "what we did not make we do not remove";
}

TEST(Files, ADirectoryMadeForNothingIsRemoved) {
  const TemporaryDirectory directory;
  EXPECT_NE(refusal([&] {
              write_files(directory / "new", {{std::string(300, 'x'), "1"}});
            }),
            "nothing was refused");
  EXPECT_FALSE(fs::exists(directory / "new"));
}

TEST(Files, ReadingNamesWhatIsMissing) {
  const TemporaryDirectory directory;
  EXPECT_EQ(refusal([&] { read_file(directory / "none"); }),
            "cannot read '" + (directory / "none") + "': there is no such file");
  EXPECT_EQ(refusal([&] { read_file(directory.path()); }),
            "cannot read '" + directory.path().string() + "': it is a directory");
}

}  // namespace
}  // namespace shadefit
