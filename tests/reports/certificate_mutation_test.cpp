#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "fit/proof/interval_ends.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "reports/rows/certificate_json.hpp"
#include "tests/reports/json_mutants.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::for_each_mutant;
using testing::signed_text;
using testing::TemporaryDirectory;
using Json = nlohmann::ordered_json;

/// Certificates of every family, every kind of target and error.
std::vector<Subject> certified_subjects() {
  const auto lobe = [](const char* family, std::vector<std::pair<std::string, std::string>> parameters,
                       double exponent, Error error = Error::absolute) {
    return Subject{family, std::move(parameters), exponent, error, {}};
  };
  const auto fresnel = [](const char* family, std::vector<std::pair<std::string, std::string>> parameters,
                          const Surface& surface = {}, Error error = Error::absolute, Domain domain = {}) {
    return Subject{family, std::move(parameters), {0, surface}, error, domain};
  };
  Surface any;
  any.f0 = 0.25;
  const std::vector<std::pair<std::string, std::string>> pair{{"a", "-5.55473"}, {"b", "-6.98316"}};
  return {
      lobe("sg-offset", {{"x", "0.788"}}, 5),
      lobe("sg-offset", {{"x", "0x1.8p-1"}}, 37.5, Error::relative),
      lobe("sg-offset", {{"x", "0.25"}}, 0.5),
      lobe("phong-blinn", {{"x", "0x1.1412ab55349fap+2"}}, 5),
      lobe("sg-scaled", {{"A", "0x1.0c1a98e3a849fp+0"}, {"x", "0.5"}}, 5),
      fresnel("fresnel-quadratic", pair),
      fresnel("fresnel-quadratic", pair, any, Error::relative),
      fresnel("fresnel-quadratic", pair, exact_surface(0.6667)),
      fresnel("fresnel-quadratic", pair, exact_surface(0.25, 3.5), Error::relative),
      fresnel("fresnel-one-term", {{"A", "8.35"}}, exact_surface(1.5)),
      fresnel(
          "fresnel-cubic",
          {{"a", "-0x1.6129b66fcbd1p+2"}, {"b", "-0x1.58644bc7daaf8p+1"}, {"d", "-0x1.d1cc69e9c9c99p+2"}}),
      fresnel("fresnel-quartic", {{"a", "-0x1.af43f25b74f6ep+2"},
                                  {"b", "0x1.8f67217b7a49ep-3"},
                                  {"d", "-0x1.0389d83629f51p+2"},
                                  {"g", "-0x1.cc43ddf0fa925p+2"}}),
      fresnel("fresnel-fourth", {{"s", "0.9"}}, schlick_surface(1.5), Error::relative),
      fresnel("fresnel-square", {{"a", "0x1.1999999999999p+1"}, {"b", "-0x1.6eeeeeeeeeeefp+1"}}),
      fresnel("fresnel-rational", {{"a", "1.27"}}, schlick_surface(1.33), Error::absolute, {0.25, 0.75}),
  };
}

/// Relative, of the bounds: few boxes.
constexpr double wide = 0.1;

std::string label(const Certificate& certificate) {
  return certificate.subject.family + " at " + to_text(certificate.subject.domain);
}

// An oracle for certificates in plain doubles, without boxes and intervals.

double value_of(const std::string& text) {
  const auto exact = parse_hex(text);
  return exact ? *exact : parse_number(text).value();
}

double form_at(const Subject& subject, double c) {
  return evaluate<double>(find_family(subject.family)->form(), [&](const std::string& variable) {
    for (const auto& [name, text] : subject.parameters) {
      if (name == variable) return value_of(text);
    }
    return variable == "k" ? subject.setting.exponent : c;
  });
}

double error_at(const Subject& subject, double c) {
  const Surface& surface = subject.setting.surface;
  const bool is_fresnel = find_family(subject.family)->is_fresnel();
  const double target = is_fresnel ? target_weight(surface, c) : std::pow(c, subject.setting.exponent);
  const double difference = form_at(subject, c) - target;
  if (!is_fresnel) return subject.error == Error::absolute ? difference : difference / target;
  const double f0 = normal_reflectance<double>(surface);
  if (subject.error == Error::relative) return (1 - f0) * difference / (f0 + (1 - f0) * target);
  return surface.is_named() ? (1 - f0) * difference : difference;
}

