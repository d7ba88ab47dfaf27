#include "fit/verdicts/study_verdict.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

const Study surface{
    .target = "exp(-x y^2)", .form = "1/(1 + a x y)", .over = {{"x", "0", "1"}, {"y", "0", "1"}}};
const Study arc_cosine{.target = "acos(x)", .form = "sqrt(1-x) (a + b x)", .over = {{"x", "0", "1"}}};

/// The constants of a fit with so many decimals, as a source would print them.
PublishedSet printed(const StudyObjective& objective, int decimals) {
  const StudyFit fit = fit_study(objective);
  if (fit.status != Status::converged) throw UserError(fit.why);
  PublishedSet set{.form = "form", .values = {}, .source = OthersText("a test")};
  for (std::size_t i = 0; i < fit.names.size(); ++i)
    set.values.emplace_back(fit.names[i], fmt::format("{:.{}f}", fit.parameters[i], decimals));
  return set;
}

StudyJudgement judged(const PublishedSet& set) {
  return judge_set(objective_of(arc_cosine, Norm::least_squares, {}), set);
}

/// "other-objective: minimax"
std::string verdict_and_objective(const StudyJudgement& judgement) {
  return std::string(name(judgement.verdict)) + ": " + judgement.objective;
}

TEST(StudyVerdict, FindsEveryObjectiveAgain) {
  int found = 0;
  for (const StudyObjective& objective :
       other_objectives(objective_of(arc_cosine, Norm::least_squares, {}))) {
    PublishedSet set;
    try {
      set = printed(objective, 9);
    } catch (const UserError&) {
      continue;  // an integral that diverges, a relative error where the target is 0
    }
    const StudyJudgement judgement = judged(set);
    EXPECT_EQ(name(judgement.verdict), "other-objective") << objective.words;
    ++found;
    EXPECT_EQ(judgement.units_off, 0) << objective.words << " and " << judgement.objective;
    EXPECT_GT(judgement.tried, 10);
    EXPECT_LT(judgement.chance, most_chance_hits);
  }
  EXPECT_GT(found, 25);
}

TEST(StudyVerdict, CallsFewDigitsUndecidable) {
  const PublishedSet many = printed(objective_of(arc_cosine, Norm::minimax, {}), 6);
  EXPECT_EQ(name(judged(many).verdict), "other-objective");
  const PublishedSet few = printed(objective_of(arc_cosine, Norm::minimax, {}), 3);
  const StudyJudgement judgement = judged(few);
  EXPECT_EQ(name(judgement.verdict), "undecidable") << judgement.objective;
  EXPECT_GE(judgement.chance, most_chance_hits);
  EXPECT_EQ(judgement.units_off, 0);
}

// Of two variables each density of each is tried, one as a cosine and one as a roughness, and grids.
TEST(StudyVerdict, FindsObjectivesOfTwoVariables) {
  const StudyObjective asked = objective_of(surface, Norm::least_squares, {});
  const std::vector<StudyObjective> others = other_objectives(asked);
  // Two norms with two errors but the asked one; 10 pairs of densities; 6 grids with two errors; 6 parts.
  EXPECT_EQ(others.size(), 3U + 10 + 2 * 6 + 6);
  std::set<std::string> words;
  for (std::size_t i = 0; i < others.size(); ++i) {
    words.insert(others[i].words);
    if (i % 3 != 0) continue;
    const StudyJudgement judgement = judge_set(asked, printed(others[i], 9));
    EXPECT_EQ(verdict_and_objective(judgement), "other-objective: " + others[i].words);
    EXPECT_EQ(judgement.tried, 1 + others.size());
    EXPECT_LT(judgement.chance, most_chance_hits);
  }
  EXPECT_EQ(words.size(), others.size());
  EXPECT_EQ(words.count("least squares, measure angle of x, even in the square of y"), 1U);
  EXPECT_EQ(words.count("least squares, relative error, 32 x 32 midpoints"), 1U);
}

// A variable that leaves [0, 1] is no cosine and no roughness.
TEST(StudyVerdict, TriesNoDensityOfOtherVariables) {
  Study longer = surface;
  longer.over[1].upper = "2";
  const auto others = other_objectives(objective_of(longer, Norm::least_squares, {}));
  EXPECT_EQ(others.size(), 3U + 3 + 2 * 6 + 6);
}

