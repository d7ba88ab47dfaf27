#include "reports/files.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <functional>
#include <map>

#include "fit/user_error.hpp"
#include "tests/reports/stop.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::snapshot;
using testing::Stop;
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

/// The names that this process uses on the way to `name`, first ".NAME.PID.SUFFIX".
std::string beside(const std::string& name, const std::string& suffix) {
  return "." + name + "." + std::to_string(::getpid()) + "." + suffix;
}

// As a killed run leaves it, whose PID the next one has in a container.
TEST(Files, WritesThroughNothingThatIsAlreadyThere) {
  const TemporaryDirectory directory;
  const std::string precious = directory.file("precious", "kept");
  fs::create_symlink(precious, directory / beside("one", "partial"));
  directory.file(beside("one", "1.partial"), "half");
  auto expected = snapshot(directory.path());
  expected["one"] = "new\n";
  write_files(directory.path(), {{"one", "new\n"}});
  EXPECT_EQ(snapshot(directory.path()), expected) << "what we did not make we neither write nor remove";
  EXPECT_TRUE(fs::is_symlink(directory / beside("one", "partial")));
}

TEST(Files, AFileThatCannotBeCreatedIsNamed) {
  const TemporaryDirectory directory;
  directory.file(beside("one", "partial"), "");
  for (int i = 1; i < 1000; ++i) directory.file(beside("one", std::to_string(i) + ".partial"), "");
  EXPECT_EQ(refusal([&] {
              write_files(directory.path(), {{"one", "new\n"}});
            }),
            "cannot write '" + (directory / "one") + "': cannot create '" +
                (directory / beside("one", "999.partial")) + "': File exists");
  EXPECT_FALSE(fs::exists(directory / "one"));
}

TEST(Files, ADirectoryMadeForNothingIsRemoved) {
  const TemporaryDirectory directory;
  EXPECT_NE(refusal([&] {
              write_files(directory / "new", {{std::string(300, 'x'), "1"}});
            }),
            "nothing was refused");
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
            "cannot write '" + (directory / "out/last") + "': Is a directory");
  fs::remove(directory / "out/last");
  EXPECT_EQ(snapshot(directory.path()), before);
  EXPECT_TRUE(fs::is_symlink(directory / "out/link")) << "the link itself comes back, not a copy";
}

TEST(Files, AnOldFileIsKeptUnderNoNameThatIsTaken) {
  const TemporaryDirectory directory;
  directory.file("one", "old\n");
  directory.file(beside("one", "old"), "precious");
  directory.file(beside("one", "1.old"), "precious too");
  auto expected = snapshot(directory.path());
  // The last file's place becomes a directory: what was renamed before is taken back.
  const auto appear = at_call(3, [&] { fs::create_directories(directory / "last"); });
  EXPECT_NE(refusal([&] {
              write_files(directory.path(), {{"one", "new\n"}, {"last", "new\n"}}, appear);
            }),
            "nothing was refused");
  fs::remove(directory / "last");
  EXPECT_EQ(snapshot(directory.path()), expected);
  write_files(directory.path(), {{"one", "new\n"}});
  expected["one"] = "new\n";
  EXPECT_EQ(snapshot(directory.path()), expected);
}

TEST(Files, ObsoleteFilesGoWithTheOthersOrNotAtAll) {
  const TemporaryDirectory directory;
  directory.file("out/one", "old 1\n");
  directory.file("out/plots/gone", "old 2\n");
  directory.file("out/folder/precious", "kept");
  fs::create_symlink("one", directory / "out/link");
  const auto before = snapshot(directory.path());
  const std::vector<std::string> obsolete{"plots/gone", "link", "none", "none/at-all", "folder"};
  for (int n = 1; n <= 3; ++n) {
    EXPECT_THROW(write_files(directory / "out", {{"one", "new\n"}, {"two", "new\n"}},
                             at_call(n, [] { throw Stop{}; }), obsolete),
                 Stop);
    EXPECT_EQ(snapshot(directory.path()), before) << n;
  }
  // The place of the second becomes a directory that cannot be removed, when the first is to go.
  const auto appear = at_call(2, [&] {
    fs::remove(directory / "out/link");
    directory.file("out/link/precious", "kept");
  });
  EXPECT_TRUE(refusal([&] {
                write_files(directory / "out", {{"one", "new\n"}}, appear, obsolete);
              }).starts_with("cannot remove '" + (directory / "out/link") + "': "));
  EXPECT_EQ(read_file(directory / "out/link/precious"), "kept");
  fs::remove_all(directory / "out/link");
  fs::create_symlink("one", directory / "out/link");
  EXPECT_EQ(snapshot(directory.path()), before) << "what was renamed and removed is back";

  write_files(directory / "out", {{"one", "new\n"}}, keep_going, obsolete);
  EXPECT_EQ(snapshot(directory / "out"),
            (std::map<std::string, std::string>{
                {"one", "new\n"}, {"plots", "/"}, {"folder", "/"}, {"folder/precious", "kept"}}));
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
  // A file of somebody else has the name that the old one would be moved to.
  const auto take_and_stop = [&, calls = 0]() mutable {
    if (++calls == 1) directory.file("out/" + beside("one", "old"), "precious");
    if (calls == 2) throw Stop{};
  };
  EXPECT_EQ(as_nobody(take_and_stop), 1);
  std::size_t precious = 0;
  for (const auto& [name, content] : snapshot(directory / "out")) {
    precious += content == "precious" ? 1 : 0;
    if (content == "precious") fs::remove(directory / ("out/" + name));
  }
  EXPECT_EQ(precious, 1U);
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
            "nothing was refused");
  EXPECT_EQ(read_file(directory / "out/plots/one"), "1\n") << "what stood there stays";
  EXPECT_FALSE(fs::exists(directory / "out/new")) << "a directory made for nothing is removed";
  EXPECT_NE(refusal([&] {
              write_files(directory / "new", {{"plots/one", "1\n"}, {too_long, "1"}});
            }),
            "nothing was refused");
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
