#include "reports/certificate_json.hpp"

#include <gtest/gtest.h>

#include <string>

#include "fit/enclosure.hpp"
#include "fit/user_error.hpp"

namespace shadefit {
namespace {

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
    EXPECT_EQ(refusal(text.substr(0, cut)), "certificate 'f' ends early: it is no whole JSON") << cut;
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
  EXPECT_EQ(refusal("a,b\n1,2\n"), "certificate 'f' is no JSON");
  EXPECT_EQ(refusal(""), "certificate 'f' is no JSON");
  EXPECT_EQ(refusal("{\"schema\": 1}"),
            "'f' is not a certificate: its field 'file' does not say 'shadefit certificate'");
  EXPECT_EQ(refusal("[1]"), "'f' is not a certificate: its field 'file' does not say 'shadefit certificate'");
  auto json = write_certificate_json(pair_certificate());
  auto other = json;
  other["schema"] = 2;
  EXPECT_EQ(refusal(other.dump()), "certificate 'f' is of version 2: this shadefit reads version 1");
  other = json;
  other.erase("places");
  EXPECT_EQ(refusal(other.dump()), "certificate 'f': the field 'places' is missing");
  other = json;
  other["domain"] = {0, 1};
  EXPECT_EQ(refusal(other.dump()), "certificate 'f': the field 'domain' is not a text");
  other["domain"] = {"0x0p+0", "1"};
  EXPECT_EQ(refusal(other.dump()),
            "certificate 'f': the field 'domain' holds '1', which is no hexadecimal number");
  other = json;
  other["error"] = "squared";
  EXPECT_EQ(refusal(other.dump()), "certificate 'f': the field 'error' is unknown: 'squared'");
  other = json;
  other["digest"] = "00000000";
  EXPECT_EQ(refusal(other.dump()).substr(0, 23), "its digest is 00000000,");
}

}  // namespace
}  // namespace shadefit
