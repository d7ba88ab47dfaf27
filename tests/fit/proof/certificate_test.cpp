#include "fit/proof/certificate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "fit/proof/enclosure.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "tests/refusal.hpp"

namespace shadefit {
namespace {

Subject published_pair() {
  return {.family = "fresnel-quadratic", .parameters = {{"a", "-5.55473"}, {"b", "-6.98316"}}};
}

Subject gaussian(double exponent) {
  return {.family = "sg-offset", .parameters = {{"x", "0.775"}}, .setting = exponent};
}

TEST(Certificate, HoldsWhatItSays) {
  Subject relative = gaussian(5), part = published_pair();
  relative.error = Error::relative;
  part.domain = {0.25, 0.625};
  Subject exact{
      .family = "fresnel-one-term", .parameters = {{"A", "8.35"}}, .setting = {0, exact_surface(1.5)}};
  for (const Subject& subject :
       {published_pair(), gaussian(1), gaussian(37.5), gaussian(1e6), relative, part, exact}) {
    const Certified made = certify(subject, usual_width);
    EXPECT_TRUE(made.is_reached) << subject.family;
    EXPECT_EQ(made.curve.trend, Proof::proven) << subject.family;
    EXPECT_EQ(made.curve.non_negative, Proof::proven);
    EXPECT_EQ(made.curve.at_most_one, Proof::proven);
    EXPECT_EQ(reason_to_refuse(made.certificate), "") << subject.family;
  }
}

TEST(Certificate, EveryFitOfTheCatalogue) {
  for (const FittableFamily& family : fittable_families()) {
    for (const double k : family.has_exponent() ? std::vector{1.0, 15.0, 1000.0} : std::vector{0.0}) {
      const Fit fit = family.fit(Setting(k), {});
      const Certified made = certify(subject_of(fit), usual_width);
      EXPECT_TRUE(made.is_reached) << family.info.id << k;
      EXPECT_EQ(reason_to_refuse(made.certificate), "") << family.info.id << k;
      EXPECT_NEAR(made.certificate.upper, fit.max_abs_error.magnitude, 2e-9 * made.certificate.upper);
    }
  }
}

TEST(Certificate, ARelativeErrorHasItsOwnDomain) {
  Subject subject = gaussian(5);
  subject.error = Error::relative;
  const Certificate made = certify(subject, usual_width).certificate;
  EXPECT_NEAR(made.subject.domain.lower, std::exp(-std::log(255) / 5), 1e-15);
  subject.domain = {0, 0.25};
  EXPECT_THROW(certify(subject, usual_width), UserError) << "the target is below 1/255 there";
}

/// Each false statement is refused with its reason.
TEST(Certificate, AFalseOneIsRefused) {
  const Certificate truth = certify(published_pair(), usual_width).certificate;
  const auto expect_refusal = [&](const std::string& reason, const auto& falsify) {
    Certificate wrong = truth;
    falsify(wrong);
    const std::string why = reason_to_refuse(wrong);
    EXPECT_EQ(why.substr(0, reason.size()), reason);
  };
  expect_refusal("the error may exceed the upper bound at c in", [](Certificate& c) {
    c.upper = c.lower = 3.7664127e-3;
    c.places = boxes_of({});
  });
  expect_refusal("the error does not reach the lower bound at its place",
                 [](Certificate& c) { c.lower = c.upper; });
  expect_refusal("its bounds are not an interval", [](Certificate& c) { std::swap(c.lower, c.upper); });
  expect_refusal("the error does not reach the lower bound",
                 [](Certificate& c) { c.attained.distance = 0.25; });
  expect_refusal("the place of its lower bound is outside", [](Certificate& c) {
    c.attained = {Origin::peak, 0.75};
  });
  expect_refusal("it names no place of the largest error", [](Certificate& c) { c.places.clear(); });
  expect_refusal("the error may exceed the lower bound outside of its places", [](Certificate& c) {
    c.places = {{Origin::peak, 0.125, 0.25}};
  });
  expect_refusal("the place c in [", [](Certificate& c) { std::swap(c.places[0].lower, c.places[0].upper); });
  expect_refusal("the place c in [", [](Certificate& c) { c.places[0].upper = 0.75; });
  expect_refusal("the place c in [", [](Certificate& c) { c.places.push_back(c.places[0]); });
  expect_refusal("the boxes in c do not reach from 0x0p+0",
                 [](Certificate& c) { c.horizon.front() = 0x1p-9; });
  expect_refusal("the boxes in 1 - c do not reach", [](Certificate& c) { c.peak.pop_back(); });
  expect_refusal("the boxes in 1 - c do not reach", [](Certificate& c) { c.peak.clear(); });
  expect_refusal("the ends of the boxes in c do not rise",
                 [](Certificate& c) { std::swap(c.horizon[1], c.horizon[2]); });
  expect_refusal("the error may exceed", [](Certificate& c) { c.horizon = {0, 0.5}; });
  expect_refusal("the boxes in c do not reach from 0x1p-3",
                 [](Certificate& c) { c.subject.domain.lower = 0.125; });
  expect_refusal("the domain is not within [0, 1]", [](Certificate& c) { c.subject.domain.upper = 2; });
  expect_refusal("the error", [](Certificate& c) { c.subject.parameters[1].second = "-6.983146"; });
  expect_refusal("parameter b 'b' is not a finite number",
                 [](Certificate& c) { c.subject.parameters[1].second = "b"; });
  expect_refusal("parameter 'b' of fresnel-quadratic is missing",
                 [](Certificate& c) { c.subject.parameters.pop_back(); });
  expect_refusal("parameter 'A' is unknown: fresnel-quadratic has none of that name",
                 [](Certificate& c) { c.subject.parameters[0].first = "A"; });
  expect_refusal("'fresnel' is not a family", [](Certificate& c) { c.subject.family = "fresnel"; });
  expect_refusal("the form 'exp2(a c)' is not the family's", [](Certificate& c) { c.form = "exp2(a c)"; });
  expect_refusal("the target '(1 - c)^4' is not the family's",
                 [](Certificate& c) { c.target = "(1 - c)^4"; });
  expect_refusal("it was made with 9999 bits", [](Certificate& c) { c.precision = 9999; });
  expect_refusal("the form may turn at c in", [](Certificate& c) { c.curve.trend = Trend::falls; });
  expect_refusal("the error", [](Certificate& c) { c.subject.error = Error::relative; });
  expect_refusal("fresnel-quadratic has no exponent", [](Certificate& c) { c.subject.setting.exponent = 5; });
  const auto expect_no_surface = [&](const Surface& surface, const std::string& reason) {
    expect_refusal(reason, [&](Certificate& c) { c.subject.setting.surface = surface; });
  };
  expect_no_surface(exact_surface(-1.5), "the index of refraction is not greater than 0");
  expect_no_surface(exact_surface(-1.5, 2), "the index of refraction is not greater than 0");
  expect_no_surface(exact_surface(1.5, -2), "the extinction is negative");
  expect_no_surface(schlick_surface(1), "the index of refraction is 1 without extinction");
  expect_no_surface(exact_surface(1e17), "the surface reflects all light at normal incidence");
  expect_no_surface(exact_surface(0, 2), "the surface has no index of refraction");
  Surface bright;
  bright.f0 = 1;
  expect_no_surface(bright, "the f0 of the surface is not at least 0 and less than 1");
  bright = schlick_surface(1.5);
  bright.f0 = 0.5;
  expect_no_surface(bright, "a surface with an index of refraction has an f0 of its own");
}

// On [0, 1/1024] the error of the pair rises from 0: one box is bounded at its other end.
TEST(Certificate, BothEndsOfABoxCount) {
  Subject subject = published_pair();
  subject.domain = {0, 0.0009765625};
  Certificate certificate = certify(subject, usual_width).certificate;
  certificate.places = boxes_of(subject.domain);
  EXPECT_EQ(reason_to_refuse(certificate), "");
  certificate.upper = certificate.lower /= 2;
  EXPECT_EQ(reason_to_refuse(certificate).substr(0, 41), "the error may exceed the upper bound at c");
}

TEST(Certificate, ALobeHasNoSurface) {
  Certificate lobe = certify(gaussian(5), 0.1).certificate;
  lobe.subject.setting.surface = exact_surface(1.5);
  EXPECT_EQ(reason_to_refuse(lobe), "sg-offset is not a Fresnel form: it has no surface");
  Subject subject = gaussian(5);
  subject.domain = {0.5, 0.25};
  EXPECT_THROW(certify(subject, 0.1), UserError) << "the same rules hold for what is to be certified";
}

/// Proofs and checks have checkpoints between their boxes.
TEST(Certificate, WorkEndsWhereACheckpointSays) {
  struct Ended {};
  int calls = 0;
  const auto third = [&] {
    if (++calls == 3) throw Ended{};
  };
  EXPECT_THROW(certify(published_pair(), usual_width, third), Ended);
  EXPECT_EQ(calls, 3);
  const Certificate made = certify(published_pair(), usual_width).certificate;
  calls = 0;
  double share = 0;
  EXPECT_THROW(reason_to_refuse(made,
                                [&](double done) {
                                  share = done;
                                  third();
                                }),
               Ended);
  EXPECT_GT(share, 0);
  EXPECT_LT(share, 0.1) << "the third of " << made.horizon.size() + made.peak.size() << " ends of boxes";
}

TEST(Certificate, WhatACurveIsNot) {
  Subject rising = published_pair();
  rising.parameters[0].second = "1";
  rising.parameters[1].second = "0.5";
  const Certified made = certify(rising, usual_width);
  EXPECT_EQ(made.curve.trend, Proof::refuted) << "it falls with the angle";
  EXPECT_EQ(made.curve.at_most_one, Proof::refuted);
  EXPECT_EQ(made.curve.non_negative, Proof::proven);
  EXPECT_EQ(made.certificate.curve.trend, Trend::none);
  EXPECT_EQ(reason_to_refuse(made.certificate), "");
  Certificate wrong = made.certificate;
  wrong.curve.is_at_most_one = true;
  EXPECT_EQ(reason_to_refuse(wrong).substr(0, 21), "the form may exceed 1");
}

/// A decimal is enclosed, not rounded: the certificate of a printed number is about that number.
TEST(Certificate, PrintedNumbersAreNotRounded) {
  Subject rounded = published_pair();
  for (auto& [name, value] : rounded.parameters) value = hex_text(std::stod(value));
  const Certificate a = certify(published_pair(), least_width).certificate,
                    b = certify(rounded, least_width).certificate;
  EXPECT_LT(a.upper, b.lower) << "the nearest doubles have an error larger by 5e-18";
}

TEST(Certificate, HexadecimalTexts) {
  for (const double x : {0.0, 1.0, -5.55473, 0x1p-1074, 1.7976931348623157e308, 0.1})
    EXPECT_EQ(parse_hex(hex_text(x)), x);
  EXPECT_EQ(hex_text(-0.75), "-0x1.8p-1");
  EXPECT_EQ(hex_text(-5e-324), "-0x0.0000000000001p-1022") << "whatever the library makes of a subnormal";
  for (const char* text :
       {"", "0x", "1.8p-1", "0x1.8p-1x", "0xinf", "0xnan", "--0x1p+0", "-0x-1p+0", "0x1p+9999"})
    EXPECT_FALSE(parse_hex(text)) << text;
  // One number has one text: these have too many digits or another spelling.
  for (const char* text : {"0x0.7ffffffffffffffffp+0", "0x1.00000000000001p+0", "0x1.80p-1", "0x3p-2",
                           "0x1.8p-01", "0X1.8p-1", "0x1.8P-1", "0x1.Ap+0", "0x1", "0x1p-9999"})
    EXPECT_FALSE(parse_hex(text)) << text;
}

TEST(Certificate, SubjectsThatAreNone) {
  const auto refusal = [](const Subject& subject, double width = usual_width) {
    return testing::refusal([&] { certify(subject, width); });
  };
  Subject subject = published_pair();
  subject.parameters[1].first = "c";
  EXPECT_EQ(refusal(subject), "parameter 'c' is unknown: fresnel-quadratic has none of that name");
  subject = published_pair();
  subject.parameters.pop_back();
  EXPECT_EQ(refusal(subject), "parameter 'b' of fresnel-quadratic is missing");
  subject.parameters.push_back({"a", "1"});
  EXPECT_EQ(refusal(subject), "parameter 'a' is given twice");
  for (const char* text : {"nan", "inf", "", "x", "1e400"}) {
    subject = published_pair();
    subject.parameters[0].second = text;
    EXPECT_EQ(refusal(subject), "parameter a '" + std::string(text) + "' is not a finite number");
  }
  subject.parameters[0].second = "0x1.80p+0";
  EXPECT_EQ(refusal(subject), "parameter a '0x1.80p+0' is not a hexadecimal double as shadefit prints it");
  for (const double width : {0.0, -1.0, 1e-20, 1.0, std::nan("")})
    EXPECT_NE(refusal(published_pair(), width).find("cannot be reached"), std::string::npos) << width;
}

}  // namespace
}  // namespace shadefit
