#include "lint/tree/git_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "lint/tree/source_tree.hpp"
#include "tests/fake_gnuplot.hpp"
#include "tests/lint/current_folder.hpp"
#include "tests/temporary_directory.hpp"

/// Which files of a work tree are read, and that nothing in it is run.
namespace shadefit::lint {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

/// A folder of the test's own, in which it stands, with git as it comes.
class GitFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    if (git("--version") != 0) GTEST_SKIP() << "without git: package git";
  }

  static int git(const std::string& arguments) {
    return std::system(("git " + arguments + " >/dev/null 2>&1").c_str());
  }
  void files(const Names& names, const std::string& content = "float a = 0.775;\n") {
    for (const std::string& name : names) directory_.file(name, content);
  }
  static Names found(const std::string& path, const TreeOptions& options = {}) {
    const SourceTree tree = find_sources({path}, options);
    EXPECT_EQ(tree.skipped.messages, Names{});
    Names names;
    for (const SourceFile& file : tree.files) names.push_back(file.name);
    return names;
  }

  testing::TemporaryDirectory directory_;
  testing::StandIn here_{directory_.path()};
  testing::EnvironmentVariable user_{"GIT_CONFIG_GLOBAL", "/dev/null"}, system_{"GIT_CONFIG_NOSYSTEM", "1"};
};

TEST_F(GitFiles, AreTrackedOrNewAndNotIgnored) {
  files({"p/a/x.h", "p/a/y.h", "p/a/kept/x.h", "p/out/z.h", "p/out/sub/x.h", "p/build/k.h", "p/gone.h",
         "p/é.h", "outer.h"});
  files({".gitignore"}, "*.h\n");  // outside of the repository
  files({"p/.gitignore"}, "x.h\n/out/\n");
  files({"p/a/kept/.gitignore"}, "!x.h\n");
  ASSERT_EQ(git("init p"), 0);
  files({"p/.git/info/exclude"}, "y.h\n");
  ASSERT_EQ(git("-C p add --force a/x.h gone.h"), 0);
  fs::remove("p/gone.h");
  EXPECT_EQ(found("p"), (Names{"p/a/kept/x.h", "p/a/x.h", "p/build/k.h", "p/é.h"})) << "a/x.h is tracked";
  EXPECT_EQ(find_sources({"p"}, {}).skipped.ignored, 2U) << "y.h and the folder out";
  EXPECT_EQ(found("p/a"), (Names{"p/a/kept/x.h", "p/a/x.h"}));
  EXPECT_EQ(found("p/out"), (Names{"p/out/sub/x.h", "p/out/z.h"})) << "named, though ignored";
  EXPECT_EQ(found("p", {.exclude = {"a", "build"}}), Names{"p/é.h"});
  EXPECT_EQ(found("."), (Names{"outer.h", "p/a/kept/x.h", "p/a/x.h", "p/build/k.h", "p/é.h"}));
}

TEST_F(GitFiles, OfARepositoryWithinFollowItsOwnRules) {
  files({"a.h", "p/a.h", "p/b.h", "q/a.h", "q/b.h"});
  files({".gitignore"}, "a.h\nq\n");
  files({"p/.gitignore"}, "b.h\n");
  for (const std::string repository : {".", "p", "q"}) ASSERT_EQ(git("init " + repository), 0);
  EXPECT_EQ(found("."), Names{"p/a.h"});
  // As in a hook of another repository.
  const testing::EnvironmentVariable other("GIT_DIR", directory_ / "q/.git");
  EXPECT_EQ(found("p"), Names{"p/a.h"});
}

TEST_F(GitFiles, AreListedWithoutRunningWhatTheTreeNames) {
  const std::string program = directory_.file("trap", "#!/bin/sh\n: >'" + (directory_ / "ran") + "'\n");
  fs::permissions(program, fs::perms::owner_all);
  files({"p/a.h"});
  files({"p/.gitattributes"}, "*.h filter=x diff=x\n");
  ASSERT_EQ(git("init p"), 0);
  ASSERT_EQ(git("-C p add a.h"), 0);
  files({"p/.git/config"},
        "[core]\n\trepositoryformatversion = 1\n\tfsmonitor = " + program + "\n\tpager = " + program +
            "\n\tsshCommand = " + program + "\n\teditor = " + program +
            "\n\thooksPath = " + directory_.path().string() + "\n[pager]\n\tls-files = " + program +
            "\n[alias]\n\tls-files = !" + program + "\n[filter \"x\"]\n\tclean = " + program +
            "\n\tprocess = " + program + "\n[diff \"x\"]\n\ttextconv = " + program +
            "\n[credential]\n\thelper = !" + program + "\n[remote \"o\"]\n\turl = " + (directory_ / "p") +
            "\n\tpromisor = true\n\tuploadpack = " + program + "\n[extensions]\n\tpartialClone = o\n");
  for (const char* hook : {"post-index-change", "post-checkout"}) fs::create_symlink("trap", hook);
  git("-C p status");
  ASSERT_TRUE(fs::remove("ran")) << "git itself runs it";
  EXPECT_EQ(found("p"), Names{"p/a.h"});
  EXPECT_FALSE(fs::exists("ran"));
  fs::create_symlink("trap", "git");
  const testing::EnvironmentVariable here("PATH", ":.");
  EXPECT_EQ(find_sources({"p"}, {}).skipped.messages.size(), 1U);
  EXPECT_FALSE(fs::exists("ran"));
}

TEST_F(GitFiles, AreAllFilesButTheUsualOnesWhereGitRefuses) {
  files({"p/a.h", "p/b.h", "p/build/c.h", "p/node_modules/d.js", "p/src/e.h"});
  EXPECT_EQ(found("p"), (Names{"p/a.h", "p/b.h", "p/src/e.h"})) << "without git, and without a message";
  ASSERT_EQ(git("init p"), 0);
  files({"p/.gitignore"}, "a.h\n");
  EXPECT_EQ(found("p"), (Names{"p/b.h", "p/build/c.h", "p/src/e.h"}));
  const auto expect_refused = [] {
    const SourceTree tree = find_sources({"p", "p/src"}, {});
    EXPECT_EQ(tree.files.size(), 3U);
    EXPECT_EQ(
        tree.skipped.messages,
        Names{
            "git is missing or refuses 'p' (git -C 'p' ls-files says why): files that it ignores are read"});
  };
  {
    const testing::EnvironmentVariable nowhere("PATH", directory_ / "p");
    expect_refused();
  }
  if (::geteuid() == 0) {  // "dubious ownership"
    ASSERT_EQ(::chown("p", 65534, 65534), 0);
    expect_refused();
    ASSERT_EQ(::chown("p", 0, 0), 0);
  }
  files({"p/.git/HEAD"}, "");
  expect_refused();
}

TEST(Repository, IsTheNearestFolderWithGit) {
  const testing::TemporaryDirectory directory;
  directory.file("p/.git", "gitdir: elsewhere\n");
  directory.file("p/a/b/c.h", "");
  EXPECT_EQ(repository_of(directory / "p/a/b"), fs::path(directory / "p"));
  EXPECT_EQ(repository_of(directory / "p"), fs::path(directory / "p"));
  EXPECT_EQ(repository_of("/"), std::nullopt);
}

}  // namespace
}  // namespace shadefit::lint
