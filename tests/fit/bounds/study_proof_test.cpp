#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "fit/bounds/enclosed_error.hpp"
#include "fit/bounds/study_certificate.hpp"
#include "fit/bounds/study_integral.hpp"
#include "fit/exchange/minimax_study.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

constexpr double pi = std::numbers::pi;

CertifiedStudy proof_of(const StudySubject& subject) {
  return certify_study(subject, usual_study_width(subject.study.over.size()));
}

/// A study whose largest error has a closed form.
struct KnownMaximum {
  const char* name;
  StudySubject subject;
  double expected;
};

/// A form of x in [0, 1].
StudySubject on_unit(const std::string& target, const std::string& form, const Constants& parameters) {
  return {{.target = target, .form = form, .over = {{"x", "0", "1"}}}, parameters};
}

std::vector<KnownMaximum> known_maxima() {
  const StudyRange unit{"x", "0", "1"}, other_unit{"y", "0", "1"};
  constexpr double h = 1.0 / 64;
  const auto integral_of_atan = [](double x) { return x * std::atan(x) - std::log1p(x * x) / 2; };
  return {
      {"a line for a square: 1/8 at both ends and between",
       on_unit("x^2", "a + b x", {{"a", "-0.125"}, {"b", "1"}}), 0.125},
      // 1/4 + t^2 - t with t = sqrt(1 - x)
      {"a root at an end", on_unit("sqrt(1-x)", "a - x", {{"a", "1.25"}}), 0.25},
      {"a root at an end whose infinite slope cancels",
       on_unit("sqrt(1-x) + x", "a sqrt(1-x) + b", {{"a", "1"}, {"b", "0.25"}}), 0.75},
      {"an arc cosine at 1, where its slope is infinite", on_unit("acos(x)", "a", {{"a", "0"}}), pi / 2},
      {"a logarithm at an end: x log x, largest at 1/e",
       {{.target = "x log(x)", .form = "a x", .over = {{"x", "1e-9", "1"}}}, {{"a", "0"}}},
       1 / std::numbers::e},
      {"a kink at the largest error", on_unit("abs(x - 1/3)", "a", {{"a", "1"}}), 1},
      {"a kink of a maximum under a root", on_unit("sqrt(max(x - 1/3, 0))", "a", {{"a", "0"}}),
       std::sqrt(2.0 / 3)},
      {"a jump of a choice", on_unit("x < 0.5 ? 0 : 1", "a + b x", {{"a", "-0.25"}, {"b", "1.5"}}), 0.5},
      {"jumps whose upper ends are not attained", on_unit("floor(3 x)", "a x", {{"a", "3"}}), 1},
      {"the jump of a sign", on_unit("sign(x - 1/3)", "a (x - 1/3)", {{"a", "0.25"}}), 1},
      {"an angle on the side of its jump that the range ends at",
       {{.target = "atan2(y, x)", .form = "a", .over = {{"x", "-2", "-1"}, {"y", "-1", "0"}}}, {{"a", "0"}}},
       pi},
      {"two variables: 1/4 at all four corners",
       {{.target = "x y", .form = "a + b x + d y", .over = {unit, other_unit}},
        {{"a", "-0.25"}, {"b", "0.5"}, {"d", "0.5"}}},
       0.25},
      {"a peak inside a square",
       {{.target = "x (1 - x) y (1 - y)", .form = "a", .over = {unit, other_unit}}, {{"a", "0"}}},
       1.0 / 16},
      {"three variables",
       {{.target = "x y z", .form = "a x", .over = {unit, other_unit, {"z", "-1", "2"}}}, {{"a", "0"}}},
       2},
      {"a relative error: a/(3 x) - 1",
       {{.target = "x", .form = "a/3", .over = {{"x", "1", "2"}}, .error = Error::relative}, {{"a", "4"}}},
       1.0 / 3},
      {"a weight: x (1 - x)",
       {{.target = "x", .form = "a", .over = {unit}, .weight = "x"}, {{"a", "1"}}},
       0.25},
      // The integral of t from 0 to x is x^2/2; the difference x/2 - x^2/2 is largest at 1/2.
      {"an integral up to the variable", on_unit("integral(t, t, 0, x)", "a x", {{"a", "0.5"}}), 0.125},
      {"a relative error to an integral with a root at its end: x/4 - 1 at 0",
       {{.target = "3/2 * integral(sqrt(t), t, 0, 1)",
         .form = "a x",
         .over = {unit},
         .error = Error::relative},
        {{"a", "0.25"}}},
       1},
      // The integral is x^2 + (1 - x)^2 over 2; less 1/4 it is largest at both ends.
      {"a kink that moves through the integral",
       on_unit("integral(abs(t - x), t, 0, 1)", "a", {{"a", "0.25"}}), 0.25},
      // The argument of abs touches 0 in the middle of the only panel. With h = 1/64 the integral is 2 h - 2
      // sin h.
      {"abs of what touches 0",
       on_unit("x integral(abs(1 - cos(t - 0.5)), t, 31/64, 33/64)", "a", {{"a", "0"}}),
       h * h * h / 3 * (1 - h * h / 20 * (1 - h * h / 42))},
      // At x = 1 the body is 1, and before it is 0.
      {"a condition that holds at one place alone",
       on_unit("integral(x < 1 ? t - t^2 : 1, t, 0, 1)", "a", {{"a", "0"}}), 1},
      // The angle is -pi - atan(t) below 0 and pi - atan(t) above.
      {"an angle that jumps inside", on_unit("x integral(atan2(t, -1), t, -2, 1)", "a", {{"a", "0"}}),
       pi - integral_of_atan(2) + integral_of_atan(1)},
      {"an integral in two variables: x y^2/2",
       {{.target = "integral(x t, t, 0, y)", .form = "a x", .over = {unit, other_unit}}, {{"a", "0"}}},
       0.5},
      {"a definition and a given constant: 2 x - 2 x^2",
       {{.target = "f(x, k)",
         .form = "k x",
         .over = {unit},
         .definitions = {{"f", {"t", "n"}, "n t^2"}},
         .given = {{"k", "4/2"}}},
        {}},
       0.5},
  };
}

