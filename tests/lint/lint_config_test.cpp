#include "lint/tree/lint_config.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/lint/current_folder.hpp"
#include "tests/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit::lint {
namespace {

using shadefit::testing::refusal;
using shadefit::testing::StandIn;
using shadefit::testing::TemporaryDirectory;

const std::vector<std::string> verdicts{"wrong", "mistyped"};

TEST(LintConfig, HasAllKeysOfItsTable) {
  const LintConfig config = read_lint_config(R"([lint]
exclude = ["/generated/", "*.min.js"]
languages = ["glsl", "c"]
fail-on = "mistyped"
max-effect = 1e-4
baseline = "known.json"
paths = ["shaders", "src"]
)",
                                             "../.shadefit.toml", verdicts);
  EXPECT_EQ(config.exclude, (std::vector<std::string>{"/generated/", "*.min.js"}));
  EXPECT_EQ(config.languages, (std::vector{SourceLanguage::glsl, SourceLanguage::c_family}));
  EXPECT_EQ(config.fail_on, "mistyped");
  EXPECT_EQ(config.max_effect, 1e-4);
  EXPECT_EQ(config.baseline, "../known.json");
  EXPECT_EQ(config.paths, (std::vector<std::string>{"../shaders", "../src"}));
}

TEST(LintConfig, SetsNothingThatTheFileDoesNotSet) {
  for (const char* text : {"", "[lint]\n"}) {
    const LintConfig config = read_lint_config(text, "a.toml", verdicts);
    EXPECT_TRUE(config.exclude.empty() && config.languages.empty() && config.paths.empty());
    EXPECT_FALSE(config.fail_on || config.max_effect || config.baseline);
  }
  EXPECT_EQ(read_lint_config("[lint]\nmax-effect = 0\n", "a.toml", verdicts).max_effect, 0);
}

TEST(LintConfig, RefusesWithTheLineAndTheNearestWord) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"[lnt]", "line 1: unknown key 'lnt': did you mean 'lint'?"},
      {"lint = 3", "line 1: 'lint' must be a table"},
      {"[lint]\n\nexlude = []", "line 3: unknown key 'exlude': did you mean 'exclude'?"},
      {"[lint]\nfail_on = 'wrong'", "line 2: unknown key 'fail_on': did you mean 'fail-on'?"},
      {"[lint]\nexclude = 'a'", "line 2: 'exclude' must be a list"},
      {"[lint]\nexclude = [\n  'a',\n  7 ]", "line 4: 'exclude' must be a text in quotes"},
      {"[lint]\npaths = ['']", "line 2: 'paths' is empty or has a byte 0"},
      {"[lint]\npaths = [\"a\\u0000b\"]", "line 2: 'paths' is empty or has a byte 0"},
      {"[lint]\nlanguages = ['gsl']", "line 2: languages 'gsl' is unknown: did you mean 'glsl'?"},
      {"[lint]\nfail-on = 'rong'", "line 2: fail-on 'rong' is unknown: did you mean 'wrong'?"},
      {"[lint]\nfail-on = 'x'", "line 2: fail-on 'x' is unknown: it must be one of wrong, mistyped"},
      {"[lint]\nfail-on = true", "line 2: 'fail-on' must be a text in quotes"},
      {"[lint]\nmax-effect = '1e-4'", "line 2: 'max-effect' must be a number"},
      {"[lint]\nmax-effect = -1", "line 2: max-effect -1 must be at least 0 and finite"},
      {"[lint]\nmax-effect = inf", "line 2: max-effect inf must be at least 0 and finite"},
      {"[lint]\nmax-effect = nan", "line 2: max-effect nan must be at least 0 and finite"},
      {"[lint]\nbaseline = 1979-05-27", "line 2: 'baseline' must be a text in quotes"},
  };
  for (const auto& [text, rule] : cases)
    EXPECT_EQ(refusal([&, &text = text] { read_lint_config(text, "a.toml", verdicts); }),
              "'a.toml', " + rule);
  EXPECT_EQ(refusal([] { read_lint_config("[lint]\nx = = 2", "a.toml", verdicts); }).substr(0, 17),
            "'a.toml', line 2:");
}

TEST(LintConfig, IsThatOfTheNearestFolderUpToTheRepository) {
  const TemporaryDirectory directory;
  directory.file(".shadefit.toml", "[lint]\npaths = ['outside']\n");
  directory.file("project/.git/HEAD", "");
  directory.file("project/.shadefit.toml", "[lint]\npaths = ['own']\n");
  directory.file("project/a/b/c.glsl", "");
  directory.file("project/near/.shadefit.toml", "[lint]\n");
  directory.file("bare/.git/HEAD", "");
  directory.file("alone/c.glsl", "");
  const auto found_in = [&](const std::string& folder) {
    const StandIn here(directory / folder);
    const auto config = find_lint_config(verdicts);
    return !config ? "none" : config->file.string() + " " + (config->paths.empty() ? "" : config->paths[0]);
  };
  EXPECT_EQ(found_in("project"), ".shadefit.toml own");
  EXPECT_EQ(found_in("project/a/b"), "../../.shadefit.toml ../../own");
  EXPECT_EQ(found_in("project/near"), ".shadefit.toml ");
  EXPECT_EQ(found_in("bare"), "none");
  EXPECT_EQ(found_in("alone"), "none") << "a file above, outside of any repository, is not this project's";
}

TEST(LintConfig, ThatCannotBeReadIsRefused) {
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory / ".shadefit.toml");
  const StandIn here(directory.path());
  EXPECT_EQ(refusal([] { find_lint_config(verdicts); }), "cannot read '.shadefit.toml': it is a directory");
}

}  // namespace
}  // namespace shadefit::lint
