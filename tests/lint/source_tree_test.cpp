#include "lint/tree/source_tree.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tests/lint/current_folder.hpp"
#include "tests/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit::lint {
namespace {

namespace fs = std::filesystem;
using shadefit::testing::refusal;
using shadefit::testing::StandIn;
using shadefit::testing::TemporaryDirectory;
using Names = std::vector<std::string>;

Names names_of(const SourceTree& tree) {
  Names names;
  for (const SourceFile& file : tree.files) names.push_back(file.name);
  return names;
}

/// A folder of the test's own, in which it stands.
class SourceTreeTest : public ::testing::Test {
 protected:
  void files(const Names& names, const std::string& content = "float a = 0.775;\n") {
    for (const std::string& name : names) directory_.file(name, content);
  }
  static Names found(const Names& paths, const TreeOptions& options = {}) {
    return names_of(find_sources(paths, options));
  }

  TemporaryDirectory directory_;
  StandIn here_{directory_.path()};
};

TEST_F(SourceTreeTest, FindsSourcesByRisingNameAndCountsTheRest) {
  files({"b.glsl", "a/z.h", "a.b/c.py", "a/LICENCE", "picture.png", "A.hlsl"});
  const SourceTree tree = find_sources({"."}, {});
  EXPECT_EQ(names_of(tree), (Names{"A.hlsl", "a.b/c.py", "a/z.h", "b.glsl"}));
  EXPECT_EQ(tree.files[2].language, SourceLanguage::c_family);
  EXPECT_EQ(tree.skipped.unknown_language, 2U);
  EXPECT_TRUE(tree.skipped.messages.empty());
}

TEST_F(SourceTreeTest, ShowsNamesAsThePathsWereGiven) {
  files({"in/a.h", "other/b.h"});
  const StandIn inside("in");
  EXPECT_EQ(found({"./"}), Names{"a.h"});
  EXPECT_EQ(found({"../other//./"}), Names{"../other/b.h"});
  EXPECT_EQ(found({directory_ / "in"}), Names{"a.h"}) << "below the current folder";
  EXPECT_EQ(found({directory_ / "other"}), Names{directory_ / "other/b.h"});
  EXPECT_EQ(found({"a.h", ".", "..", "a.h"}), (Names{"../other/b.h", "a.h"})) << "each file once";
}

TEST_F(SourceTreeTest, RefusesAPathThatDoesNotExist) {
  fs::create_symlink("nowhere", "dangling");
  for (const std::string path : {"nowhere", "dangling", "", "nowhere/a.h"})
    EXPECT_EQ(refusal([&] { find_sources({path}, {}); }),
              "path '" + path + "': there is no such file or folder");
}

TEST_F(SourceTreeTest, ReadsNamedFilesWhateverTheyAre) {
  files({"third_party/.gitignore"}, "*\n");
  files({"third_party/a.h", "third_party/notes.txt", "third_party/b.py", "third_party/a.min.js",
         "third_party/run.sh"});
  const TreeOptions options{.exclude = {"*.h"}, .languages = {SourceLanguage::glsl}};
  const Names named{"third_party/a.h", "third_party/a.min.js", "third_party/b.py", "third_party/notes.txt",
                    "third_party/run.sh"};
  EXPECT_EQ(found(named, options), named);
  EXPECT_EQ(find_sources({"third_party/notes.txt"}, {}).files[0].language, SourceLanguage::c_family);
}

TEST_F(SourceTreeTest, LeavesOutTheCodeOfOthersUnlessItIsNamed) {
  files({"a.h", "external/b.h", "src/ThirdParty/lib/c.h", "node_modules/d.js", "lib.min.js", ".git/e.h",
         "src/external.h"});
  const SourceTree tree = find_sources({"."}, {});
  EXPECT_EQ(names_of(tree), (Names{"a.h", "src/external.h"}));
  EXPECT_EQ(tree.skipped.vendored, 3U);
  EXPECT_EQ(tree.skipped.minified, 1U);
  EXPECT_EQ(find_sources({".", "src"}, {}).skipped.vendored, 3U) << "each once";
  EXPECT_EQ(found({"src/ThirdParty"}), Names{"src/ThirdParty/lib/c.h"});
}

TEST_F(SourceTreeTest, LooksIntoFilesWhoseNamesLeaveTheLanguageOpen) {
  files({"shade.sh", "water.fs", "car.mat"}, "// a licence\nvec3 f(float x) { return vec3(x); }\n");
  files({"build.sh"}, "#!/bin/bash\n# vec3\n");
  files({"list.fs"}, "let square x = x * x\n");
  files({"paint.mat"}, "%YAML 1.1\n");
  const SourceTree tree = find_sources({"."}, {});
  EXPECT_EQ(names_of(tree), (Names{"car.mat", "shade.sh", "water.fs"}));
  EXPECT_EQ(tree.skipped.unknown_language, 3U);
}

TEST_F(SourceTreeTest, TakesOnlyTheLanguagesThatAreAskedFor) {
  files({"a.glsl", "b.h", "c.cu"});
  EXPECT_EQ(found({"."}, {.languages = {SourceLanguage::glsl, SourceLanguage::cuda}}),
            (Names{"a.glsl", "c.cu"}));
}

TEST_F(SourceTreeTest, ExcludesByGlobsFromTheCurrentFolderAndThatOfTheConfiguration) {
  files({"p/a/x.h", "p/a/y.h", "p/x.h", "p/c/x.h"});
  const StandIn inside("p/a");
  EXPECT_EQ(found({"."}, {.exclude = {"/x.h"}}), Names{"y.h"});
  EXPECT_EQ(found({".."}, {.exclude = {"/x.h"}}), (Names{"../a/x.h", "../a/y.h", "../c/x.h"}))
      << "from the path, where that is not below the current folder";
  EXPECT_EQ(found({".."}, {.configured = {"..", {"/a/x.h", "c/"}}}), (Names{"../a/y.h", "../x.h"}));
}

TEST_F(SourceTreeTest, GlobsAreThoseOfGitignore) {
  files({"a/b/x.h", "a/b/y.h", "a/x.h", "c/a/x.h", "x.h"});
  struct Case {
    Names globs, found;
  };
  const std::vector<Case> cases{
      {{"x.h"}, {"a/b/y.h"}},
      {{"/x.h", "a/x.h"}, {"a/b/x.h", "a/b/y.h", "c/a/x.h"}},
      {{"a/*.h"}, {"a/b/x.h", "a/b/y.h", "c/a/x.h", "x.h"}},
      {{"a/**"}, {"c/a/x.h", "x.h"}},
      {{"**/a/x.h"}, {"a/b/x.h", "a/b/y.h", "x.h"}},
      {{"a/**/x.h"}, {"a/b/y.h", "c/a/x.h", "x.h"}},
      {{"a/", "c/"}, {"x.h"}},
      {{"[xy].?"}, {}},
  };
  for (const Case& one : cases) EXPECT_EQ(found({"."}, {.exclude = one.globs}), one.found) << one.globs[0];
}

TEST_F(SourceTreeTest, FollowsNoLinksBelowAPath) {
  files({"real/a.h"});
  fs::create_directory_symlink("..", "real/up");
  fs::create_symlink("a.h", "real/b.h");
  fs::create_directory_symlink("real", "link");
  const SourceTree tree = find_sources({"real"}, {});
  EXPECT_EQ(names_of(tree), Names{"real/a.h"});
  EXPECT_EQ(tree.skipped.links, 2U);
  EXPECT_EQ(found({"link"}), Names{"link/a.h"}) << "a link that is named";
  EXPECT_EQ(found({"real/b.h"}), Names{"real/b.h"});
  EXPECT_EQ(found({"link", "real"}), Names{"link/a.h"}) << "the same files";
}

TEST_F(SourceTreeTest, WaitsForNoPipeAndReadsNothingThatIsTooLarge) {
  ASSERT_EQ(::mkfifo("pipe.h", 0600), 0);
  ASSERT_EQ(::mknod("socket.h", S_IFSOCK | 0600, 0), 0);
  files({"huge.h"}, "");
  fs::resize_file("huge.h", std::uintmax_t{1} << 40);  // sparse: reading it would take minutes
  const SourceTree tree = find_sources({"."}, {});
  EXPECT_TRUE(tree.files.empty());
  EXPECT_EQ(tree.skipped.unreadable, 2U);
  EXPECT_EQ(tree.skipped.too_large, 1U);
  EXPECT_EQ(tree.skipped.messages, (Names{"'huge.h' has 1099511627776 bytes, more than 4194304",
                                          "cannot read 'pipe.h': it is not a regular file",
                                          "cannot read 'socket.h': it is not a regular file"}));
  EXPECT_EQ(refusal([&] { find_sources({"huge.h"}, {}); }),
            "cannot read 'huge.h': it has 1099511627776 bytes, more than 4194304");
  for (const std::string name : {"pipe.h", "socket.h", "/dev/null"})
    EXPECT_EQ(refusal([&] { find_sources({name}, {}); }),
              "cannot read '" + name + "': it is not a regular file");
}

/// Runs work without the rights of root, which may read everything.
void as_nobody(const std::function<void()>& work) {
  const bool is_root = ::geteuid() == 0;
  constexpr uid_t nobody = 65534;
  ASSERT_TRUE(!is_root || ::seteuid(nobody) == 0);
  work();
  ASSERT_TRUE(!is_root || ::seteuid(0) == 0);
}

TEST_F(SourceTreeTest, GoesOnBehindFoldersAndFilesThatItMayNotRead) {
  files({"a/closed/b.h", "a/c.h", "z.h"});
  fs::permissions("a/closed", fs::perms::none);
  fs::permissions("a/c.h", fs::perms::none);
  as_nobody([] {
    SourceTree tree = find_sources({"."}, {});
    EXPECT_EQ(names_of(tree), (Names{"a/c.h", "z.h"}));
    EXPECT_EQ(tree.skipped.messages, Names{"cannot read 'a/closed': Permission denied"});
    EXPECT_FALSE(read_source(tree.files[0], tree.skipped));
    EXPECT_TRUE(read_source(tree.files[1], tree.skipped));
    EXPECT_EQ(tree.skipped.unreadable, 2U);
    EXPECT_EQ(tree.skipped.messages.back(), "cannot read 'a/c.h': Permission denied");
    for (const std::string path : {"a/closed", "a/closed/b.h"})
      EXPECT_EQ(refusal([&] { find_sources({path}, {}); }), "path '" + path + "': Permission denied");
    EXPECT_EQ(refusal([&] { find_sources({"a/c.h"}, {}); }), "cannot read 'a/c.h': Permission denied");
  });
  fs::permissions("a/closed", fs::perms::owner_all);
}

TEST_F(SourceTreeTest, ReadsBytesNotLetters) {
  const std::string content = "\xFF\xFE\x80 0.775\r\n";
  files({"a\xFF.h"}, content);
  SourceTree tree = find_sources({"."}, {});
  ASSERT_EQ(names_of(tree), Names{"a\xFF.h"});
  EXPECT_EQ(read_source(tree.files[0], tree.skipped), content);
}

TEST_F(SourceTreeTest, SkipsWhatIsNotWrittenByPeople) {
  const auto skipped_of = [&](const std::string& content) {
    files({"a.js"}, content);
    SourceTree tree = find_sources({"a.js"}, {});
    const bool is_read = read_source(tree.files[0], tree.skipped).has_value();
    EXPECT_EQ(is_read, tree.skipped.binary + tree.skipped.minified == 0);
    return std::pair(tree.skipped.binary, tree.skipped.minified);
  };
  const std::pair<std::size_t, std::size_t> read{0, 0}, binary{1, 0}, minified{0, 1};
  EXPECT_EQ(skipped_of(""), read);
  EXPECT_EQ(skipped_of(std::string(8191, ' ') + '\0'), binary);
  EXPECT_EQ(skipped_of(std::string(8192, '\n') + '\0'), read);
  EXPECT_EQ(skipped_of(std::string(8191, 'a')), read) << "too short to matter";
  EXPECT_EQ(skipped_of(std::string(8192, 'a')), minified);
  EXPECT_EQ(skipped_of(std::string(9984, 'a') + std::string(9, '\n')), read) << "999.3 bytes a line";
  EXPECT_EQ(skipped_of(std::string(9991, 'a') + std::string(9, '\n')), minified) << "1000 bytes a line";
}

TEST_F(SourceTreeTest, ReadsAFileThatChangedSinceItWasFound) {
  files({"grown.h", "shrunk.h", "gone.h", "exploded.h"});
  SourceTree tree = find_sources({"."}, {});
  ASSERT_EQ(names_of(tree), (Names{"exploded.h", "gone.h", "grown.h", "shrunk.h"}));
  fs::resize_file("exploded.h", std::uintmax_t{1} << 40);
  fs::remove("gone.h");
  files({"grown.h"}, std::string(100, '\n'));
  files({"shrunk.h"}, "1");
  EXPECT_FALSE(read_source(tree.files[0], tree.skipped));
  EXPECT_FALSE(read_source(tree.files[1], tree.skipped));
  EXPECT_EQ(read_source(tree.files[2], tree.skipped), std::string(100, '\n'));
  EXPECT_EQ(read_source(tree.files[3], tree.skipped), "1");
  EXPECT_EQ(tree.skipped.messages,
            (Names{"cannot read 'exploded.h': it has 1099511627776 bytes, more than 4194304",
                   "cannot read 'gone.h': there is no such file"}));
  SkippedFiles sum;
  add(sum, tree.skipped);
  add(sum, tree.skipped);
  EXPECT_EQ(sum.unreadable, 4U);
  EXPECT_EQ(sum.messages.size(), 4U);
}

TEST(SourceLanguage, FollowsTheEndingOfTheName) {
  struct Case {
    const char* name;
    std::optional<SourceLanguage> language;
  };
  const std::vector<Case> cases{{"pbr.glsl", SourceLanguage::glsl},
                                {"fog_fragment.glsl.js", SourceLanguage::javascript},
                                {"pbr.fragment.fx", SourceLanguage::glsl},
                                {"common.fx", SourceLanguage::hlsl},
                                {"BRDF.USH", SourceLanguage::hlsl},
                                {"sky.gdshader", SourceLanguage::glsl},
                                {"bxdf.h", SourceLanguage::c_family},
                                {"README.md", SourceLanguage::markdown},
                                {"a.png", std::nullopt},
                                {"glsl", std::nullopt},
                                {".glsl", std::nullopt},
                                {"", std::nullopt},
                                {"a.", std::nullopt}};
  for (const Case& one : cases) {
    const auto found = language_of(one.name);
    const auto language = found ? std::optional(found->language) : std::nullopt;
    EXPECT_EQ(language, one.language) << one.name;
  }
  for (const SourceLanguage language : source_languages) EXPECT_EQ(language_named(name(language)), language);
  EXPECT_FALSE(language_named("cobol"));
}

}  // namespace
}  // namespace shadefit::lint