TEST(StudyProof, EnclosesWhatIsKnown) {
  for (const KnownMaximum& known : known_maxima()) {
    const auto [certificate, is_reached] = proof_of(known.subject);
    EXPECT_TRUE(is_reached) << known.name;
    // The closed form is rounded.
    constexpr double rounding = 1e-15;
    EXPECT_LE(certificate.lower, known.expected * (1 + rounding)) << known.name;
    EXPECT_GE(certificate.upper, known.expected * (1 - rounding)) << known.name;
    const double width = usual_study_width(certificate.ranges.size());
    EXPECT_LE(certificate.upper, certificate.lower * (1 + width) * (1 + rounding)) << known.name;
    EXPECT_EQ(reason_to_refuse(certificate), "") << known.name;
  }
}

// Where a jump moves through an integral, the slope of the body is 0 and that of the integral is not. x - x^2
// is largest at 1/2.
TEST(StudyProof, TakesNoSlopeOfAnIntegralThatMayJump) {
  const StudySubject subject{
      {.target = "integral(t < x ? 1 : 0, t, 0, 1)", .form = "a x^2", .over = {{"x", "0", "1"}}},
      {{"a", "1"}}};
  constexpr std::size_t few = 100;
  const StudyCertificate certificate = certify_study(subject, 1e-9, keep_going, few).certificate;
  EXPECT_LE(certificate.lower, 0.25);
  EXPECT_GE(certificate.upper, 0.25);
  EXPECT_LE(certificate.upper, 0.26);
  EXPECT_EQ(reason_to_refuse(certificate), "");
}

