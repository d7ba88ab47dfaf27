#include "fit/catalogue/bounded_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "fit/catalogue/study_parts.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/study_objectives.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"

namespace shadefit {
namespace {

Study bounded_line(const std::string& target, const std::string& form,
                   const std::vector<std::string>& bounds) {
  Study study{.target = target, .form = form, .over = {{"x", "0", "1"}}};
  for (const std::string& text : bounds) study.bounds.push_back(parse_bounds("--bounds", text));
  return study;
}

StudyFit bounded_fit(const Study& study, Norm norm = Norm::least_squares,
                     const Constraints& constraints = {}) {
  return fit_study(objective_of(study, norm, constraints));
}

std::vector<std::string> words_in(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

/// Rows at even places of [0, 1].
std::shared_ptr<const MeasuredRows> even_rows(const std::string& values) {
  MeasuredRows rows{std::string("rows"), {{}}, {}, {}};
  for (const std::string& value : words_in(values)) rows.value.push_back(std::stod(value));
  for (std::size_t i = 0; i < rows.value.size(); ++i)
    rows.places.front().push_back(static_cast<double>(i) / static_cast<double>(rows.value.size() - 1));
  return std::make_shared<const MeasuredRows>(rows);
}

// Random problems: forms that are linear and others, ranges and rows, both norms. SciPy's linear programmes
// meet their conditions to about 1e-9, on a grid that sees a level to about 1e-7 of it. Of forms that are not
// linear its levels end where no step of a smaller region is lower.
TEST(BoundedStudy, AgreesWithSciPy) {
  std::map<std::size_t, int> held;
  int open = 0;
  for (const auto& row :
       parse_csv(read_file(SHADEFIT_SOURCE_DIR "/tests/references/bounded.csv"), "bounded.csv").rows) {
    const bool has_rows = words_in(row[1]).size() > 8, has_level = row[0] == "level";
    Study study = bounded_line(row[1], row[2], words_in(row[3]));
    if (has_rows) study.rows = even_rows(row[1]), study.over = {{"x", "", ""}};
    const StudyFit fit = bounded_fit(study, has_level ? Norm::minimax : Norm::least_squares);
    const std::string what = row[0] + ", " + row[1] + ", " + row[2] + ", " + row[3];
    // At a bound fewer places may hold the level of a form than determine its other parameters.
    const bool is_open = has_level && !fit.is_global && fit.status == Status::degenerate;
    ASSERT_TRUE(is_open || fit.status == Status::converged) << what << ": " << fit.why;
    open += is_open ? 1 : 0;
    const double best = std::stod(row[4]), found = has_level ? *fit.level : fit.rms_error;
    EXPECT_NEAR(found, best, has_level ? best * (fit.is_global ? 2e-6 : 1e-4) + 1e-8 : 1e-8 * best) << what;
    std::size_t at_bounds = 0;
    for (std::size_t i = 0; i < fit.names.size(); ++i) {
      for (const ParameterBounds& bounds : study.bounds) {
        if (bounds.parameter != fit.names[i]) continue;
        EXPECT_GE(fit.parameters[i], bounds.lower) << what;
        EXPECT_LE(fit.parameters[i], bounds.upper) << what;
        at_bounds += fit.parameters[i] == bounds.lower || fit.parameters[i] == bounds.upper ? 1 : 0;
      }
    }
    EXPECT_EQ(fit.at_bounds.size(), is_open ? 0 : at_bounds) << what;
    ++held[at_bounds];
  }
  EXPECT_LE(open, 5);
  for (std::size_t count = 0; count < 4; ++count) EXPECT_GT(held[count], 2) << count;
}

// The nearest line to x has b = 1; with b <= 1/2 it goes through the mean.
TEST(BoundedStudy, SaysWhatLiesOnABound) {
  const StudyFit inside = bounded_fit(bounded_line("x", "a + b x", {"b=0.5:2"}));
  EXPECT_TRUE(inside.at_bounds.empty());
  const StudyFit fit = bounded_fit(bounded_line("x", "a + b x", {"b=0:0.5", "a=-1:1"}));
  ASSERT_EQ(fit.at_bounds, (std::vector<Held>{{"b", 0.5}}));
  EXPECT_NEAR(fit.parameters[0], 0.25, 1e-15);
  EXPECT_TRUE(fit.is_global);
  const StudyFit one_sided = bounded_fit(bounded_line("x", "a + b x", {"b=:1"}));
  EXPECT_EQ(one_sided.parameters[1], 1) << "the free optimum is the bound itself";
  // All parameters are at bounds.
  const StudyFit corner = bounded_fit(bounded_line("x", "a + b x", {"b=1.2:", "a=0.1:"}), Norm::minimax);
  EXPECT_EQ(corner.parameters, (std::vector<double>{0.1, 1.2}));
  EXPECT_NEAR(*corner.level, 0.3, 1e-15);
}

// a = 0.6 breaks a + b x <= 0.5 at x = 0, and a = 0.4 does not: then b = 0.1.
TEST(BoundedStudy, KeepsConstraintsToo) {
  const StudyFit fit =
      bounded_fit(bounded_line("x", "a + b x", {"a=0.4:"}), Norm::least_squares, {.at_most = 0.5});
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  EXPECT_EQ(fit.parameters[0], 0.4);
  EXPECT_NEAR(fit.parameters[1], 0.1, 1e-15);
  const StudyFit both = bounded_fit(bounded_line("x", "a + b x", {"a=0.4:0.42", "b=:0.05"}),
                                    Norm::least_squares, {.at_most = 0.5});
  EXPECT_EQ(both.parameters, (std::vector<double>{0.42, 0.05})) << "a corner that keeps the constraint";
  const StudyFit none =
      bounded_fit(bounded_line("x", "a + b x", {"a=0.6:"}), Norm::least_squares, {.at_most = 0.5});
  EXPECT_EQ(name(none.status), "infeasible") << none.why;
  EXPECT_EQ(none.why.substr(0, 34), "no fit was found within the bounds") << none.why;
}

// Where x itself lies within the bounds, it is the answer.
TEST(BoundedStudy, LeavesAnExactForm) {
  const StudyFit fit = bounded_fit(bounded_line("x", "a + b x", {"b=0:0.5"}), Norm::minimax);
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  EXPECT_NEAR(*fit.level, 0.25, 1e-15);
  const StudyFit exact = bounded_fit(bounded_line("x", "a + b x", {"b=0:2"}), Norm::minimax);
  ASSERT_EQ(name(exact.status), "converged") << exact.why;
  EXPECT_EQ(exact.level, 0);
  EXPECT_NEAR(exact.parameters[1], 1, 1e-15);
  EXPECT_EQ(name(bounded_fit(bounded_line("x", "a x + b x + d", {"b=0:2"})).status), "degenerate");
}

// At g = 0.2 no exchange settles: what is worse is not the answer.
TEST(BoundedStudy, AnswersNothingWorseThanAFitThatFailed) {
  Study study = bounded_line("sqrt(1 + x + 2 y)", "(a + b x + d y)/(1 + f x + g y)", {"g=0:0.2"});
  study.over.push_back({"y", "0", "1"});
  const StudyFit fit = bounded_fit(study, Norm::minimax);
  if (fit.status == Status::converged) {
    EXPECT_LT(*fit.level, 0.009);
  }
}

// The free optimum runs to infinity: (1 + x/n)^n is nearest to e^x for n without end.
TEST(BoundedStudy, HoldsWhatWouldRunToInfinity) {
  const StudyFit fit = bounded_fit(bounded_line("exp(x)", "pow(1 + x/n, n)", {"n=1:64"}));
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  EXPECT_EQ(fit.at_bounds, (std::vector<Held>{{"n", 64}}));
}

// Of two curves that are as good the bounds choose one; a start outside is moved inside.
TEST(BoundedStudy, ChoosesABasin) {
  Study study = bounded_line("(x - 1/2)^2 + x/10", "(x - a)^2 + (a^2 - 1/4) (a^2 - 4)", {"a=1:"});
  study.starts = {{"a", -3}};
  const StudyFit fit = bounded_fit(study);
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  EXPECT_GT(fit.parameters[0], 1);
  study.bounds = {{"a", -HUGE_VAL, 1}};
  EXPECT_LT(bounded_fit(study).parameters[0], 1);
}

// With a = 0 the form does not depend on b.
TEST(BoundedStudy, SaysWhyAFaceHasNoFit) {
  const StudyFit fit = bounded_fit(bounded_line("-1 - x", "a exp(b x)", {"a=0:"}));
  EXPECT_EQ(name(fit.status), "infeasible");
  EXPECT_EQ(fit.why,
            "no fit was found within the bounds, with a = 0: --form does not depend on its parameter 'b'");
}

// The units of the range are powers of two far from 1.
TEST(BoundedStudy, KeepsItsUnits) {
  Study study = bounded_line("x^2", "a + b x", {"b=0:0.5e-30"});
  study.over = {{"x", "0", "1e-30"}};
  const StudyFit fit = bounded_fit(study);
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  EXPECT_EQ(fit.at_bounds, (std::vector<Held>{{"b", 0.5e-30}}));
  EXPECT_NEAR(fit.parameters[0] / (1e-60 / 12), 1, 1e-13) << "1/3 - 1/4";
}

TEST(BoundedStudy, ReadsBounds) {
  EXPECT_EQ(parse_bounds("--bounds", "a=0:pi/2"), (ParameterBounds{"a", 0, std::acos(0.0)}));
  EXPECT_EQ(to_text(parse_bounds("--bounds", "a = : 1")), "a=:1");
  EXPECT_EQ(to_text(parse_bounds("--bounds", "a=-0.5:")), "a=-0.5:");
  const auto refusal_of = [](const char* text) -> std::string {
    try {
      parse_bounds("--bounds", text);
    } catch (const UserError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(refusal_of("a=1"), "--bounds 'a=1' is not NAME=A:B, NAME=A: or NAME=:B");
  EXPECT_EQ(refusal_of("0:1"), "--bounds '0:1' is not NAME=A:B, NAME=A: or NAME=:B");
  EXPECT_EQ(refusal_of("a=0:1:2"), "--bounds 'a=0:1:2' is not NAME=A:B, NAME=A: or NAME=:B");
  EXPECT_EQ(refusal_of("a=:"), "--bounds 'a=:' has no end: say --bounds a=0: for values from 0 on");
  EXPECT_EQ(refusal_of("a=2:1"), "--bounds 'a=2:1' is empty: it must rise, say --bounds a=1:2");
  EXPECT_EQ(refusal_of("a=1:1"), "--bounds 'a=1:1' leaves one value: say --fix a=1");
  EXPECT_EQ(refusal_of("a=0:b"), "--bounds 'a=0:b': 'b' is not a finite number");
}

}  // namespace
}  // namespace shadefit
