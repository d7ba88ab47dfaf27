#include <fmt/format.h>
#include <gtest/gtest.h>

#include <toml++/toml.h>
#include <algorithm>
#include <iostream>
#include <string>

#include "lint/lint_tree.hpp"
#include "tests/lint/all_known.hpp"

/// The places of tests/lint/corpus.toml.
namespace shadefit::lint {
namespace {

constexpr const char* elsewhere = "elsewhere";

/// The most harmful grade that lint gives a text.
std::string worst_grade(const std::string& text, SourceLanguage language) {
  std::optional<Grade> worst;
  for (const LintedSite& site : lint_text(text, language))
    worst = std::max(worst.value_or(Grade::right), site.grade);
  return worst ? std::string(name(*worst)) : elsewhere;
}

TEST(LintCorpus, EachPlaceHasTheGradeThatIsNoted) {
  const toml::table corpus = toml::parse_file(SHADEFIT_SOURCE_DIR "/tests/lint/corpus.toml");
  std::size_t sites = 0, found = 0, graded = 0, traps = 0, false_alarms = 0;
  for (const toml::node& node : *corpus["site"].as_array()) {
    const toml::table& site = *node.as_table();
    const auto text_of = [&](const char* key) { return site[key].value_or(std::string()); };
    const std::string grade = text_of("grade"), text = text_of("text") + "\n";
    const std::string answer = worst_grade(text, language_named(text_of("language")).value());
    EXPECT_EQ(answer, site.contains("today") ? text_of("today") : grade)
        << text_of("repository") << " " << text_of("path") << ":\n"
        << text << text_of("note");
    if (grade == elsewhere) {
      ++traps;
      if (answer != elsewhere) ++false_alarms;
    } else {
      ++sites;
      if (answer != elsewhere) ++found;
      if (answer == grade) ++graded;
    }
  }
  std::cout << fmt::format("{} places: {} found, {} with their grade; {} traps: {} reported\n", sites, found,
                           graded, traps, false_alarms);
  const auto percent = [](std::size_t part, std::size_t all) {
    return 100 * static_cast<double>(part) / static_cast<double>(all);
  };
  std::cout << fmt::format("precision {:.1f} %, recall {:.1f} %\n", percent(found, found + false_alarms),
                           percent(found, sites));
  // What the project wants of its corpus.
  EXPECT_GE(sites, 60u);
  EXPECT_GE(traps, 40u);
}

}  // namespace
}  // namespace shadefit::lint