/// A search in doubles and the proof agree.
TEST(StudyProof, AgreesWithSamples) {
  const std::vector<StudySubject> subjects{
      {{.target = "acos(x)", .form = "sqrt(1-x) (a + b x)", .over = {{"x", "0", "1"}}},
       {{"a", "1.5707963"}, {"b", "-0.156583"}}},
      {{.target = "(1 - c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}},
       {{"a", "-5.55473"}, {"b", "-6.98316"}}},
      {{.target = "x <= 0.0031308 ? 12.92 x : 1.055 pow(x, 1/2.4) - 0.055",
        .form = "pow(x, 1/a)",
        .over = {{"x", "0", "1"}}},
       {{"a", "2.2"}}},
      {{.target = "sin(x y)", .form = "a x + b y", .over = {{"x", "0", "1"}, {"y", "0", "pi"}}},
       {{"a", "0.25"}, {"b", "0.125"}}},
  };
  for (const StudySubject& subject : subjects) {
    const ReadStudy study = read_formulas(subject.study);
    std::vector<double> parameters;
    for (const auto& [name, text] : subject.parameters) parameters.push_back(std::stod(text));
    const double sampled = largest_error(study, parameters).magnitude;
    const StudyCertificate certificate = proof_of(subject).certificate;
    EXPECT_LE(sampled, certificate.upper * (1 + 1e-13)) << subject.study.target;
    EXPECT_GE(sampled, certificate.lower * (1 - 1e-6)) << subject.study.target;
  }
}

TEST(StudyProof, HoldsTheMinimaxLevelOfTheArcCosine) {
  const Study study{.target = "acos(x)", .form = "sqrt(1-x) (a + b x)", .over = {{"x", "0", "1"}}};
  const StudyFit fit = solve_minimax_study(read_study(study), {}, {});
  const StudyCertificate certificate = proof_of({study, constants_of(study, fit)}).certificate;
  // The level to 15 digits, from the fit in 50 digits. a is a double: it adds at most its ulp.
  EXPECT_LE(certificate.lower, 0.003206963815473175 + 0x1p-52);
  EXPECT_GE(certificate.upper, 0.003206963815473165);
}

/// Proofs that share the integral of their target find what they find alone. One with a parameter is not
/// shared.
TEST(StudyProof, ProofsMayShareIntegrals) {
  const auto subject = [](const std::string& form, const std::string& a) {
    return StudySubject{
        {.target = "integral(1/(1 + x + (1 - x) t^2), t, 0, 1)", .form = form, .over = {{"x", "0", "1"}}},
        {{"a", a}}};
  };
  const KnownIntegrals known;
  for (const StudySubject& one :
       {subject("a - 0.3 x", "0.78"), subject("a - 0.3 x", "0.79"),
        subject("integral(t^2 (a - x), t, 0, 1)", "2"), subject("integral(t^2 (a - x), t, 0, 1)", "3")}) {
    const StudyCertificate shared = certify_study(one, 1e-6, keep_going, 500, &known).certificate,
                           alone = certify_study(one, 1e-6, keep_going, 500).certificate;
    EXPECT_EQ(shared.lower, alone.lower) << one.study.form;
    EXPECT_EQ(shared.upper, alone.upper) << one.study.form;
    EXPECT_EQ(shared.boxes, alone.boxes) << one.study.form;
  }
}

/// The bound on a box holds for each place in it, for so many boxes, each the half of another. The places of
/// a box are at these shares of its sides.
void expect_bounds_of_places(const Study& study, std::size_t count, const std::vector<double>& shares) {
  EnclosedError error(read_formulas(study), {});
  const auto ranges = error.ranges();
  std::vector<StudyBox> boxes = corners_of(ranges);
  for (std::size_t i = 0; i < count; ++i) {
    const StudyBox box = boxes[i];
    const double bound = error.bound_on(box, 0).bound;
    std::vector<std::vector<double>> places{{}};
    for (std::size_t k = 0; k < box.size(); ++k) {
      std::vector<std::vector<double>> longer;
      for (const std::vector<double>& place : places) {
        for (const double share : shares) {
          longer.push_back(place);
          longer.back().push_back((box[k].is_from_upper ? ranges[k].upper : ranges[k].lower) + box[k].lower +
                                  share * (box[k].upper - box[k].lower));
        }
      }
      places = longer;
      const auto halves = halves_of(box, k);
      ASSERT_TRUE(halves);
      boxes.insert(boxes.end(), halves->begin(), halves->end());
    }
    for (const std::vector<double>& place : places)
      EXPECT_LE(smallest_magnitude_in(error.at(place)), bound) << study.target << " at " << place[0];
  }
}

/// In one variable the slope is bounded by the second derivative. Where the slope jumps, at a kink of the
/// form, of the target or of an integral, the second derivative knows nothing of the jump.
TEST(StudyProof, BoundsEachPlaceOfABox) {
  expect_bounds_of_places({.target = "max(x, y^2) + floor(2 x) sign(y)",
                           .form = "abs(x - y) sqrt(1 - x)",
                           .over = {{"x", "0", "1"}, {"y", "-1", "1"}}},
                          200, {0, 0.3, 0.6, 1});
  const StudyRange unit{"x", "0", "1"};
  for (const Study& study :
       {Study{.target = "10 abs(x - 1/3) + x^3", .form = "5 x", .over = {unit}},
        Study{.target = "max(x^2, 7 (x - 1/3)) - min(sin(9 x), 0.3)", .form = "x", .over = {unit}},
        Study{.target = "x < 1/3 ? 1 - 3 x : (x - 1/3)^2", .form = "x^2", .over = {unit}},
        Study{.target = "integral(abs(x - t) + t x^3, t, 0, 1)", .form = "x", .over = {unit}},
        Study{.target = "exp(integral(cos(3 t x)/(1 + x t^2), t, 0, 1))", .form = "x", .over = {unit}},
        Study{.target = "x integral(x t, t, 0, 1)", .form = "0.45 x", .over = {unit}}})
    expect_bounds_of_places(study, 60, {0, 0.21, 0.5, 0.83, 1});
}

/// Where form and target are near each other their slopes cancel at a place, not on a box: without the second
/// derivative each of these needs more than 1000 boxes.
TEST(StudyProof, NeedsFewBoxesForASmallError) {
  const StudyRange unit{"x", "0", "1"};
  for (const Study& study : {Study{.target = "exp(x)",
                            .form = "1 + x (1 + x (1/2 + x (1/6 + x (1/24 + x (1/120 + x/720)))))",
                            .over = {unit}},
                             Study{.target = "integral(exp(t x), t, 0, 1)",
                             .form = "1 + x (1/2 + x (1/6 + x (1/24 + x (1/120 + x/720))))",
                             .over = {unit}}}) {
    const CertifiedStudy proof = certify_study({study, {}}, 1e-4);
    EXPECT_TRUE(proof.is_reached);
    EXPECT_LT(count_boxes(proof.certificate), 300U) << study.target;
    EXPECT_EQ(reason_to_refuse(proof.certificate), "");
  }
}

TEST(StudyProof, SaysThatThereIsNoBound) {
  const auto reason = [](const Study& study) -> std::string {
    try {
      proof_of({study, {}});
    } catch (const CheckFailed& failed) {
      return failed.what();
    }
    return "";
  };
  const std::string begin =
      "no double was proven to bound the largest error: the formulas have no finite bound near ";
  EXPECT_EQ(reason({.target = "1/x", .form = "x", .over = {{"x", "-1", "1"}}}), begin + "x = 0");
  EXPECT_EQ(reason({.target = "log(x)", .form = "x", .over = {{"x", "0", "1"}}}), begin + "x = 0");
  // Beyond 1 there is no arc cosine.
  EXPECT_EQ(reason({.target = "acos(x)", .form = "x", .over = {{"x", "0", "1.5"}}}).substr(0, begin.size()),
            begin);
  EXPECT_EQ(reason({.target = "1/(x - y)", .form = "x", .over = {{"x", "0", "1"}, {"y", "0", "1"}}})
                .substr(0, begin.size()),
            begin);
}

TEST(StudyProof, KeepsItsBoundsWhereTheBoxesEnd) {
  const StudySubject subject{{.target = "sin(x)", .form = "x - x^3/6", .over = {{"x", "0", "pi/2"}}}, {}};
  const auto [certificate, is_reached] = certify_study(subject, 1e-12, keep_going, 3);
  EXPECT_FALSE(is_reached);
  EXPECT_EQ(count_boxes(certificate), 3u);
  const double error = pi / 2 - std::pow(pi / 2, 3) / 6 - 1;
  EXPECT_LE(certificate.lower, std::abs(error) * (1 + 1e-15));
  EXPECT_GE(certificate.upper, std::abs(error) * (1 - 1e-15));
  EXPECT_EQ(reason_to_refuse(certificate), "");
  EXPECT_THROW(certify_study(subject, 1, keep_going), UserError);
}

TEST(StudyProof, NamesTheFaultOfItsSubject) {
  const Study study{.target = "x", .form = "a x + b", .over = {{"x", "0", "1"}}};
  EXPECT_EQ(fault_of({study, {{"a", "1"}, {"b", "0x1p-1"}}}), "");
  EXPECT_EQ(fault_of({study, {{"a", "1"}}}), "parameter 'b' of the form is missing");
  EXPECT_EQ(fault_of({study, {{"b", "1"}, {"a", "1"}}}), "parameter 'b' is out of order");
  EXPECT_EQ(fault_of({study, {{"a", "1"}, {"a", "1"}, {"b", "1"}}}), "parameter 'a' is given twice");
  EXPECT_EQ(fault_of({study, {{"a", "1"}, {"d", "1"}}}),
            "parameter 'd' is unknown: the form has none of that name");
  EXPECT_EQ(fault_of({study, {{"a", "one"}, {"b", "1"}}}), "parameter a 'one' is not a finite number");
  Study other = study;
  other.target = "integral(integral(s t, s, 0, x), t, 0, 1)";
  EXPECT_EQ(fault_of({other, {}}),
            "an 'integral' inside another one has no proof; a truth such as ggx_albedo is one");
  other.target = "cosine(x)";
  EXPECT_NE(fault_of({other, {}}).find("--target"), std::string::npos);
}

TEST(StudyBoxes, AreReadAsTheyAreCut) {
  const std::array ranges{Domain{0, 1}, Domain{-1, 1}};
  const auto visited = [&](const char* text) {
    int count = 0;
    const std::string answer = visit_boxes(ranges, text, [&](const StudyBox&) {
      ++count;
      return std::string();
    });
    return answer.empty() ? std::to_string(count) : answer;
  };
  EXPECT_EQ(visited("...."), "4");
  EXPECT_EQ(visited("1..2...."), "6");
  EXPECT_EQ(visited("..."), "its boxes end before they cover the ranges");
  EXPECT_EQ(visited("...1."), "its boxes end before they cover the ranges");
  EXPECT_EQ(visited("....."), "its boxes go on after the last one");
  EXPECT_EQ(visited("3...."), "its boxes have an unknown sign: '3'");
  EXPECT_EQ(visited("0...."), "its boxes have an unknown sign: '0'");
  EXPECT_EQ(visited(std::string(1200, '1').c_str()), "its boxes cut one between neighbouring doubles");
  EXPECT_EQ(visit_boxes(ranges, "....", [](const StudyBox&) { return std::string("no"); }), "no");
}

TEST(StudyBoxes, CoverTheirRanges) {
  // The middle of neighbouring doubles is no double; that of the largest is.
  for (const Domain& range : {Domain{0, 1}, Domain{0.1, 0.7}, Domain{1, std::nextafter(1, 2)},
                              Domain{-1.7e308, 1.7e308}, Domain{0, 5e-324}}) {
    const auto corners = corners_of(std::array{range});
    const Interval low = numbers_of(corners[0][0], range), high = numbers_of(corners[1][0], range);
    EXPECT_EQ(lower_end(low), range.lower);
    EXPECT_EQ(upper_end(high), range.upper);
    EXPECT_NE(less(low, high), Certainty::yes);  // no gap
    EXPECT_LE(upper_end(low), range.upper);
    EXPECT_GE(lower_end(high), range.lower);
  }
}

TEST(StudyProof, KnowsWhichEndsAreDoubles) {
  EXPECT_TRUE(is_exactly({}, "1/2", 0.5));
  EXPECT_TRUE(is_exactly({}, "-3", -3));
  EXPECT_FALSE(is_exactly({}, "pi/2", pi / 2));
  EXPECT_FALSE(is_exactly({}, "0.1", 0.1));
  EXPECT_FALSE(is_exactly({}, "1/2", 0.25));
  const Study given{.target = "x", .form = "a x", .over = {}, .given = {{"k", "4"}}};
  EXPECT_TRUE(is_exactly(given, "1/k", 0.25));
}

}  // namespace
}  // namespace shadefit