double cosine_of(Origin side, double distance) {
  return side == Origin::horizon ? distance : 1 - distance;
}

/// The cosines that the oracle looks at.
std::vector<double> samples_of(const Certificate& certificate) {
  const Domain& domain = certificate.subject.domain;
  constexpr int count = 500;
  std::vector<double> samples;
  for (int i = 0; i <= count; ++i)
    samples.push_back(domain.lower + (domain.upper - domain.lower) * i / count);
  for (const Box& place : certificate.places) {
    samples.push_back(cosine_of(place.side, place.lower));
    samples.push_back(cosine_of(place.side, place.upper));
  }
  std::sort(samples.begin(), samples.end());
  return samples;
}

/// The first statement of a certificate that is false beyond the rounding of doubles; empty where none is.
/// It finds only false statements. A looser bound, another end of a box within the domain, fewer statements
/// or fewer bits leave a certificate true.
std::string falsehood(const Certificate& certificate) {
  const Subject& subject = certificate.subject;
  const Domain& domain = subject.domain;
  const FittableFamily* family = find_family(subject.family);
  if (family == nullptr || certificate.form != to_text(family->form())) return "the form";
  if (!(0 <= domain.lower && domain.lower < domain.upper && domain.upper <= 1)) return "the domain";
  if (certificate.precision > interval_precision()) return "the bits";
  const double at = cosine_of(certificate.attained.side, certificate.attained.distance);
  if (!(domain.lower <= at && at <= domain.upper)) return "where it is attained";
  // Errors of the formulas in doubles: some 1e-15 of values up to 1, a few more relative to a small target.
  // At its critical angle a reflectance falls like a square root, which makes 1e-8 of a rounding of the
  // cosine.
  const double scale = critical_cosine(subject.setting.surface) ? 1e-7
                       : subject.error == Error::relative       ? 1e-10
                                                                : 1e-13;
  const auto exceeds = [&](double x, double bound) {
    return !(x <= bound + scale + 1e-12 * std::abs(bound));
  };
  if (exceeds(certificate.lower, std::abs(error_at(subject, at)))) return "the lower bound";
  const auto is_in_places = [&](double c) {
    return std::any_of(certificate.places.begin(), certificate.places.end(), [&](const Box& place) {
      const double a = cosine_of(place.side, place.lower), b = cosine_of(place.side, place.upper);
      return std::min(a, b) <= c && c <= std::max(a, b);
    });
  };
  double before = std::nan("");
  for (const double c : samples_of(certificate)) {
    const double error = std::abs(error_at(subject, c)), form = form_at(subject, c);
    if (exceeds(error, certificate.upper)) return "the upper bound";
    if (!is_in_places(c) && exceeds(error, certificate.lower)) return "the places";
    if (certificate.curve.is_non_negative && exceeds(-form, 0)) return "non-negative";
    if (certificate.curve.is_at_most_one && exceeds(form, 1)) return "at most 1";
    // With the cosine a form rises where it falls with the angle.
    if (certificate.curve.trend == Trend::falls && before > form + scale) return "falls";
    if (certificate.curve.trend == Trend::rises && before < form - scale) return "rises";
    before = form;
  }
  return "";
}

/// Other values of a certificate of a family.
std::vector<Json> others_of_family(const Json& value) {
  std::vector<std::string> words{
      "exact",     "schlick",   "1 - c", "falls with the angle", "rises with the angle", "non-negative",
      "at most 1", "(1 - c)^5", "c^k"};
  for (const FittableFamily& family : fittable_families().first(3)) {
    words.emplace_back(family.info.id);
    words.push_back(to_text(family.form()));
  }
  std::vector<Json> others = testing::others_of(value, words);
  if (!value.is_null()) return others;
  others.push_back({{"f0", "0x1p-2"}});
  for (const char* formula : {"schlick", "exact"})
    others.push_back({{"formula", formula}, {"ior", "0x1.8p+0"}, {"extinction", "0x0p+0"}});
  return others;
}

