#include "fit/bounds/prove_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "fit/better/better_study.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

const Constraints rises{.monotone = Course::rises}, falls{.monotone = Course::falls};
const Constraints not_negative{.at_least = 0}, at_most_one{.at_most = 1};

/// A form of x over a range, and of y in [0, 1] if it has one. Its only parameter is a = 1.
StudySubject form_of(const std::string& form, const StudyRange& range = {"x", "0", "1"},
                     const std::string& target = "0") {
  StudySubject subject{{.target = target, .form = form, .over = {range}}, {{"a", "1"}}};
  if (form.find('y') != std::string::npos) subject.study.over.push_back({"y", "0", "1"});
  return subject;
}

struct ShapeCase {
  const char* name;
  StudySubject subject;
  Constraints constraint;
  Proof expected;
};

/// Whether a form equals a target at an end of x.
ShapeCase exact_at(double end, const char* name, const std::string& form, const std::string& target,
                   Proof expected) {
  return {name, form_of(form, {"x", "0", "1"}, target), {.exact_at = {end}}, expected};
}

/// What is expected follows from the formula: its derivative, or its values at the named places.
std::vector<ShapeCase> shapes() {
  const StudyRange around{"x", "-1", "1"};
  return {
      {"the slope a + x^2 is positive", form_of("a x + x^3/3"), rises, Proof::proven},
      {"the slope 1 - x is 0 at an end", form_of("a x - x^2/2"), rises, Proof::proven},
      {"the slope is 0 at 1/3 alone", form_of("a (x - 1/3)^3"), rises, Proof::proven},
      {"it is 0 there, less a rounding", form_of("a (x - 1/3)^3 - 1e-16 x"), rises, Proof::proven},
      // The slope is below 0 over 4e-4, between the places 0.333 and 0.334; the fall is 4/3 * 0.0002^3.
      {"a dip of 1.07e-11", form_of("a (x - 0.3335)^3/3 - 4e-8 x"), rises, Proof::refuted},
      // The slope is below 0 over about 1e-4; each millionth of the range would hide it from 1001 samples.
      {"a dip of 1e-4", form_of("x - (a/10000) exp(-((x - 0.3335)/0.00002)^2)"), rises, Proof::refuted},
      {"it rises", form_of("a x"), falls, Proof::refuted},
      {"a constant both rises and falls", form_of("a + 0 x"), falls, Proof::proven},
      {"a root with infinite slope at its end", form_of("sqrt(1 - x) (1.57 a - 0.15 x)"), falls,
       Proof::proven},
      {"roots that fall below 0 next to 0: 0.6 t^4 + 0.8 t^2 - 0.4 t, t = x^(1/8)",
       form_of("a (0.6 sqrt(x) + 0.8 sqrt(sqrt(x)) - 0.4 sqrt(sqrt(sqrt(x))))"), rises, Proof::refuted},
      {"a kink", form_of("max(a x, 2 x - 0.5)"), rises, Proof::proven},
      {"a choice that does not jump", form_of("x < 0.5 ? a x : 2 x - 0.5"), rises, Proof::proven},
      {"a choice that jumps down by 1e-6", form_of("x < 0.5 ? a x : 2 x - 0.500001"), rises, Proof::refuted},
      {"a choice that jumps up", form_of("x < 1/3 ? a x : 2 x"), rises, Proof::proven},
      {"the same, written from above", form_of("x > 1/3 ? 2 x : a x"), rises, Proof::proven},
      {"a choice that jumps down by 1e-6 inside a box", form_of("x < 1/3 ? a x : 2 x - 1/3 - 1e-6"), rises,
       Proof::refuted},
      {"the same, written from above", form_of("x > 1/3 ? 2 x - 1/3 - 1e-6 : a x"), rises, Proof::refuted},
      {"a choice that jumps up, then falls", form_of("x < 1/3 ? a x : 2 - x"), rises, Proof::refuted},
      // Only one choice is taken apart, and only if it switches once. No interval tells a jump up from a jump
      // down where both sides meet.
      {"two choices that jump up", form_of("x < 1/3 ? a x : (x < 2/3 ? 2 x : 3 x)"), rises, Proof::open},
      {"a choice that switches twice", form_of("(x - 0.5)^2 < 0.03 ? 2 a x : x"), falls, Proof::refuted},
      {"a floor that jumps up", form_of("a x + floor(3 x)"), rises, Proof::open},
      // Its slope is positive where it has one. At 0 it falls from 1 to 0.
      {"a jump at a pole inside", form_of("1/(1 + exp(a/x))", around), rises, Proof::open},
      {"a pole between clamps: from -5 to 5 at 0", form_of("max(min(a/x, 5), -5)", around), falls,
       Proof::open},
      {"the same up to the pole", form_of("1/(1 + exp(a/x))"), rises, Proof::open},

      {"a square, multiplied out", form_of("a x^2 - (2/3) x + 1/9"), not_negative, Proof::proven},
      {"it is 0 at 1/3, less 1e-13", form_of("a x^2 - (2/3) x + 1/9 - 1e-13"), not_negative, Proof::proven},
      {"it is 0 at 1/3, less 1e-11", form_of("a x^2 - (2/3) x + 1/9 - 1e-11"), not_negative, Proof::refuted},
      {"a negative end", form_of("a x - 1e-9"), not_negative, Proof::refuted},
      {"above a pole", form_of("a/x"), not_negative, Proof::proven},
      {"a jump below 0", form_of("x < 1/3 ? a x : x - 0.334"), not_negative, Proof::refuted},
      {"1 at the middle", form_of("4 a x (1 - x)"), at_most_one, Proof::proven},
      {"1 + 1e-6 there", form_of("4.000004 a x (1 - x)"), at_most_one, Proof::refuted},
      {"two variables, 0 at all edges", form_of("a x y (1 - x) (1 - y)"), not_negative, Proof::proven},
      {"two variables, below 0 at a corner", form_of("a x y - 1e-9"), not_negative, Proof::refuted},
      {"two variables, 1 at a corner", form_of("a x y"), at_most_one, Proof::proven},
      // It is (x - y)^2, and 0 along a whole line: too many boxes.
      {"two variables, 0 along the diagonal", form_of("a x^2 - 2 x y + y^2"), not_negative, Proof::open},
      {"an integral", form_of("integral(a x t, t, 0, 1)"), not_negative, Proof::open},

      exact_at(1, "the target at an end", "a sqrt(1 - x)", "acos(x)", Proof::proven),
      exact_at(0, "not at the other", "a sqrt(1 - x)", "acos(x)", Proof::refuted),
      exact_at(0, "half a last place of float off", "a + 3e-8 - x", "1 - x", Proof::proven),
      exact_at(0, "a last place and a half", "a + 9e-8 - x", "1 - x", Proof::refuted),
      exact_at(0, "a whole edge", "a y + x - x y", "sqrt(x^2 + y^2 (1 - x^2))", Proof::proven),
      exact_at(1, "the opposite edge", "a y + x - x y", "sqrt(x^2 + y^2 (1 - x^2))", Proof::proven),
      exact_at(0, "an edge of an integral", "a x y + y^3", "integral(3 t^2 + x, t, 0, y)", Proof::proven),
      exact_at(1, "its other edge", "a x y + y^4", "integral(3 t^2 + x, t, 0, y)", Proof::refuted),
      exact_at(0, "an edge without values", "a x y", "x/x + y", Proof::open),
      {"nothing asked for", form_of("a x"), {}, Proof::none},
  };
}

