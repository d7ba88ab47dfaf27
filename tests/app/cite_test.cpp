#include <gtest/gtest.h>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"

namespace shadefit {
namespace {

TEST(Cite, HasTheVersionAndTitleOfCitationCff) {
  const std::string version = run_command_line({"--version"}).out.substr(std::string("shadefit ").size());
  const std::string citation = read_file(SHADEFIT_SOURCE_DIR "/CITATION.cff");
  const std::string title = "shadefit: refitted and checked approximation constants of real-time shading";
  EXPECT_NE(citation.find("\nversion: " + version), std::string::npos) << version;
  EXPECT_NE(citation.find("title: \"" + title + "\""), std::string::npos);
  const std::string bibtex = run_command_line({"cite"}).out;
  EXPECT_NE(bibtex.find("version = {" + version.substr(0, version.size() - 1) + "}"), std::string::npos)
      << bibtex;
  EXPECT_NE(bibtex.find(title), std::string::npos) << bibtex;
}

TEST(Cite, AnIdAddsItsSources) {
  const Outcome outcome = run_command_line({"cite", "fresnel-quadratic-a"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("\n@misc{lagarde2012sphericalgaussian,\n"), std::string::npos) << outcome.out;
}

TEST(Cite, AnUnknownIdIsRefused) {
  const Outcome outcome = run_command_line({"cite", "fresnel-quadratic-x"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(
      outcome.err,
      "shadefit: unknown claim, constant or family 'fresnel-quadratic-x': did you mean 'fresnel-quadratic-a'?\n");
}

}  // namespace
}  // namespace shadefit
