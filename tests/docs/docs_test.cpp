#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

#include "tests/docs/markdown.hpp"
#include "tests/temporary_directory.hpp"

// README and the pages of docs/ stay true: their commands run and print what is shown, their links lead
// somewhere.
namespace shadefit {
namespace {

using testing::Example;
using testing::TemporaryDirectory;

const std::filesystem::path root = SHADEFIT_SOURCE_DIR;

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// README and docs/*.md, relative to the root, in their order.
std::vector<std::string> pages() {
  std::vector<std::string> pages{"README.md"};
  for (const auto& entry : std::filesystem::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") pages.push_back("docs/" + entry.path().filename().string());
  std::sort(pages.begin(), pages.end());
  return pages;
}

struct Printed {
  int exit_code;
  std::vector<std::string> lines;  ///< of standard output and standard error
};

/// A folder like the repository for a reader: with ./run, the examples and the baseline. The commands of a
/// page run in one such folder, one after the other, and cannot change the repository.
class Checkout {
 public:
  Checkout() {
    for (const char* needed : {"docs/examples", "reports/baseline"}) {
      std::filesystem::create_directories(folder_.path() / needed);
      std::filesystem::copy(root / needed, folder_.path() / needed, std::filesystem::copy_options::recursive);
    }
    std::filesystem::create_directory(folder_.path() / "bin");
    std::filesystem::create_symlink(SHADEFIT_COMMAND, folder_.path() / "bin" / "shadefit");
    folder_.file("run", "#!/bin/sh\nif [ $# -eq 0 ]; then set -- run; fi\nexec shadefit \"$@\"\n");
    std::filesystem::permissions(folder_.path() / "run", std::filesystem::perms::owner_all);
  }

  Printed run(const std::string& command) const {
    const std::string folder = folder_.path().string();
    const std::string line =
        "exec 2>&1 </dev/null; cd '" + folder + "' && PATH='" + folder + "/bin':$PATH\n" + command + "\n";
    std::FILE* pipe = ::popen(line.c_str(), "r");
    if (pipe == nullptr) return {-1, {"no process"}};
    std::string text;
    std::array<char, 4096> buffer;
    for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
      text.append(buffer.data(), n);
    return {WEXITSTATUS(::pclose(pipe)), testing::lines_of(text)};
  }

 private:
  TemporaryDirectory folder_;
};

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "    " + line + "\n";
  return text;
}

/// What is wrong with an example: file, line, expected, printed. Empty: nothing.
std::string complaint(const std::string& page, const Example& example, const Printed& printed) {
  const std::string place = page + ":" + std::to_string(example.line) + ": " + example.command + "\n";
  if (printed.exit_code != example.exit_code)
    return place + "  expected exit code " + std::to_string(example.exit_code) + ", got " +
           std::to_string(printed.exit_code) + "\n  printed:\n" + joined(printed.lines);
  if (example.shown && !testing::stands_for(*example.shown, printed.lines))
    return place + "  expected:\n" + joined(*example.shown) + "  printed:\n" + joined(printed.lines);
  return "";
}

TEST(Docs, EveryCommandDoesWhatItsPageShows) {
  std::size_t run = 0;
  std::vector<std::string> not_run;
  for (const std::string& page : pages()) {
    const Checkout checkout;
    for (const Example& example : testing::read_examples(testing::lines_of(read(root / page)))) {
      if (example.not_run.empty()) {
        const std::string wrong = complaint(page, example, checkout.run(example.command));
        EXPECT_TRUE(wrong.empty()) << wrong;
        ++run;
      } else {
        not_run.push_back(page + ":" + std::to_string(example.line) + ": " + example.command + " (" +
                          example.not_run + ")");
      }
    }
  }
  // The number of commands that are not run. A new one must be counted here on purpose.
  EXPECT_EQ(not_run.size(), 6U) << joined(not_run);
  EXPECT_GE(run, 40U);
}

TEST(Docs, EveryCommandInTheTextSucceeds) {
  const Checkout checkout;
  std::map<std::string, Printed> done;  // several pages name the same command
  for (const std::string& page : pages()) {
    for (const Example& example : testing::read_inline_examples(testing::lines_of(read(root / page)))) {
      auto found = done.find(example.command);
      if (found == done.end()) found = done.emplace(example.command, checkout.run(example.command)).first;
      const std::string wrong = complaint(page, example, found->second);
      EXPECT_TRUE(wrong.empty()) << wrong;
    }
  }
  EXPECT_GE(done.size(), 10U);
}

TEST(Docs, EveryLinkLeadsSomewhere) {
  std::size_t links = 0;
  std::vector<std::string> with_links = pages();
  with_links.push_back("bench/README.md");
  for (const std::string& page : with_links) {
    for (const auto& [line, target, is_source] : testing::read_links(testing::lines_of(read(root / page)))) {
      const std::string place = page + ":" + std::to_string(line) + ": " + target;
      const auto mark = std::min(target.find('#'), target.size());
      const auto folder = is_source ? root : (root / page).parent_path();
      const auto path = mark == 0 ? root / page : folder / target.substr(0, mark);
      EXPECT_TRUE(std::filesystem::exists(path)) << place << ": there is no such file";
      if (mark < target.size()) {
        EXPECT_TRUE(testing::read_anchors(testing::lines_of(read(path))).contains(target.substr(mark + 1)))
            << place << ": there is no such heading";
      }
      ++links;
    }
  }
  EXPECT_GE(links, 50U);
}

/// How many lines of the TOML files of a folder are this one.
long lines_in(const std::string& folder, const std::string& line) {
  long count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
    if (entry.path().extension() != ".toml") continue;
    const auto lines = testing::lines_of(read(entry.path()));
    count += line.empty() ? 1 : std::ranges::count(lines, line);
  }
  return count;
}

TEST(Docs, CountsAreThoseOfTheFiles) {
  const std::map<std::string, long> counts{{"claims", lines_in("studies/claims", "[[claim]]")},
                                           {"published sets", lines_in("studies", "[[published]]")},
                                           {"studies", lines_in("studies", "")}};
  const std::regex stated(R"(\b(\d+)\s+(claims|published\s+sets|studies)\b)");
  long found = 0;
  for (const char* page : {"README.md", "CHANGELOG.md", "docs/gallery.md", "docs/verdicts.md"}) {
    const std::string text = read(root / page);
    for (std::sregex_iterator match(text.begin(), text.end(), stated), end; match != end; ++match, ++found)
      EXPECT_EQ(std::stol((*match)[1]),
                counts.at(std::regex_replace((*match)[2].str(), std::regex(R"(\s+)"), " ")))
          << page << ": " << match->str();
  }
  EXPECT_GE(found, 4);
}

TEST(Docs, TheReadmeIsShortAndLinksEveryPage) {
  const std::string readme = read(root / "README.md");
  std::istringstream words(readme);
  EXPECT_LE(std::distance(std::istream_iterator<std::string>(words), {}), 1200);
  for (const std::string& page : pages())
    EXPECT_TRUE(page == "README.md" || readme.find("](" + page + ")") != std::string::npos) << page;
}

// The checks above can fail: each kind of broken example is reported with its place and both texts.
TEST(DocsExamples, ABrokenOneIsToldWithItsPlace) {
  const auto examples = testing::read_examples(testing::lines_of(
      "Text\n\n```console\n$ shadefit fit x   # exit 2\nunknown 'x'\n```\n\n    ./run list\n\n    shadefit check\n"));
  ASSERT_EQ(examples.size(), 3U);
  EXPECT_EQ(examples[0].line, 4U);
  EXPECT_EQ(complaint("p.md", examples[0], {2, {"unknown 'x'"}}), "");
  EXPECT_EQ(complaint("p.md", examples[0], {2, {"unknown 'y'"}}),
            "p.md:4: shadefit fit x   # exit 2\n  expected:\n    unknown 'x'\n  printed:\n    unknown 'y'\n");
  EXPECT_EQ(
      complaint("p.md", examples[0], {1, {"unknown 'x'"}}),
      "p.md:4: shadefit fit x   # exit 2\n  expected exit code 2, got 1\n  printed:\n    unknown 'x'\n");
  EXPECT_EQ(examples[2].line, 10U);
  EXPECT_EQ(complaint("p.md", examples[1], {0, {"anything: the page shows no output"}}), "");
  EXPECT_NE(complaint("p.md", examples[1], {1, {}}), "");
}

TEST(DocsExamples, ThoseInTheTextAreCommandsWithArguments) {
  const auto examples = testing::read_inline_examples(testing::lines_of(
      "`./run` and `./run list`, not `./running`\n\n```sh\n./run `./run x`\n```\n| a | `./run check` |\n"));
  ASSERT_EQ(examples.size(), 2U);
  EXPECT_EQ(examples[0].command, "./run list");
  EXPECT_EQ(examples[1].command, "./run check");
  EXPECT_EQ(examples[1].line, 6U);
  EXPECT_NE(complaint("p.md", examples[1], {1, {}}), "");
}

TEST(DocsExamples, OneThatIsNotRunSaysWhy) {
  const auto examples = testing::read_examples(testing::lines_of(
      "<!-- not run: takes a minute -->\n\n```sh\n./run bench\n```\n```sh\n./run list\n```\n"));
  ASSERT_EQ(examples.size(), 2U);
  EXPECT_EQ(examples[0].not_run, "takes a minute");
  EXPECT_EQ(examples[1].not_run, "");
}

TEST(DocsExamples, ADollarEndsTheOutputOfTheOneBefore) {
  const auto examples = testing::read_examples(
      testing::lines_of("```\n$ shadefit a\n./run is what it prints\n$ ls\nfile\n$ ./run\n```\n"));
  ASSERT_EQ(examples.size(), 2U);
  EXPECT_EQ(*examples[0].shown, (std::vector<std::string>{"./run is what it prints"}));
  EXPECT_EQ(examples[1].command, "./run");
  EXPECT_TRUE(examples[1].shown->empty());
  EXPECT_NE(complaint("p.md", examples[1], {0, {"more"}}), "");
}

TEST(DocsExamples, ThreeDotsStandForLinesAndForTheEndOfALine) {
  using Lines = std::vector<std::string>;
  const Lines printed{"a b", "", "c  ", "d"};
  EXPECT_TRUE(testing::stands_for({"a b", "", "c", "d"}, printed));
  EXPECT_TRUE(testing::stands_for({"a ...", "...", "d"}, printed));
  EXPECT_TRUE(testing::stands_for({"...", "c", "..."}, printed));
  EXPECT_TRUE(testing::stands_for({"...", "a b", "...", "c", "d", "..."}, printed)) << "none are lines too";
  EXPECT_FALSE(testing::stands_for({"a b", "", "c"}, printed));
  EXPECT_FALSE(testing::stands_for({"...", "c"}, printed));
  EXPECT_FALSE(testing::stands_for({"b ...", "..."}, printed));
  EXPECT_FALSE(testing::stands_for({" a b", "..."}, printed)) << "spaces at the start count";
  EXPECT_FALSE(testing::stands_for({"a b", "", "c", "d", "e"}, printed));
}

TEST(DocsLinks, AreReadOutsideCode) {
  const auto links = testing::read_links(testing::lines_of(
      "[a](b.md#c) `[no](link)` ![d](e.svg), [web](https://example.org)\n```\n[f](g)\n```\n`fit/x.hpp` `x.hpp` `fit/*.hpp`"));
  ASSERT_EQ(links.size(), 3U);
  EXPECT_EQ(links[0].target, "b.md#c");
  EXPECT_EQ(links[1].target, "e.svg");
  EXPECT_EQ(links[2].target, "fit/x.hpp");
  EXPECT_TRUE(links[2].is_source);
  EXPECT_EQ(links[2].line, 5U);
  EXPECT_EQ(testing::read_anchors({"# Two words, `code`!", "#no", "```", "# not this", "```"}),
            (std::set<std::string>{"two-words-code"}));
}

}  // namespace
}  // namespace shadefit