TEST(ProveShape, KnownShapes) {
  for (const ShapeCase& c : shapes()) {
    const ShapeProof result = prove_shape(c.subject, c.constraint, 1);
    EXPECT_EQ(name(result.proof), name(c.expected)) << c.name << ", " << result.boxes << " boxes";
    EXPECT_LE(result.boxes, most_shape_boxes) << c.name;
  }
}

TEST(ProveShape, NamesThePlace) {
  const auto place = [](const StudySubject& subject, const Constraints& constraint) {
    const ShapeProof result = prove_shape(subject, constraint, 1);
    EXPECT_EQ(result.proof, Proof::refuted);
    return result.place;
  };
  EXPECT_NEAR(place(form_of("a (x - 0.3335)^3/3 - 4e-8 x"), rises).at(0), 0.3335, 0.0005);
  EXPECT_NEAR(place(form_of("4.000004 a x (1 - x)"), at_most_one).at(0), 0.5, 0.001);
  const auto corner = place(form_of("a x y - 1e-9"), not_negative);
  EXPECT_LT(corner.at(0) * corner.at(1), 1e-9);
}

TEST(ProveShape, ACourseIsAlongOneVariable) {
  const auto prove = [](const std::string& form, std::size_t variable,
                        const Constraints& constraint = rises) {
    return prove_shape(form_of(form), constraint, 1, variable).proof;
  };
  EXPECT_EQ(prove("a x - y^2", 0), Proof::proven);
  EXPECT_EQ(prove("a x - y^2", 1), Proof::refuted);
  EXPECT_EQ(prove("a x - y^2", 1, falls), Proof::proven);
  EXPECT_EQ(prove("a x y", 0), Proof::proven) << "constant where y = 0";
  EXPECT_EQ(prove("max(a x, 2 x - y)", 0), Proof::proven) << "a kink along a line";
  EXPECT_EQ(prove("max(a x, 2 x - y)", 1), Proof::refuted);
  // It falls with x up to 1/2, unless y is 0.
  const ShapeProof dip = prove_shape(form_of("a (x - 0.5)^2 y"), rises, 1, 0);
  EXPECT_EQ(dip.proof, Proof::refuted);
  EXPECT_LT(dip.place.at(0), 0.5);
  EXPECT_GT(dip.place.at(1), 0);
  // A choice that the variable does not switch has no step along it.
  EXPECT_EQ(prove("y < 1/3 ? a x + 1 : 2 x", 0), Proof::proven) << "it falls only along y";
  EXPECT_EQ(prove("y < 1/3 ? a x + 1 : 2 x", 1), Proof::refuted);
  EXPECT_EQ(prove("y < 1/3 ? a x : 2 x", 1), Proof::proven) << "no step where x = 0";
  EXPECT_EQ(prove("y < 1/3 ? a x : 2 - x", 0), Proof::refuted) << "one side falls";
}

