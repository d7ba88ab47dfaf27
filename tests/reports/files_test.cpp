#include "reports/io/files.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <map>

#include "reports/io/output.hpp"
#include "tests/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::refusal;
using testing::snapshot;
using testing::TemporaryDirectory;
namespace fs = std::filesystem;

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
  for (const std::string& place : {file, file + "/x/y"})
    EXPECT_EQ(refusal([&] { require_writable(place); }),
              "cannot write to '" + place + "': '" + file + "' is not a directory");
  EXPECT_EQ(refusal([] { require_writable(""); }), "output directory '' is empty: name a directory");
  EXPECT_EQ(refusal([&] { require_writable(directory / "new/one"); }), "");
  EXPECT_EQ(snapshot(directory.path()).size(), 1U) << "asking creates nothing";
  EXPECT_NE(refusal([] { require_writable("/proc"); }), "");
  const std::string too_long = directory / std::string(300, 'x');
  EXPECT_EQ(refusal([&] { require_writable(too_long); }),
            "cannot create directory '" + too_long + "': File name too long");
}

// The place is a directory, the name is too long, the disk is full.
TEST(Files, AFailureLeavesTheOldFileAndNothingHalfWritten) {
  const TemporaryDirectory directory;
  directory.file("out/one", "old\n");
  fs::create_directories(directory / "out/two");
  const auto before = snapshot(directory.path());
  const auto refusal_of = [&](const File& file) {
    return refusal([&] { write_files(directory / "out", {file}); });
  };
  const auto message = [&](const std::string& name, const std::string& fault) {
    return "cannot write '" + (directory / ("out/" + name)) + "': " + fault;
  };
  const std::string too_long(300, 'x');
  EXPECT_EQ(refusal_of({"two", "new\n"}), message("two", "Is a directory"));
  EXPECT_EQ(refusal_of({too_long, "new\n"}), message(too_long, "File name too long"));
  rlimit unlimited{};
  ::getrlimit(RLIMIT_FSIZE, &unlimited);
  const rlimit limited{1024, unlimited.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);  // as main does
  ::setrlimit(RLIMIT_FSIZE, &limited);
  const std::string full = refusal_of({"one", std::string(5000, 'x')});
  ::setrlimit(RLIMIT_FSIZE, &unlimited);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(full, message("one", "File too large"));
  EXPECT_EQ(snapshot(directory.path()), before);
}

TEST(Files, ObsoleteFilesOfOursGo) {
  const TemporaryDirectory directory;
  directory.file("out/plots/gone.svg", marked_picture("<svg/>"));
  directory.file("out/table.csv", "a,b,c\n1,2,3\n");
  directory.file("out/mine.svg", "<svg/>\n");
  directory.file("out/mine.csv", "a,b,z\n");
  directory.file("out/folder/precious", "kept");
  remove_own(directory / "out", {{"plots/gone.svg", ""},
                                 {"table.csv", "a,b,c\n"},
                                 {"mine.svg", ""},
                                 {"mine.csv", "a,b,c\n"},
                                 {"none.svg", ""},
                                 {"folder", "x\n"}});
  EXPECT_EQ(snapshot(directory / "out"), (std::map<std::string, std::string>{{"plots", "/"},
                                                                             {"mine.svg", "<svg/>\n"},
                                                                             {"mine.csv", "a,b,z\n"},
                                                                             {"folder", "/"},
                                                                             {"folder/precious", "kept"}}));
}

TEST(Files, AFileOfOthersIsNotReplaced) {
  struct Case {
    std::string name, there, ours;
    bool is_replaced;
  };
  for (const auto& [name, there, ours, is_replaced] : std::vector<Case>{
           {"a.csv", "x,y,z\n1,2,3\n", "x,y,z\n4,5,6\n", true},
           {"nothing is lost.csv", "", "x,y,z\n", true},
           {"a.csv", "x\n1\n", "x,y,z\n4,5,6\n", false},
           {"a.csv", "product,price\n", "x,y,z\n", false},
           {"a.md", "# Ours\n\nold\n", "# Ours\n\nnew\n", true},
           {"a.md", "# Ou\n", "# Ours\n", false},
           {"a.md", "# Ours, or mine\n", "# Ours\n", false},
           {"a.json", "{\n \"schema\": 1,\n \"x\": 2\n}\n", "{\n \"schema\": 1,\n \"x\": 3\n}\n", true},
           {"a.json", "{\n \"schema\": 1,\n \"y\": 2\n}\n", "{\n \"schema\": 1,\n \"x\": 3\n}\n", false},
           {"a.gnuplot", "# Draws a.svg\nplot y\n", "# Draws a.svg\nplot x\n", true},
           {"a.gnuplot", "plot y\n", "# Draws a.svg\nplot x\n", false},
           {"a.svg", marked_picture("<svg/>"), "<svg>\n</svg>\n", true},
           {"a.svg", "<svg>\n</svg>\n", "<svg>\n</svg>\n", false}}) {
    const TemporaryDirectory directory;
    const std::string place = directory.file(name, there);
    EXPECT_EQ(refusal([&, file = File{name, ours}] {
                require_own(directory.path(), {{"new", ""}, file});
              }),
              is_replaced
                  ? ""
                  : "'" + place + "' was not written by shadefit: move it away, or replace it with --force")
        << name << there;
  }
}

TEST(Files, ModeAndOwnerStay) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("secret", "old\n");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  // Only root can have a file of somebody else here; all others see their own.
  constexpr uid_t other = 65534;
  const bool is_given = ::chown(file.c_str(), other, other) == 0;
  write_files(directory.path(), {{"secret", "new\n"}});
  struct stat now {};
  ASSERT_EQ(::stat(file.c_str(), &now), 0);
  EXPECT_EQ(now.st_mode & 0777U, 0600U);
  EXPECT_EQ(now.st_uid, is_given ? other : ::getuid());
  EXPECT_EQ(read_file(file), "new\n");
}

TEST(Files, NamesMayBeginWithADirectory) {
  const TemporaryDirectory directory;
  write_files(directory / "out", {{"plots/one", "1\n"}, {"two", "2\n"}, {"plots/three", "3\n"}});
  EXPECT_EQ(snapshot(directory / "out"),
            (std::map<std::string, std::string>{
                {"plots", "/"}, {"plots/one", "1\n"}, {"two", "2\n"}, {"plots/three", "3\n"}}));
  directory.file("taken/plots", "precious");
  EXPECT_EQ(refusal([&] {
              write_files(directory / "taken", {{"two", "2\n"}, {"plots/one", "1\n"}});
            }),
            "cannot create directory '" + (directory / "taken/plots") + "': Not a directory");
  EXPECT_EQ(read_file(directory / "taken/plots"), "precious");
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
