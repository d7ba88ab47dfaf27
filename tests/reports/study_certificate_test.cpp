#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fit/proof/interval_ends.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/studies/study_certificate_json.hpp"
#include "reports/studies/study_proof_rows.hpp"
#include "tests/refusal.hpp"
#include "tests/reports/json_mutants.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;
using testing::expect_has;
using testing::for_each_mutant;
using testing::others_of;
using testing::signed_text;

/// One certificate of each kind: a root at an end and decimals; definitions, given constants and a weight of
/// a relative error; two variables and fitted constants.
std::vector<StudyCertificate> certificates() {
  const std::vector<StudySubject> subjects{
      {{.target = "acos(x)", .form = "sqrt(1-x) (a + b x)", .over = {{"x", "0", "1"}}},
       {{"a", "1.5707963"}, {"b", "-0.156583"}}},
      {{.target = "hg(c, g)",
        .form = "(1 - k^2)/(4 pi (1 - k c)^2)",
        .over = {{"c", "-1", "cos(1/2)"}},
        .definitions = {{"hg", {"c", "g"}, "(1 - g^2)/(4 pi pow(1 + g^2 - 2 g c, 1.5))"}},
        .given = {{"g", "0.5"}},
        .weight = "2 + c",
        .error = Error::relative},
       {{"k", "0x1.66cd66ae39b2cp-1"}}},
      {{.target = "x y", .form = "a + b x + d y", .over = {{"x", "0", "1"}, {"y", "0", "2"}}},
       {{"a", "-0x1p-2"}, {"b", "0x1p-1"}, {"d", "0x1.4p-1"}}},
  };
  std::vector<StudyCertificate> result;
  for (const StudySubject& subject : subjects) result.push_back(certify_study(subject, 1e-3).certificate);
  return result;
}

double value_of(const std::string& text) {
  const auto exact = parse_hex(text);
  return exact ? *exact : std::stod(text);
}

double magnitude_at(const StudyCertificate& certificate, const std::vector<double>& place) {
  const ReadStudy study = read_formulas(certificate.subject.study);
  return std::abs(evaluate<double>(error_formula(study), [&](const std::string& name) {
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (study.axes[i].variable == name) return place[i];
    }
    for (const auto& [parameter, text] : certificate.subject.parameters) {
      if (parameter == name) return value_of(text);
    }
    ADD_FAILURE() << name;
    return 0.0;
  }));
}

/// The first statement of a certificate that is false beyond the rounding of doubles, by samples; empty where
/// none is.
std::string falsehood(const StudyCertificate& certificate) {
  constexpr double rounding = 1e-12;
  const ReadStudy study = read_formulas(certificate.subject.study);
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    if (certificate.ranges.at(i) != Domain{study.axes[i].lower, study.axes[i].upper}) return "the ranges";
  }
  if (certificate.precision > interval_precision()) return "the bits";
  if (!(magnitude_at(certificate, certificate.attained) >= certificate.lower - rounding))
    return "the lower bound";
  constexpr int count = 20;
  for (int i = 0; i <= count; ++i) {
    for (int j = 0; j <= (study.axes.size() == 1 ? 0 : count); ++j) {
      std::vector<double> place;
      for (std::size_t k = 0; k < study.axes.size(); ++k) {
        const auto& [lower, upper] = certificate.ranges[k];
        place.push_back(lower + (upper - lower) * (k == 0 ? i : j) / count);
      }
      if (!(magnitude_at(certificate, place) <= certificate.upper + rounding)) return "the upper bound";
    }
  }
  return "";
}

TEST(StudyCertificate, ReadsBackAsItWasWritten) {
  for (const StudyCertificate& certificate : certificates()) {
    const std::string text = certificate_text(certificate);
    const ReadCertificate read = read_study_certificate(text, "f");
    EXPECT_EQ(read.refused, "");
    EXPECT_EQ(certificate_text(read.certificate), text);
    EXPECT_EQ(reason_to_refuse(read.certificate), "");
    EXPECT_EQ(falsehood(read.certificate), "");
  }
}

/// Each changed certificate with a new digest is refused, or it is true.
TEST(StudyCertificate, NoFalseStatementIsAccepted) {
  int refused = 0, accepted = 0;
  const auto others = [](const Json& value) { return others_of(value, {"y", "acos(x)", "1 - x"}); };
  for (const StudyCertificate& truth : certificates()) {
    const Json json = write_study_certificate_json(truth);
    for_each_mutant(json, others, [&](const Json& mutant, const std::string& where) {
      try {
        const StudyCertificate read = read_study_certificate(signed_text(mutant), "f").certificate;
        if (!reason_to_refuse(read).empty()) {
          ++refused;
          return;
        }
        ++accepted;
        EXPECT_EQ(falsehood(read), "") << where << " " << mutant[Json::json_pointer(where)];
      } catch (const UserError&) {
        ++refused;
      }
    });
  }
  // Looser bounds, finer boxes, spaces in formulas.
  EXPECT_GT(accepted, 20);
  EXPECT_GT(refused, 1000);
}

TEST(StudyCertificate, FindsAccidents) {
  Json json = write_study_certificate_json(certificates().front());
  json["parameters"]["a"] = "1.5707964";
  EXPECT_EQ(read_study_certificate(json.dump(), "f").refused.substr(0, 13), "its digest is");
}

/// Definitions that double each other are refused before they fill the memory.
TEST(StudyCertificate, RefusesFormulasWithoutEnd) {
  StudyCertificate certificate = certificates().front();
  std::vector<StudyDefinition>& definitions = certificate.subject.study.definitions;
  definitions.push_back({"f0", {"t"}, "t + t"});
  for (int i = 1; i < 60; ++i)
    definitions.push_back({"f" + std::to_string(i), {"t"}, "f" + std::to_string(i - 1) + "(t) + t"});
  definitions.push_back({"g", {}, "f59(x)"});
  for (int i = 0; i < 60; ++i) {
    const std::string before = i == 0 ? "g" : "g" + std::to_string(i - 1);
    definitions.push_back({"g" + std::to_string(i), {}, before + " + " + before});
  }
  expect_has(reason_to_refuse(certificate), "no more than 100000 operations");
}

TEST(StudyCertificate, SaysWhatHolds) {
  const std::string text = statement_of(certificates()[1]);
  for (const char* line : {"form     (1 - k^2)/(4 pi (1 - k c)^2)", "with     k = 0.7007",
                           "target   hg(c, g)", "given    g = 0.5", "let      hg(c, g) = (1 - g^2)",
                           "error    relative: (2 + c) (form - target)/target",
                           "range    c from -1 to 0.877582561890372", "largest  at least ", "at       c = "})
    expect_has(text, line);
}

}  // namespace
}  // namespace shadefit