/// The slope is (x - y)^2. Each line crosses the diagonal once, the boxes along it are many.
TEST(ProveShape, ACourseIsProvenLineByLine) {
  const StudySubject subject = form_of("a x^3/3 - x^2 y + x y^2");
  EXPECT_EQ(prove_shape(subject, rises, 1e5).proof, Proof::proven);
  EXPECT_EQ(prove_shape(form_of("a x^3/3 - x^2 y + x y^2 - 1e-4 x"), rises, 1e5).proof, Proof::refuted);
}

/// Along the edge y = 0 the form is off by a part of 2^-24 = 5.96e-8.
TEST(ProveShape, AnEdgeIsExactWithinItsSlack) {
  const auto prove = [](const std::string& off) {
    const StudySubject subject = form_of("a x + y + " + off + "*4 x (1 - x)", {"x", "0", "1"}, "x + y");
    return prove_shape(subject, {.exact_at = {0}}, 1, 1);
  };
  EXPECT_EQ(prove("5.9e-8").proof, Proof::proven);
  const ShapeProof refuted = prove("6e-8");
  EXPECT_EQ(refuted.proof, Proof::refuted);
  ASSERT_EQ(refuted.place.size(), 2U);
  EXPECT_NEAR(refuted.place[0], 0.5, 0.05);
  EXPECT_EQ(refuted.place[1], 0);
  // With a slack of its own, as of printed digits.
  const StudySubject subject = form_of("a x + y + 6e-8", {"x", "0", "1"}, "x + y");
  EXPECT_EQ(prove_exact(subject, 1, 0, 7e-8).proof, Proof::proven);
  EXPECT_EQ(prove_exact(subject, 1, 0, 5e-8).proof, Proof::refuted);
}

