#include "reports/rows/certificate_json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "fit/proof/curve_proof.hpp"
#include "fit/proof/enclosure.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/digest.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

Certificate pair_certificate() {
  return certify({.family = "fresnel-quadratic", .parameters = {{"a", "-5.55473"}, {"b", "-6.98316"}}},
                 usual_width)
      .certificate;
}

std::string refusal(const std::string& text) {
  try {
    return read_certificate(text, "f").refused;
  } catch (const UserError& error) {
    return error.what();
  }
}

TEST(CertificateJson, ReadsBackWhatItWrites) {
  const Certificate pair = pair_certificate();
  const ReadCertificate read = read_certificate(certificate_text(pair), "f");
  EXPECT_EQ(read.refused, "");
  EXPECT_TRUE(read.certificate == pair);
  const Certificate glass =
      certify(
          {.family = "fresnel-one-term", .parameters = {{"A", "8.35"}}, .setting = {0, exact_surface(1.5)}},
          1e-3)
          .certificate;
  EXPECT_TRUE(read_certificate(certificate_text(glass), "f").certificate == glass);
  const Certificate lobe =
      certify(
          {.family = "sg-offset", .parameters = {{"x", "0.75"}}, .setting = 7.5, .error = Error::relative},
          1e-3)
          .certificate;
  EXPECT_TRUE(read_certificate(certificate_text(lobe), "f").certificate == lobe);
}

/// Wherever a file is cut off, and whatever digit of it changes, it is refused.
TEST(CertificateJson, TruncatedAndChanged) {
  const std::string text = certificate_text(pair_certificate());
  const std::size_t last = text.rfind('}');
  for (std::size_t cut = 1; cut <= last; cut += 1 + text.size() / 50)
    EXPECT_NE(refusal(text.substr(0, cut)).find(": the JSON ends early"), std::string::npos) << cut;
  int changed = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] < '0' || text[i] > '8' || i % 7 != 0) continue;
    std::string wrong = text;
    ++wrong[i];
    EXPECT_NE(refusal(wrong), "") << i;
    ++changed;
  }
  EXPECT_GT(changed, 50);
}

TEST(CertificateJson, AnotherLayoutIsNoChange) {
  const auto json = write_certificate_json(pair_certificate());
  EXPECT_EQ(refusal(json.dump()), "");
  EXPECT_EQ(refusal(json.dump(4)), "");
}

TEST(CertificateJson, WhatIsNoCertificate) {
  for (const auto& [text, fault] : std::vector<std::pair<std::string, std::string>>{
           {"a,b\n1,2\n", ", line 1, column 1: malformed JSON"},
           {"", ", line 1, column 1: the JSON ends early"},
           {"{\"schema\": 1}", ": key 'file' not found"},
           {"[1]", ": cannot use at() with array"},
           {"{\"file\": \"shadefit exhaustive\"}", ": 'file' does not say 'shadefit certificate'"}})
    EXPECT_EQ(refusal(text), "certificate 'f'" + fault);
}

/// Each is one way to say more, less or something else than is checked, under a digest of its own.
TEST(CertificateJson, IsReadStrictly) {
  const Json pair = write_certificate_json(pair_certificate());
  const std::string not_so = " is unknown, or not as shadefit writes it";
  Json places = pair.at("places");
  places[0]["x"] = 1;
  std::vector<std::tuple<std::string, Json, std::string>> cases{
      {"schema", 2, "version 2: this shadefit reads version 1"},
      {"domain", {0, 1}, "type must be string, but is number"},
      {"domain", {"0x0p+0", "1"}, "'1' is not a hexadecimal double as shadefit prints it"},
      {"domain", Json{"0x0p+0"}, "an interval is not a pair"},
      {"error", "squared", "'squared' is unknown"},
      {"proven",
       {"falls with the angle", "rises with the angle"},
       "'proven' says twice how the form goes with the angle"},
      {"proven", {"non-negative", "non-negative"}, "'proven'" + not_so},
      {"proven", {"at most 1", "non-negative"}, "'proven'" + not_so},
      {"proven", "at most 1", "'proven'" + not_so},
      {"x", 1, "'x'" + not_so},
      {"largest",
       {"0x0p+0", "0x0.7ffffffffffffffffp+0"},
       "'0x0.7ffffffffffffffffp+0' is not a hexadecimal double as shadefit prints it"},
      {"exponent", "-0x1p+0", "'exponent'" + not_so},
      {"surface", {{"f0", "0x1p-2"}, {"ior", "0x1.8p+0"}}, "'surface'" + not_so},
      {"surface", {{"formula", "exact"}, {"ior", "0x0p+0"}, {"extinction", "0x0p+0"}}, "'surface'" + not_so},
      {"places", places, "'places'" + not_so}};
  for (const char* key : {"schema", "precision"}) {
    const std::int64_t value = pair.at(key);  // with 2^32 as int it would be right
    for (const Json& other : {Json(value + (std::int64_t{1} << 32)), Json(-value), Json(1.0)})
      cases.emplace_back(key, other, other.dump() + " is not a whole number from 0 to 2147483647");
  }
  for (const auto& [key, value, fault] : cases) {
    Json other = pair;
    other[key] = value;
    other[digest_field] = digest_of(other);
    EXPECT_EQ(refusal(other.dump()), "certificate 'f': " + fault);
  }
  Json other = pair;
  other.erase("places");
  EXPECT_EQ(refusal(other.dump()), "certificate 'f': key 'places' not found");
  other = pair;
  other["digest"] = "00000000";
  EXPECT_EQ(refusal(other.dump()).substr(0, 23), "its digest is 00000000,");
}

TEST(CertificateJson, WhatItsTextMayNotHold) {
  const std::string text = certificate_text(pair_certificate());
  const auto lines = std::to_string(std::count(text.begin(), text.end(), '\n') + 1);
  EXPECT_EQ(refusal(text + std::string("\0junk", 5)),
            "certificate 'f', line " + lines + ", column 1: a byte 0");
  EXPECT_EQ(refusal(text + "junk"), "certificate 'f', line " + lines + ", column 1: malformed JSON");
  const auto with = [&](const std::string& member) { return refusal("{" + member + "," + text.substr(1)); };
  EXPECT_EQ(with("\"schema\": 2"), "certificate 'f': JSON has two members 'schema' in one object");
  EXPECT_EQ(with("\"x\": \"\xFF\""), "certificate 'f', line 1, column 8: malformed JSON");
  // Deep and wide documents are refused as they are read, before anything goes down or through them.
  EXPECT_EQ(with("\"x\": " + std::string(70000, '[') + std::string(70000, ']')),
            "certificate 'f': JSON is deeper than 64 values in each other");
  std::string many;
  for (std::size_t i = 0; i < 100000; ++i) many += "\"" + std::to_string(i) + "\":0,";
  EXPECT_EQ(with(many + "\"x\": 0"), "certificate 'f': JSON has more than 64 members in one object");
}

/// The limit of a file's size holds the largest that a proof can make: boxes with texts of the longest kind.
TEST(CertificateJson, TheLargestCertificateFitsItsFile) {
  Certificate largest = pair_certificate();
  const double longest = -0x1.123456789abcdp-1000;
  largest.horizon.assign(most_boxes + 3 * most_curve_boxes + 2, longest);
  largest.places.assign(most_boxes, {Origin::peak, longest, longest});
  EXPECT_LT(certificate_text(largest).size(), most_certificate_bytes);
}

}  // namespace
}  // namespace shadefit
