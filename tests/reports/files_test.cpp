#include "reports/io/files.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>
#include <functional>
#include <map>

#include "reports/io/output.hpp"
#include "reports/io/own_file.hpp"
#include "tests/refusal.hpp"
#include "tests/reports/stop.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::refusal;
using testing::snapshot;
using testing::Stop;
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
  EXPECT_EQ(
      refusal([&] { require_directory(file); }),
      "output directory '" + file + "' is not a directory: it must be a directory, or free to become one");
  EXPECT_EQ(refusal([&] {
              write_files(file + "/x/y", {{"one", "1"}});
            }),
            "output directory '" + file + "/x/y' lies below '" + file +
                "', which is not a directory: it must be a directory, or free to become one");
  EXPECT_EQ(refusal([&] { require_directory(""); }), "output directory '' is empty: name a directory");
  EXPECT_EQ(refusal([&] { require_directory(directory / "new/one"); }), "");
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

TEST(Files, ADirectoryMadeForNothingIsRemoved) {
  const TemporaryDirectory directory;
  EXPECT_NE(refusal([&] { write_files(directory / "new", {{std::string(300, 'x'), "1"}}); }), "");
  EXPECT_FALSE(fs::exists(directory / "new"));
}

/// A checkpoint that does something at its n-th call, counted from 1.
Checkpoint at_call(int n, const std::function<void()>& act) {
  return [n, act, calls = 0]() mutable {
    if (++calls == n) act();
  };
}

TEST(Files, AnInterruptionAtEachCheckpointLeavesEverythingAsItWas) {
  const std::vector<File> files{{"one", "new 1\n"}, {"two", "new 2\n"}, {"three", "new 3\n"}};
  // One call before each file, one before the first of them is renamed.
  const int calls = 4;
  for (int n = 1; n <= calls; ++n) {
    const TemporaryDirectory directory;
    directory.file("out/one", "old 1\n");
    directory.file("out/three", "old 3\n");
    const auto before = snapshot(directory.path());
    const auto stop = [n] { return at_call(n, [] { throw Stop{}; }); };
    EXPECT_THROW(write_files(directory / "out", files, stop()), Stop) << n;
    EXPECT_EQ(snapshot(directory.path()), before) << n;
    EXPECT_THROW(write_files(directory / "a/b/c", files, stop()), Stop) << n;
    EXPECT_EQ(snapshot(directory.path()), before) << "directories made for nothing are removed, call " << n;
  }
  const TemporaryDirectory directory;
  directory.file("out/one", "old 1\n");
  write_files(directory / "out", files, at_call(calls + 1, [] { throw Stop{}; }));
  EXPECT_EQ(snapshot(directory / "out"), (std::map<std::string, std::string>{
                                             {"one", "new 1\n"}, {"two", "new 2\n"}, {"three", "new 3\n"}}))
      << "once the first is renamed nothing stops it, and nothing is left beside";
}

// As on a full disk: the first file fits, the second does not.
TEST(Files, AFullDiskAtALaterFile) {
  const TemporaryDirectory directory;
  directory.file("out/one", "old\n");
  const auto before = snapshot(directory.path());
  rlimit unlimited{};
  ::getrlimit(RLIMIT_FSIZE, &unlimited);
  const rlimit limited{1024, unlimited.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);  // as main does
  ::setrlimit(RLIMIT_FSIZE, &limited);
  const std::string message = refusal([&] {
    write_files(directory / "out", {{"one", "new\n"}, {"two", std::string(5000, 'x')}});
  });
  ::setrlimit(RLIMIT_FSIZE, &unlimited);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message, "cannot write '" + (directory / "out/two") + "': File too large");
  EXPECT_EQ(snapshot(directory.path()), before);
}

