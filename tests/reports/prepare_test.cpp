#include <gtest/gtest.h>

#include <string>

#include "app/commands/command_line.hpp"
#include "fit/support/user_error.hpp"
#include "reports/studies/prepare.hpp"
#include "reports/studies/study_certificate_json.hpp"
#include "tests/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::TemporaryDirectory;

const std::string pair_text = R"toml(schema = 1
id = "the-pair"
[over]
c = "0:1"
[target]
formula = "(1 - c)^5"
[[form]]
id = "pair"
formula = "exp2((a c + b) c)"
)toml";

const std::string lobe_text = R"toml(schema = 1
id = "lobe"
[over]
c = "0:1"
[given]
k = "3,7"
[target]
formula = "c^k"
[[form]]
id = "lobe"
formula = "exp((k + x) (c - 1))"
)toml";

std::string refusal_of(const std::string& text) {
  return testing::refusal([&] { prepare(text); });
}

/// What the command prints for a study in a file.
std::string said_by_command(const std::vector<std::string>& arguments) {
  const Outcome outcome = run_command_line(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.out;
}

std::string with_part(std::string text, const std::string& part, const std::string& by) {
  return text.replace(text.find(part), part.size(), by);
}

TEST(Prepare, SaysWhatTheCommandSays) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("the-pair.toml", pair_text);
  Prepared pair = prepare(pair_text);
  const StudyFit fit = pair.fit();
  EXPECT_EQ(fit.status, Status::converged);
  EXPECT_EQ(fit.names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(fit.digits, 14);
  EXPECT_NEAR(fit.parameters[0], -5.554727813, 1e-9);
  EXPECT_GT(fit.max_abs_error.magnitude, 0);

  const std::string said = said_by_command({"emit", file, "--lang", "hlsl"});
  const std::string facts = said.substr(said.find("//\n") + 3);
  EXPECT_EQ(pair.emit(Language::hlsl), facts);
  EXPECT_NE(facts.find("(fitted: least squares)"), facts.npos) << facts;
  const std::string half = said_by_command(
      {"emit", file, "--lang", "glsl", "--precision", "half", "--parameters", "a=-5.55473,b=-6.98316"});
  EXPECT_EQ(pair.emit(Language::glsl, {{"a", "-5.55473"}, {"b", "-6.98316"}}, ShaderPrecision::float16),
            half.substr(half.find("//\n") + 3));
}

TEST(Prepare, ItsCertificateHolds) {
  const TemporaryDirectory directory;
  Prepared pair = prepare(pair_text);
  const Constants published{{"b", "-6.98316"}, {"a", "-5.55473"}};
  for (const Constants& constants : {Constants{}, published}) {
    const CertifiedError proof = pair.certify(constants);
    EXPECT_TRUE(proof.is_reached);
    EXPECT_LT(proof.lower, proof.upper);
    EXPECT_NEAR(proof.upper, 0.003766, 1e-6);
    EXPECT_EQ(said_by_command({"verify", directory.file("a.json", proof.certificate)}).substr(0, 12),
              "certificate ");
  }
  EXPECT_THROW(pair.certify({{"a", "1"}}), UserError);
  EXPECT_THROW(pair.emit(Language::glsl, {{"a", "1"}, {"b", "x"}}), UserError);
}

TEST(Prepare, StartsLeadDownTheirBasins) {
  Prepared pair = prepare(pair_text);
  const StudyFit found = pair.fit({{-5, -7}});
  EXPECT_EQ(found.digits, 14);
  Prepared copy = pair;
  EXPECT_EQ(copy.fit({{-5, -7}, {-6, -6}}).parameters, found.parameters);
  EXPECT_NEAR(pair.fit().parameters[1], found.parameters[1], 1e-13);
  Prepared minimax = prepare(pair_text + "[metric]\nnorm = \"minimax\"\n");
  EXPECT_THROW(minimax.fit({{-5, -7}}), UserError);
  EXPECT_LT(minimax.fit().level.value(), 0.0037);
}

TEST(Prepare, AGivenConstantHasOneValue) {
  Prepared lobe = prepare(with_part(lobe_text, "3,7", "7"));
  EXPECT_EQ(lobe.fit().status, Status::converged);
  expect_has(lobe.emit(Language::c), "static inline float lobe(float c)");
  EXPECT_EQ(refusal_of(lobe_text), "study 'lobe': its given constants have 2 values: leave one of each");
}

TEST(Prepare, AFaultHasItsLine) {
  EXPECT_EQ(refusal_of("schema = 2"), "study 'text', line 1: the key 'schema' must be 1");
  EXPECT_EQ(refusal_of(with_part(pair_text, "exp2(", "exp3(")).substr(0, 32),
            "study 'the-pair', line 9: form: ");
  EXPECT_EQ(refusal_of(with_part(pair_text, "formula", "table")),
            "study 'the-pair': it has a table, which a text has no folder for");
  Prepared flat = prepare(with_part(pair_text, "(a c + b) c", "(a + b) c"));
  EXPECT_EQ(flat.fit().status, Status::degenerate);
  EXPECT_THROW(flat.certify(), UserError);
}

}  // namespace
}  // namespace shadefit
