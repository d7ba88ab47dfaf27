#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "lint/tree/source_tree.hpp"
#include "tests/temporary_directory.hpp"

// Truth is git: random rules over one tree, and what `git check-ignore` says about each file.
namespace shadefit::lint {
namespace {

namespace fs = std::filesystem;
using shadefit::testing::TemporaryDirectory;
using Random = std::mt19937;  // the same numbers everywhere; distributions are not

template <class Values>
const auto& one_of(Random& random, const Values& values) {
  return values[random() % values.size()];
}

bool one_in(Random& random, unsigned count) {
  return random() % count == 0;
}

const std::vector<std::string> stems{"a",  "b",   "ab", "a b", "#a",  "!a",  "[a]",
                                     "a*", "\\a", "é",  "A",   "a.b", "a-b", "b "};

/// What rules are made of: names, wildcards, sets both good and malformed, escapes.
const std::vector<std::string> pieces{"a",
                                      "b",
                                      "ab",
                                      "é",
                                      "A",
                                      ".h",
                                      "*.h",
                                      " ",
                                      "-",
                                      "*",
                                      "*",
                                      "**",
                                      "***",
                                      "?",
                                      "/",
                                      "/",
                                      "/**/",
                                      "**/",
                                      "/**",
                                      "**\\/",
                                      "[ab]",
                                      "[!a]",
                                      "[^b]",
                                      "[a-b]",
                                      "[]a]",
                                      "[!]a]",
                                      "[a",
                                      "[a\\]b]",
                                      "[b-a]",
                                      "[a-]",
                                      "[[:alpha:]]",
                                      "[[:punct:]b]",
                                      "[[:space:]]",
                                      "[[:upper:]]",
                                      "[[:nothing:]]",
                                      "[[:]",
                                      "[[:a]",
                                      "[+--]",
                                      "\\a",
                                      "\\ ",
                                      "\\#",
                                      "\\*",
                                      "\\[a\\]",
                                      "\\\\",
                                      "!",
                                      "#",
                                      "[\\\\]"};

std::string random_rule(Random& random) {
  std::string rule = one_in(random, 4) ? "!" : "";
  if (one_in(random, 4)) rule += "/";
  for (unsigned i = 0, count = 1 + random() % 4; i < count; ++i)
    rule += one_in(random, 3) ? one_of(random, stems) : one_of(random, pieces);
  if (one_in(random, 4)) rule += "/";
  if (one_in(random, 8)) rule += one_in(random, 2) ? "  " : "\\";
  return rule + (one_in(random, 8) ? "\r\n" : "\n");
}

void write_rules(Random& random, const fs::path& file) {
  std::ofstream out(file, std::ios::binary);
  if (one_in(random, 8)) out << "\xEF\xBB\xBF";
  for (unsigned i = 0, count = random() % 4; i < count; ++i) out << random_rule(random);
  if (one_in(random, 4)) out << "a";  // no end of line
}

/// Folders and files of all stems, three levels deep, in a repository of git. Returns the files' names.
std::vector<std::string> make_tree(const TemporaryDirectory& directory) {
  Random random(1);
  std::vector<std::string> folders{""}, files;
  for (const std::string& stem : stems) {
    folders.push_back(stem + "/");
    for (int i = 0; i < 3; ++i) folders.push_back(stem + "/" + one_of(random, stems) + "/");
  }
  std::set<std::string> all;
  for (const std::string& folder : folders)
    for (int i = 0; i < 5; ++i) all.insert(folder + one_of(random, stems) + ".h");
  for (const std::string& name : all) {
    directory.file(name, "float a = 0.775;\n");
    files.push_back(name);
  }
  return files;
}

/// Runs git in a folder, without the rules of the user's own configuration.
int run_git(const fs::path& folder, const std::string& arguments) {
  const std::string command = "cd '" + folder.string() +
                              "' && GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1 git -c "
                              "core.excludesFile=/dev/null " +
                              arguments;
  return std::system(command.c_str());
}

std::set<std::string> names_between_zeros(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::set<std::string> names;
  for (std::string name; std::getline(in, name, '\0');) names.insert(name);
  return names;
}

TEST(GitIgnore, EveryRuleMeansWhatGitMakesOfIt) {
  if (std::system("git --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "without git: package git";
  const TemporaryDirectory directory;
  const TemporaryDirectory* const tree = &directory;
  const fs::path root = fs::path(*tree / "tree");
  fs::create_directories(root);
  const std::vector<std::string> files = make_tree(directory);
  for (const auto& entry : fs::directory_iterator(directory.path()))
    if (entry.path() != root) fs::rename(entry.path(), root / entry.path().filename());
  ASSERT_EQ(run_git(root, "init --quiet ."), 0);
  std::string names;
  for (const std::string& file : files) names += file + '\0';
  const std::string asked = directory.file("asked", names), answer = directory / "answer";

  Random random(2);
  std::size_t ignored_files = 0;
  for (int round = 0; round < 120; ++round) {
    for (const char* folder : {"", "a", "b", "a b", "[a]"}) write_rules(random, root / folder / ".gitignore");
    write_rules(random, root / ".git/info/exclude");
    run_git(root, "check-ignore --no-index -z --stdin <'" + asked + "' >'" + answer + "'");
    const std::set<std::string> ignored = names_between_zeros(answer);
    std::set<std::string> found;
    for (const SourceFile& file : find_sources({root.string()}, {}).files)
      found.insert(file.path.lexically_relative(root).string());
    std::string differ;
    for (const std::string& file : files)
      if (ignored.contains(file) == found.contains(file))
        differ += "\n" + file + (ignored.contains(file) ? " is ignored by git" : " is not ignored by git");
    for (const auto& [name, content] : testing::snapshot(root))
      if (!differ.empty() && (name.ends_with(".gitignore") || name.ends_with("exclude")))
        differ += "\n" + name + ":\n" + content;
    ASSERT_EQ(differ, "") << "round " << round;
    ignored_files += ignored.size();
  }
  // The rules are neither too weak nor too strong to say something.
  EXPECT_GT(ignored_files, files.size() * 12);
  EXPECT_LT(ignored_files, files.size() * 108);
}

}  // namespace
}  // namespace shadefit::lint
