#include <gtest/gtest.h>

#include <set>

#include "app/commands/command_line.hpp"
#include "app/studies/find_study.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"

namespace shadefit {
namespace {

using testing::expect_has;

TEST(Cite, HasTheVersionAndTitleOfCitationCff) {
  const std::string said = run_command_line({"--version"}).out, version = said.substr(9, said.find('\n') - 8);
  const std::string citation = read_file(SHADEFIT_SOURCE_DIR "/CITATION.cff");
  const std::string title = "shadefit: refitted and checked approximation constants of real-time shading";
  expect_has(citation, "\nversion: " + version);
  expect_has(citation, "title: \"" + title + "\"");
  const std::string bibtex = run_command_line({"cite"}).out;
  expect_has(bibtex, "version = {" + version.substr(0, version.size() - 1) + "}");
  expect_has(bibtex, title);
}

TEST(Cite, AStudyAddsTheSourcesOfItsPublishedSets) {
  const Outcome outcome = run_command_line({"cite", "agx-septic"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(
      outcome.out.ends_with("\n@misc{wrensch2023minimalagx,\n  author = {Wrensch},\n"
                            "  title = {{Minimal AgX implementation}},\n"
                            "  year = {2023},\n  url = {https://iolite-engine.com},\n}\n"))
      << outcome.out;
}

TEST(Cite, EachStudyHasSourcesWithKeysOfTheirOwn) {
  for (const auto& path : study_files(study_folders({}))) {
    const Outcome outcome = run_command_line({"cite", path.stem().string()});
    EXPECT_EQ(outcome.exit_code, 0) << path << outcome.err;
    std::set<std::string> keys;
    std::size_t at = outcome.out.find("\n@misc");
    EXPECT_EQ(at == std::string::npos, load_study(path).published.empty()) << path;
    for (; at != std::string::npos; at = outcome.out.find("\n@misc", at + 1)) {
      const std::string key = outcome.out.substr(at, outcome.out.find(',', at) - at);
      EXPECT_TRUE(keys.insert(key).second) << path << key;
    }
  }
}

TEST(Cite, AnUnknownIdIsRefused) {
  testing::expect_refusal(
      {"cite", "fresnel-quadratic-x"},
      "unknown claim, constant, family or study 'fresnel-quadratic-x': did you mean 'fresnel-quadratic-a'?");
}

// A field is not guessed: what a study does not say is not there.
TEST(Cite, EveryStudyOfTheProjectHasFields) {
  const std::set<std::string> without{"the usual gamma of a display", "the usual gamma of a display, 1/2.2",
                                      "1/2.4 as a decimal"};
  std::size_t addresses = 0;
  for (const auto& path : known_study_files(study_folders({}))) {
    for (const PublishedSet& set : load_study(path).published) {
      EXPECT_EQ(set.cite.has_value(), !without.contains(set.source.unescaped()))
          << path << set.source.unescaped();
      addresses += set.cite && !set.cite->url.empty() ? 1 : 0;
    }
  }
  EXPECT_GE(addresses, 70U);
}

TEST(Cite, KnowsTheIdsOfLint) {
  expect_has(run_command_line({"cite", "fresnel-quadratic-a"}).out,
             "\n@misc{lagarde2012sphericalgaussian,\n");
  for (const char* id : {"luma-709", "srgb-decode-standard", "fresnel-quadratic"})
    expect_has(run_command_line({"cite", id}).out, "\n@misc{");
}

}  // namespace
}  // namespace shadefit