// A table whose formula is known may have been fitted with other rows.
TEST(StudyVerdict, FindsTheGridOfATable) {
  MeasuredRows rows;
  rows.places.resize(2);
  for (const double x : {0.01, 0.3, 0.6, 1.0}) {
    for (const double y : {0.05, 0.5, 0.8}) {
      rows.places[0].push_back(x);
      rows.places[1].push_back(y);
      rows.value.push_back(std::exp(-x * y * y));
    }
  }
  Study table = surface;
  table.target.clear();
  table.over = {{"x", "", ""}, {"y", "", ""}};
  table.rows = std::make_shared<const MeasuredRows>(rows);
  StudyObjective asked = objective_of(table, Norm::least_squares, {});
  EXPECT_EQ(other_objectives(asked).size(), 3U);
  asked.recompute = "exp(-x y^2)";
  const std::vector<StudyObjective> others = other_objectives(asked);
  ASSERT_EQ(others.size(), 3U + 2 * 6);
  const auto& midpoints = others[others.size() - 4];
  EXPECT_EQ(midpoints.words, "least squares, 32 x 32 midpoints");
  // The rows come near to 0 and 1 in x alone: there texels have all of [0, 1].
  EXPECT_EQ(midpoints.study.rows->places[0].front(), 1.0 / 64);
  EXPECT_EQ(midpoints.study.rows->places[1].front(), 0.05 + 0.75 / 64);
  EXPECT_EQ(others[3].words, "least squares, 16 x 16 even samples");
  EXPECT_EQ(others[3].study.rows->places[0].front(), 0.01);
  EXPECT_EQ(others[3].study.rows->places[1].back(), 0.8);
  EXPECT_EQ(verdict_and_objective(judge_set(asked, printed(midpoints, 9))),
            "other-objective: least squares, 32 x 32 midpoints");
}

// Few fits decide too, if the digits are many: of rows there are two, of three variables four.
TEST(StudyVerdict, DecidesAmongFewFits) {
  Study solid = surface;
  solid.over.push_back({"z", "0", "1"});
  solid.form = "1/(1 + a x y) + 0 z";
  const StudyObjective asked = objective_of(solid, Norm::least_squares, {});
  const StudyJudgement many = judge_set(asked, printed(objective_of(solid, Norm::minimax, {}), 9));
  EXPECT_EQ(many.tried, 4U);
  EXPECT_EQ(verdict_and_objective(many), "other-objective: minimax");
  const StudyJudgement few = judge_set(asked, printed(objective_of(solid, Norm::minimax, {}), 1));
  EXPECT_NE(name(few.verdict), "other-objective");
}

// A constant that was rounded and held: the other one is the best beside it.
TEST(StudyVerdict, FindsAHeldConstant) {
  StudyObjective held = holding(objective_of(arc_cosine, Norm::minimax, {}), "a", 1.57);
  PublishedSet set = printed(held, 9);
  set.values.emplace_back("a", "1.57");
  EXPECT_EQ(verdict_and_objective(judged(set)), "other-objective: minimax with a = 1.57");
}

TEST(StudyVerdict, FindsTheFitWithoutTheWeight) {
  Study weighted = arc_cosine;
  weighted.weight = "1 + 4 x";
  const StudyJudgement judgement = judge_set(objective_of(weighted, Norm::least_squares, {}),
                                             printed(objective_of(arc_cosine, Norm::least_squares, {}), 9));
  EXPECT_EQ(verdict_and_objective(judgement), "other-objective: least squares, without the weight");
}

// The mantissa of a logarithm, that has to join at 1: s - a = 1.
TEST(StudyVerdict, FindsLeastSquaresThatAreExactAtAnEnd) {
  const Study mantissa{.target = "log2(1 + x)", .form = "x (s - a x)", .over = {{"x", "0", "1"}}};
  const StudyObjective asked = objective_of(mantissa, Norm::least_squares, {});
  const StudyObjective exact = objective_of(mantissa, Norm::least_squares, {.exact_at = {1}});
  EXPECT_EQ(verdict_and_objective(judge_set(asked, printed(exact, 7))),
            "other-objective: least squares, exact at x = 1");
  const auto count = [&](const std::vector<std::string>& values) {
    return exact_least_squares(asked, values).size();
  };
  EXPECT_EQ(count({"1.3465552", "0.3465552"}), 2U) << "two errors";
  EXPECT_EQ(count({"1.3465552", "0.3465562"}), 0U) << "not exact at 1; at 0 it is for all constants";
}