// The last file's place becomes a directory after every check: the renames before it have to be taken back.
TEST(Files, ARenameThatFailsTakesTheEarlierOnesBack) {
  const TemporaryDirectory directory;
  directory.file("out/one", "old 1\n");
  fs::create_symlink("one", directory / "out/link");
  const auto before = snapshot(directory.path());
  const auto appear = at_call(5, [&] { fs::create_directories(directory / "out/last"); });
  EXPECT_EQ(refusal([&] {
              write_files(directory / "out",
                          {{"one", "new 1\n"}, {"two", "new 2\n"}, {"link", "new\n"}, {"last", "new\n"}},
                          appear);
            }),
            "cannot write '" + (directory / "out/last") + "': it is a directory");
  fs::remove(directory / "out/last");
  EXPECT_EQ(snapshot(directory.path()), before);
  EXPECT_TRUE(fs::is_symlink(directory / "out/link")) << "the link itself comes back, not a copy";
}

TEST(Files, ObsoleteFilesGoWithTheOthersOrNotAtAll) {
  const TemporaryDirectory directory;
  directory.file("out/one", "old 1\n");
  directory.file("out/plots/gone.svg", sealed("<svg/>", "<!-- ", " -->"));
  directory.file("out/table.csv", "a,b,c\n1,2,3\n");
  directory.file("out/mine.svg", "<svg/>\n");
  directory.file("out/mine.csv", "a,b,z\n");
  directory.file("out/folder/precious", "kept");
  const auto before = snapshot(directory.path());
  const std::vector<File> obsolete{{"plots/gone.svg", ""},  {"table.csv", "a,b,c,d\n"}, {"mine.svg", ""},
                                   {"mine.csv", "a,b,c\n"}, {"none.svg", ""},           {"folder", "x\n"}};
  for (int n = 1; n <= 3; ++n) {
    EXPECT_THROW(write_files(directory / "out", {{"one", "new\n"}, {"two", "new\n"}},
                             at_call(n, [] { throw Stop{}; }), obsolete),
                 Stop);
    EXPECT_EQ(snapshot(directory.path()), before) << n;
  }
  // The place of the last becomes a directory that cannot be removed, when the first is to go.
  const auto appear = at_call(2, [&] {
    fs::remove(directory / "out/table.csv");
    directory.file("out/table.csv/precious", "kept");
  });
  EXPECT_EQ(refusal([&] {
              write_files(directory / "out", {{"one", "new\n"}}, appear, obsolete);
            }),
            "cannot remove '" + (directory / "out/table.csv") + "': it is a directory");
  EXPECT_EQ(read_file(directory / "out/table.csv/precious"), "kept");
  fs::remove_all(directory / "out/table.csv");
  directory.file("out/table.csv", "a,b,c\n1,2,3\n");
  EXPECT_EQ(snapshot(directory.path()), before) << "what was renamed and removed is back";

  write_files(directory / "out", {{"one", "new\n"}}, keep_going, obsolete);
  EXPECT_EQ(snapshot(directory / "out"), (std::map<std::string, std::string>{{"one", "new\n"},
                                                                             {"plots", "/"},
                                                                             {"mine.svg", "<svg/>\n"},
                                                                             {"mine.csv", "a,b,z\n"},
                                                                             {"folder", "/"},
                                                                             {"folder/precious", "kept"}}));
}

/// Whether a file of ours with that beginning may be written over what is there.
bool is_replaced(const TemporaryDirectory& directory, const std::string& name, const std::string& there,
                 const std::string& ours) {
  directory.file("own/" + name, there);
  const std::string message = refusal([&] {
    Output output(directory / "own");
    output.prepare({{name, ours}}, {}, Foreign::refused);
    output.put();
  });
  const bool is_new = read_file(directory / ("own/" + name)) == ours;
  EXPECT_EQ(message.empty(), is_new) << message;
  if (!is_new) {
    EXPECT_EQ(message, "'" + (directory / ("own/" + name)) +
                           "' was not written by shadefit, or was changed since: move it away, or replace it "
                           "with --force");
    EXPECT_EQ(snapshot(directory / "own").size(), 1U) << "nothing is left beside";
  }
  fs::remove_all(directory / "own");
  return is_new;
}