/// Each changed certificate with a new digest is refused, or it is true.
TEST(CertificateMutation, NoFalseStatementIsAccepted) {
  int refused = 0, accepted = 0;
  for (const Subject& subject : certified_subjects()) {
    const Certificate truth = certify(subject, wide).certificate;
    const Json json = write_certificate_json(truth);
    ASSERT_EQ(falsehood(truth), "") << label(truth);
    ASSERT_EQ(reason_to_refuse(truth), "") << label(truth);
    for_each_mutant(json, others_of_family, [&](const Json& mutant, const std::string& where) {
      try {
        const Certificate read = read_certificate(signed_text(mutant), "f").certificate;
        if (reason_to_refuse(read).empty()) {
          ++accepted;
          EXPECT_EQ(falsehood(read), "")
              << label(truth) << " " << where << " " << mutant[Json::json_pointer(where)];
          EXPECT_EQ(certificate_text(read), Json::parse(signed_text(mutant)).dump(1) + "\n") << where;
        } else {
          ++refused;
        }
      } catch (const UserError&) {
        ++refused;
      }
    });
  }
  // Looser bounds, other ends of boxes, fewer statements.
  EXPECT_GT(accepted, 100);
  EXPECT_GT(refused, 5000);
}

/// Certificates that are clearly false in the parts that a verifier computes.
std::vector<Certificate> false_ones(const Certificate& truth) {
  std::vector<Certificate> candidates;
  const auto add = [&](const auto& falsify) { falsify(candidates.emplace_back(truth)); };
  add([&](Certificate& c) {
    c.upper = 0.99 * truth.lower;
    c.lower = 0;
    c.places = boxes_of(truth.subject.domain);
  });
  add([&](Certificate& c) {
    c.lower = 1.01 * truth.upper;
    c.upper = 2 * truth.upper;
  });
  add([&](Certificate& c) {
    c.lower = 0.5 * truth.lower;
    c.places = {{truth.attained.side, truth.attained.distance, truth.attained.distance}};
  });
  add([&](Certificate& c) {
    auto& text = c.subject.parameters.front().second;
    text = hex_text(1.25 * value_of(text));
  });
  add([](Certificate& c) { c.curve.trend = c.curve.trend == Trend::falls ? Trend::rises : Trend::falls; });
  add([](Certificate& c) {
    c.subject.error = c.subject.error == Error::absolute ? Error::relative : Error::absolute;
  });
  std::erase_if(candidates, [](const Certificate& c) { return falsehood(c).empty(); });
  return candidates;
}

/// The lines that tests/verifier/verify_certificate.py prints of files.
std::vector<std::string> second_verdicts(const TemporaryDirectory& directory,
                                         const std::vector<std::string>& names) {
  std::string command = SHADEFIT_PYTHON " " SHADEFIT_SOURCE_DIR "/tests/verifier/verify_certificate.py";
  for (const std::string& name : names) command += " " + name;
  const std::string said = directory / "said";
  const int status =
      std::system(("cd " + directory.path().string() + " && " + command + " >" + said + " 2>&1").c_str());
  EXPECT_NE(status, -1);
  std::vector<std::string> lines;
  const std::string text = read_file(said);
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1)
    lines.push_back(text.substr(begin, text.find('\n', begin) - begin));
  return lines;
}

/// A verifier in another language and library, which parses the formulas' texts, agrees.
TEST(SecondVerifier, AgreesOnWhatHoldsAndOnWhatDoesNot) {
  const TemporaryDirectory directory;
  std::vector<std::string> names;
  std::vector<bool> holds;
  const auto add = [&](const Certificate& certificate) {
    names.push_back(std::to_string(names.size()) + ".json");
    directory.file(names.back(), certificate_text(certificate));
    holds.push_back(reason_to_refuse(certificate).empty());
  };
  for (const Subject& subject : certified_subjects()) {
    const Certificate truth = certify(subject, wide).certificate;
    add(truth);
    EXPECT_TRUE(holds.back()) << label(truth);
    for (const Certificate& wrong : false_ones(truth)) {
      add(wrong);
      EXPECT_FALSE(holds.back()) << label(truth);
    }
  }
  EXPECT_GT(names.size(), 4 * certified_subjects().size());
  const auto verdicts = second_verdicts(directory, names);
  ASSERT_EQ(verdicts.size(), names.size()) << (verdicts.empty() ? "" : verdicts.back());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string expected = names[i] + (holds[i] ? " holds" : " is refused: ");
    EXPECT_EQ(verdicts[i].substr(0, expected.size()), expected)
        << read_file(directory / names[i]).substr(0, 400);
  }
}

}  // namespace
}  // namespace shadefit