// A fit has 14 digits: those behind are neither right nor wrong, and no evidence.
TEST(StudyVerdict, ClaimsNoDigitsThatNoFitHas) {
  const StudyObjective asked = objective_of(arc_cosine, Norm::least_squares, {});
  const StudyJudgement few = judged(printed(asked, 12));
  EXPECT_EQ(few.compared_digits, std::nullopt);
  PublishedSet set = printed(asked, 15);
  for (auto& value : set.values) value.second += "123456";
  const StudyJudgement many = judged(set);
  EXPECT_EQ(name(many.verdict), "confirmed");
  EXPECT_EQ(many.compared_digits, 14);
  EXPECT_GT(many.chance, 1e-6 * few.chance) << "nine more digits of two constants would have 1e-18 of it";
}

TEST(StudyVerdict, NamesTheNearestFitOfRefutedDigits) {
  PublishedSet set = printed(objective_of(arc_cosine, Norm::minimax, {}), 9);
  set.values[1].second = "-0.168258005";  // six units in the eighth decimal
  const StudyJudgement judgement = judged(set);
  EXPECT_EQ(name(judgement.verdict), "refuted");
  EXPECT_EQ(judgement.objective.find("minimax"), 0U) << judgement.objective;
  EXPECT_GT(judgement.units_off, 1);
  EXPECT_LE(judgement.units_off, 60);
}

/// Each digit of each printed constant, changed by one, is noticed.
TEST(StudyVerdict, NoticesEachChangedDigit) {
  const PublishedSet set = printed(objective_of(arc_cosine, Norm::least_squares, {}), 7);
  ASSERT_EQ(name(judged(set).verdict), "confirmed");
  for (std::size_t i = 0; i < set.values.size(); ++i) {
    const std::string& text = set.values[i].second;
    for (std::size_t k = 0; k < text.size(); ++k) {
      if (text[k] < '0' || text[k] > '9') continue;
      PublishedSet changed = set;
      changed.values[i].second[k] = text[k] == '9' ? '8' : static_cast<char>(text[k] + 1);
      EXPECT_NE(name(judged(changed).verdict), "confirmed") << changed.values[i].second;
    }
  }
}

TEST(StudyVerdict, FewDigitsDecideNothingUnderTheAskedObjective) {
  const PublishedSet many = printed(objective_of(arc_cosine, Norm::least_squares, {}), 6);
  const StudyJudgement right = judged(many);
  EXPECT_EQ(name(right.verdict), "confirmed");
  EXPECT_EQ(right.tried, 4U) << "both norms, both errors";
  EXPECT_GT(right.chance, 0);
  // With one decimal minimax has the same digits: 1.6 and -0.2.
  const StudyJudgement few = judged(printed(objective_of(arc_cosine, Norm::least_squares, {}), 1));
  EXPECT_EQ(verdict_and_objective(few), "undecidable: least squares");
  EXPECT_EQ(few.units_off, 0);
  EXPECT_EQ(few.also.front(), "minimax");
}

// Each objective gives the constants of a target that has the form: no chance.
TEST(StudyVerdict, TheConstantsOfTheTargetAreConfirmed) {
  const Study line{.target = "0.5 x + 2", .form = "a x + b", .over = {{"x", "0", "1"}}};
  const PublishedSet set{
      .form = "form", .values = {{"a", "0.5"}, {"b", "2"}}, .source = OthersText("a test")};
  const StudyJudgement judgement = judge_set(objective_of(line, Norm::least_squares, {}), set);
  EXPECT_EQ(name(judgement.verdict), "confirmed");
  EXPECT_EQ(judgement.chance, 0);
}

TEST(StudyVerdict, FindsAFitToAPartOfTheRange) {
  Study part = arc_cosine;
  part.over[0] = {"x", "0.05", "0.95"};
  EXPECT_EQ(verdict_and_objective(judged(printed(objective_of(part, Norm::least_squares, {}), 9))),
            "other-objective: least squares, x in 0.05:0.95");
}

}  // namespace
}  // namespace shadefit