TEST(Files, AFileOfOthersIsNotReplaced) {
  const TemporaryDirectory directory;
  EXPECT_TRUE(is_replaced(directory, "a.csv", "x,y,z\n1,2,3\n", "x,y,z\n4,5,6\n"));
  EXPECT_TRUE(is_replaced(directory, "a.csv", "x,y,z\r\n1,2,3\r\n", "x,y,z\n4,5,6\n"))
      << "as git may check it out";
  EXPECT_TRUE(is_replaced(directory, "a.csv", "x,y,z\n1,2,3\n", "x,y,z,new\n4,5,6,7\n"))
      << "an older version's";
  EXPECT_TRUE(is_replaced(directory, "a.csv", "", "x,y,z\n")) << "nothing is lost";
  EXPECT_FALSE(is_replaced(directory, "a.csv", "x\n1\n", "x,y,z\n4,5,6\n"));
  EXPECT_FALSE(is_replaced(directory, "a.csv", "product,price\n", "x,y,z\n"));
  EXPECT_TRUE(is_replaced(directory, "a.md", "# Ours\n\nold\n", "# Ours\n\nnew\n"));
  EXPECT_FALSE(is_replaced(directory, "a.md", "# Ou\n", "# Ours\n"));
  EXPECT_FALSE(is_replaced(directory, "a.md", "# Ours, or mine\n", "# Ours\n"));
  EXPECT_TRUE(is_replaced(directory, "a.json", "{\n \"schema\": 1,\n \"x\": 2\n}\n",
                          "{\n \"schema\": 1,\n \"x\": 3\n}\n"));
  EXPECT_FALSE(is_replaced(directory, "a.json", "{\n \"schema\": 1,\n \"y\": 2\n}\n",
                           "{\n \"schema\": 1,\n \"x\": 3\n}\n"));
  const std::string script = sealed("plot x\n", "# "), picture = marked_picture("a.svg", "<svg>\n</svg>\n"),
                    pixels = marked_picture("a.png", "pixels and an end..");
  EXPECT_TRUE(is_replaced(directory, "a.gnuplot", sealed("plot y\n", "# "), script));
  EXPECT_FALSE(is_replaced(directory, "a.gnuplot", "# mine\n" + script, script)) << "a change";
  EXPECT_FALSE(is_replaced(directory, "a.gnuplot", script + "# mine\n", script)) << "a change";
  EXPECT_FALSE(is_replaced(directory, "a.gnuplot", "plot x\n", script));
  EXPECT_TRUE(is_replaced(directory, "a.svg", marked_picture("a.svg", "<svg/>"), picture));
  EXPECT_FALSE(is_replaced(directory, "a.svg", "<svg>\n</svg>\n", picture));
  EXPECT_TRUE(is_replaced(directory, "a.png", marked_picture("a.png", "other pixels, same end"), pixels));
  EXPECT_FALSE(is_replaced(directory, "a.png", "pixels and an end..", pixels));
}

