#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/commands/command_line.hpp"
#include "app/studies/find_study.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/study/study.hpp"
#include "reports/code/shader_code.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_lacks;

std::vector<std::string> committed_studies() {
  std::vector<std::string> ids;
  for (const auto& path : study_files({std::filesystem::path(SHADEFIT_SOURCE_DIR) / "studies"}))
    ids.push_back(path.stem().string());
  return ids;
}

/// Studies with a fit that does not converge: minimax of a form that is exact, or that has no single optimum,
/// or that the exchange does not find.
bool has_fits_that_fail(const std::string& id) {
  return std::set<std::string>{"air-mass",         "burley-albedo",        "fresnel-average",
                               "imageworks-sheen", "oren-nayar-albedo",    "pq-gran-turismo",
                               "pq-patry",         "schlick-average",      "smith-linear",
                               "srgb-encode",      "van-de-hulst-inverse", "zeltner-albedo"}
      .contains(id);
}

/// Each study of the project is read, judged and emitted, and its id is its name.
class CommittedStudy : public ::testing::TestWithParam<std::string> {};

TEST_P(CommittedStudy, Holds) {
  const StudyFile file =
      load_study(std::filesystem::path(SHADEFIT_SOURCE_DIR) / "studies" / (GetParam() + ".toml"));
  EXPECT_EQ(file.id, GetParam());
  EXPECT_FALSE(file.title.empty());
  const Outcome outcome = run_command_line({"better", file.id, "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  for (const auto& target : json.is_array() ? json : nlohmann::json::array({json})) {
    int fitted = 0;
    for (const auto& contender : target["contenders"]) {
      const bool is_published = contender["kind"] == "published";
      EXPECT_EQ(is_published, contender["verdict"].is_string());
      fitted += is_published ? 0 : 1;
    }
    EXPECT_GT(fitted, 0);
    EXPECT_TRUE(target["left_out"].empty() || has_fits_that_fail(file.id)) << target["left_out"];
  }
  std::vector<std::string> emit{"emit", file.id, "--lang", ""};
  for (const auto& [constant, values] : file.given)
    emit.insert(emit.end(), {"--given", constant + "=" + values.front()});
  for (const Language language : languages) {
    emit[3] = name(language);
    EXPECT_EQ(run_command_line(emit).exit_code, 0) << emit[3];
    // Each language proves the error anew, and these proofs take seconds.
    if (file.id == "ltc-edge" || file.id == "fresnel-average") break;
  }
}

INSTANTIATE_TEST_SUITE_P(Studies, CommittedStudy, ::testing::ValuesIn(committed_studies()),
                         [](const auto& study) {
                           std::string name = study.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// What --fix holds is not judged; the other constants are.
TEST(StudyFile, JudgesTheConstantsThatAreFree) {
  const Outcome outcome = run_command_line({"fit", "atan-quintic", "--fix", "b=0.0872929"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_has(outcome.out, "a = -0.301895 ");
  expect_lacks(outcome.out, "b = 0.0872929");
}

// The reference follows the program of the ACES in 40 digits; the study has 17 digits of the end of a spline.
TEST(StudyFile, TheAcesCurveIsThatOfItsReference) {
  const std::filesystem::path source = SHADEFIT_SOURCE_DIR;
  Study study = load_study(source / "studies/aces-narkowicz.toml").study;
  study.form = "a x";
  const Symbolic target = read_formulas(study).target;
  const auto rows = parse_csv(read_file(source / "tests/references/tone.csv"), "tone.csv").rows;
  ASSERT_EQ(rows.size(), 20u);
  for (const auto& row : rows) {
    const Decimal50 x(row[0]), expected(row[1]);
    const auto computed = evaluate<Decimal50>(target, [&](const std::string&) { return x; });
    EXPECT_LT(abs(computed / expected - 1), Decimal50(1e-14)) << "x = " << row[0] << ": " << computed;
  }
}

}  // namespace
}  // namespace shadefit