TEST(ProveShape, AFaceOfThreeVariables) {
  const auto prove = [](const std::string& form, std::size_t axis) {
    const StudySubject subject{{.target = "x + y z + z^2",
                                .form = form,
                                .over = {{"x", "0", "1"}, {"y", "0", "1"}, {"z", "0", "2"}}},
                               {{"a", "1"}}};
    return prove_shape(subject, {.exact_at = {axis == 1 ? 1.0 : 2.0}}, 1, axis);
  };
  EXPECT_EQ(prove("a x + y z + 2 z", 2).proof, Proof::proven);
  const ShapeProof refuted = prove("a x + y z + 2 z", 1);
  EXPECT_EQ(refuted.proof, Proof::refuted);
  ASSERT_EQ(refuted.place.size(), 3U);
  EXPECT_EQ(refuted.place[1], 1);
}

/// An open proof says why.
TEST(ProveShape, SaysWhyItIsOpen) {
  const auto reason = [](const std::string& form, const Constraints& constraint) {
    return prove_shape(form_of(form), constraint, 1).reason;
  };
  EXPECT_EQ(reason("integral(a x t, t, 0, 1)", not_negative), "the form has an integral");
  EXPECT_EQ(reason("a x^2 - 2 x y + y^2", not_negative), "a proof needs more than 5000 boxes");
  EXPECT_EQ(reason("1/(1 + exp(a/x))", rises), "a proof finds no finite bound");
  EXPECT_EQ(reason("a x", rises), "");
  EXPECT_NEAR(prove_shape(form_of("a x + floor(3 x)"), rises, 1).place.at(0), 1.0 / 3, 1e-9);
}

/// The slack is a part of the scale.
TEST(ProveShape, MeasuresInTheScale) {
  const StudySubject subject = form_of("a x^2 - (2/3) x + 1/9 - 1e-11");
  EXPECT_EQ(prove_shape(subject, not_negative, 1).proof, Proof::refuted);
  EXPECT_EQ(prove_shape(subject, not_negative, 11).proof, Proof::proven);
}

TEST(ProveShape, RefusesOtherParameters) {
  StudySubject subject = form_of("a x");
  subject.parameters = {{"b", "1"}};
  EXPECT_THROW(prove_shape(subject, rises, 1), UserError);
}

/// Samples do not see a dip of 1e-4 at 0.3335, nor roots that are negative below 0.3^8. Proofs do.
TEST(CompareStudy, DropsWhatIsRefuted) {
  const auto properties = [](const std::string& target, const std::string& form, const std::string& a) {
    StudyFile file;
    file.id = "planted";
    file.study = {.target = target, .form = "", .over = {{"x", "0", "1"}}};
    file.forms = {{"form", form}};
    file.published = {{.form = "form", .values = {{"a", a}}, .source = OthersText("Doe 2020")}};
    return text_with_proofs(compare_study(file, file.study).contenders.front().properties);
  };
  const std::string ends = "exact at x = 0 (proven), exact at x = 1 (proven), ";
  const std::string bounds = "not negative (proven), at most 1 (proven)";
  EXPECT_EQ(properties("x", "a x - 0.0001 exp(-((x - 0.3335)/0.00002)^2)", "1"), ends + bounds);
  EXPECT_EQ(properties("x", "a x", "1"), ends + "rises (proven), " + bounds);
  EXPECT_EQ(properties("sqrt(x)", "(1 + a) sqrt(sqrt(x)) - a sqrt(sqrt(sqrt(x)))", "0.3"),
            ends + "at most 1 (proven)");
  EXPECT_EQ(properties("x", "x < 1/3 ? a x : x", "0.5"), ends + "rises (proven), " + bounds);
  // An interval does not know how a floor jumps.
  EXPECT_EQ(properties("x", "a x + floor(3 x)/10", "0.7"),
            ends + "rises (sampled: a proof needs more than 5000 boxes near x = 0.333), " + bounds);
}

}  // namespace
}  // namespace shadefit