TEST(Files, OneForeignFileIsEnoughToWriteNothing) {
  const TemporaryDirectory directory;
  directory.file("out/two.md", "mine\n");
  const auto before = snapshot(directory.path());
  Output output(directory / "out");
  EXPECT_NE(refusal([&] {
              output.prepare({{"one.md", "# One\n"}, {"two.md", "# Two\n"}}, {}, Foreign::refused);
            }),
            "");
  EXPECT_EQ(snapshot(directory.path()), before);
  write_files(directory / "out", {{"two.md", "# Two\n"}});
  EXPECT_EQ(read_file(directory / "out/two.md"), "# Two\n") << "by --force";
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

TEST(Files, ADirectoryIsOneRunsAtATime) {
  const TemporaryDirectory directory;
  const auto begin = [&](Company company) { const Output output(directory / "out", company); };
  {
    const Output first(directory / "out", Company::refused);
    EXPECT_EQ(refusal([&] { begin(Company::refused); }),
              "output directory '" + (directory / "out") +
                  "' is in use by another run: wait for its end, or name another");
    EXPECT_EQ(refusal([&] { begin(Company::welcome); }), "") << "a file of its own name";
  }
  EXPECT_EQ(refusal([&] { begin(Company::refused); }), "");
  EXPECT_FALSE(fs::exists(directory / "out")) << "made for nothing";
}

TEST(Files, ADirectoryThatCannotBeWrittenIsToldAtOnce) {
  EXPECT_NE(refusal([&] { const Output output("/proc"); }), "");
}

TEST(Files, ADetourLeavesNoDirectory) {
  const TemporaryDirectory directory;
  fs::create_directories(directory / "there/below");
  fs::create_directory_symlink("there/below", directory / "link");
  fs::create_symlink("nowhere", directory / "dangling");
  const auto shortened = [&](const std::string& name) {
    return without_detours(directory / name).lexically_relative(directory.path()).string();
  };
  EXPECT_EQ(shortened("new/../new2"), "new2");
  EXPECT_EQ(shortened("new/.//er/../../new2/"), "new2");
  // The system knows where these lead; lexically_relative would shorten them.
  for (const std::string name : {"link/../x", "there/../x", "dangling/../x"})
    EXPECT_EQ(without_detours(directory / name), directory / name);
  EXPECT_EQ(without_detours("none-of-this-name/.."), ".");
  EXPECT_EQ(without_detours("../x"), "../x");
  EXPECT_EQ(without_detours("./x"), "./x");
  EXPECT_EQ(without_detours("/"), "/");
  EXPECT_EQ(without_detours(""), "");

  write_files(directory / "new/../new2", {{"one", "1\n"}});
  EXPECT_EQ(read_file(directory / "new2/one"), "1\n");
  EXPECT_FALSE(fs::exists(directory / "new"));
  write_files(directory / "link/../linked", {{"one", "1\n"}});
  EXPECT_EQ(read_file(directory / "there/linked/one"), "1\n") << "beside what the link leads to";
}

// Linux refuses hard links to files of others (protected_hardlinks), as some file systems refuse any. Only
// root can become somebody else; for all others the links succeed and the outcome has to be the same.
TEST(Files, WithoutHardLinksTheOldFileIsMovedAsideAndBack) {
  const TemporaryDirectory directory;
  const std::string one = directory.file("out/one", "old\n");
  fs::permissions(one, fs::perms::owner_read | fs::perms::owner_write);
  fs::permissions(directory / "out", fs::perms::all);
  const auto before = snapshot(directory / "out");
  const auto as_nobody = [&](const Checkpoint& checkpoint) {
    const pid_t child = ::fork();
    if (child == 0) {
      if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(3);
      try {
        write_files(directory / "out", {{"one", "new\n"}}, checkpoint);
      } catch (const Stop&) {
        ::_exit(1);
      }
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  EXPECT_EQ(as_nobody(at_call(2, [] { throw Stop{}; })), 1);
  EXPECT_EQ(snapshot(directory / "out"), before);
  EXPECT_EQ(as_nobody(keep_going), 0);
  EXPECT_EQ(snapshot(directory / "out"), (std::map<std::string, std::string>{{"one", "new\n"}}));
}

TEST(Files, NamesMayBeginWithADirectory) {
  const TemporaryDirectory directory;
  write_files(directory / "out", {{"plots/one", "1\n"}, {"two", "2\n"}, {"plots/three", "3\n"}});
  EXPECT_EQ(read_file(directory / "out/plots/one"), "1\n");
  EXPECT_EQ(read_file(directory / "out/plots/three"), "3\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory / "out/plots"), fs::directory_iterator()), 2);

  const std::string too_long(300, 'x');
  EXPECT_NE(refusal([&] {
              write_files(directory / "out", {{"plots/one", "new\n"}, {"new/one", "1"}, {too_long, "1"}});
            }),
            "");
  EXPECT_EQ(read_file(directory / "out/plots/one"), "1\n") << "what stood there stays";
  EXPECT_FALSE(fs::exists(directory / "out/new")) << "a directory made for nothing is removed";
  EXPECT_NE(refusal([&] { write_files(directory / "new", {{"plots/one", "1\n"}, {too_long, "1"}}); }), "");
  EXPECT_FALSE(fs::exists(directory / "new"));

  directory.file("taken/plots", "precious");
  EXPECT_EQ(refusal([&] {
              write_files(directory / "taken", {{"two", "2\n"}, {"plots/one", "1\n"}});
            }),
            "cannot create directory '" + (directory / "taken/plots") + "': Not a directory");
  EXPECT_EQ(read_file(directory / "taken/plots"), "precious");
  EXPECT_FALSE(fs::exists(directory / "taken/two"));
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
