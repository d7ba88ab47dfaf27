#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "app/commands/command_line.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_refusal;
using testing::TemporaryDirectory;

TEST(BadInput, UnknownIdsSuggestTheNearest) {
  expect_refusal({"fit", "fresnel-quadratc"},
                 "unknown form, constant or study 'fresnel-quadratc': did you mean 'fresnel-quadratic'?");
  expect_refusal({"explain", "sg-offset-men"},
                 "unknown claim, family or study 'sg-offset-men': did you mean 'sg-offset-mean'?");
  expect_refusal({"list", "--verdict", "wrong"},
                 "--verdict 'wrong' is unknown: it must be one of confirmed, rounding, other-objective, "
                 "conditional, refuted");
  expect_refusal({"fit", "half-banding"},
                 "'half-banding' is a claim, not fitted: see 'shadefit explain half-banding'");
  expect_refusal({"run", "--only", "norm-fong"}, "unknown constant 'norm-fong': did you mean 'norm-phong'?");
  expect_refusal(
      {"fit", "norm-phong"},
      "'norm-phong' is a normalisation constant, an integral; it is not fitted: see 'shadefit run --only norm-phong'");
  expect_refusal({"plot"},
                 "unknown command 'plot': it must be one of list, run, fit, better, certify, verify, "
                 "emit, scene, explain, cite, bench, stress, check, lint, help");
  expect_refusal({"fit", "sg\n-offset"},
                 "unknown form, constant or study 'sg\\x0a-offset': did you mean 'sg-offset'?");
  expect_refusal({"chekc"}, "unknown command 'chekc': did you mean 'check'?");
}

TEST(BadInput, Exponents) {
  for (const auto& [text, rule] :
       std::vector<std::pair<std::string, std::string>>{{"0", "not greater than 0"},
                                                        {"-1", "not greater than 0"},
                                                        {"-2.5", "not greater than 0"},
                                                        {"nan", "not a finite number"},
                                                        {"inf", "not a finite number"},
                                                        {"-inf", "not a finite number"},
                                                        {"five", "not a finite number"},
                                                        {"", "not a finite number"},
                                                        {"1e400", "beyond the range of a double"},
                                                        {"1:2", "not a range A:B:STEP"}})
    expect_refusal({"fit", "sg-offset", "--exponent", text},
                   "--exponent '" + text + "' is " + rule + ": give K or A:B:STEP, separated by commas");
  expect_refusal({"fit", "fresnel-quadratic", "--exponent", "5"},
                 "--exponent k: no formula of the study has this name");
  expect_refusal(
      {"fit", "sg-offset-mean"},
      "'sg-offset-mean' is a mean or a limit of fits, no fit: see 'shadefit explain sg-offset-mean'");
  expect_refusal({"fit", "sg-offset", "--measure", "sine"},
                 "--measure 'sine' is unknown: it must be one of cosine, angle, cosine-weighted");
}

TEST(BadInput, Domains) {
  const auto refuse = [](const std::vector<std::string>& domains, const std::string& rule) {
    for (const std::string& domain : domains)
      expect_refusal(domain.starts_with('-')
                         ? std::vector<std::string>{"fit", "sg-offset", "--domain=" + domain}
                         : std::vector<std::string>{"fit", "sg-offset", "--domain", domain},
                     "--domain '" + domain + "' is " + rule);
  };
  refuse({"", "0.5", "0:x", "nan:1", "0:inf", ":1", "0x10:1", "0:1e400"},
         "not a pair A:B of finite numbers, such as 0:1 or cos(60deg):1");
  refuse({"0.5:0.5", "0.75:0.25"}, "empty or reversed: A must be less than B");
  refuse({"0:2", "-1:1", "-1e-320:1", "0:1.0000000000000002"}, "not inside 0:1: A and B are cosines");
  // Every verb has the same rule for the narrowest domain. A domain of that width gives an answer, or a fit
  // that did not converge.
  const std::vector<std::vector<std::string>> verbs{
      {"fit"}, {"better"}, {"certify"}, {"emit", "--lang", "c"}};
  for (std::vector<std::string> call : verbs) {
    call.insert(call.begin() + 1, "fresnel-quadratic");
    call.push_back("--domain");
    const auto on = [&](const char* domain) {
      std::vector<std::string> arguments = call;
      arguments.emplace_back(domain);
      return arguments;
    };
    for (const auto& [domain, width] :
         {std::pair("0.5:0.5000000000000001", "1.11e-16"), {"0:1e-320", "1e-320"}, {"0:9e-11", "9e-11"}})
      expect_refusal(on(domain), std::string("--domain '") + domain + "' is " + width +
                                     " wide: at least 1e-10, a million roundings of a cosine");
    for (const char* domain : {"0:1e-10", "0.5:0.5000000002", "0.9999999998:1"}) {
      // Next to an end `better` searches the basins of all forms for half a minute.
      if (call.front() == "better" && domain != std::string_view("0.5:0.5000000002")) continue;
      const Outcome outcome = run_command_line(on(domain));
      EXPECT_NE(outcome.exit_code, 2) << call.front() << " " << domain << ": " << outcome.err;
      EXPECT_EQ(outcome.err.find("internal error"), std::string::npos) << call.front() << " " << domain;
    }
  }
}

TEST(BadInput, Targets) {
  const std::string unknown = "is unknown: it must be one of schlick, exact; a formula needs a --form";
  for (const auto& [id, option, value, rule] :
       std::vector<std::tuple<std::string, std::string, std::string, std::string>>{
           {"fresnel-quadratic", "--target", "snell", unknown},
           {"sg-offset-limit", "--target", "bogus", unknown},
           {"sg-offset", "--target", "exact", "does not apply: sg-offset is not a Fresnel form"},
           {"sg-offset", "--ior", "1.5", "does not apply: sg-offset is not a Fresnel form"},
           {"phong-blinn", "--ior", "-3", "does not apply: phong-blinn is not a Fresnel form"},
           {"sg-offset", "--extinction", "2", "does not apply: sg-offset is not a Fresnel form"},
           {"sg-offset", "--f0", "0.04", "does not apply: sg-offset is not a Fresnel form"},
           {"fresnel-quadratic", "--extinction", "2", "does not apply: it belongs to --ior"}})
    expect_refusal({"certify", id, option, value}, option + " '" + value + "' " + rule);
  const auto refuse_exact = [](const std::string& option, const std::string& value, const std::string& rule) {
    for (const char* verb : {"fit", "better"})
      expect_refusal({verb, "fresnel-quadratic", "--target", "exact", option, value},
                     option + " '" + value + "' " + rule);
  };
  refuse_exact("--extinction", "-1", "is negative: it must be 0 or more");
  for (const char* text : {"inf", "nan", "0x10", "1e400"}) {
    refuse_exact("--extinction", text, "is not a finite number");
    refuse_exact("--ior", text, "is not a finite number");
  }
  for (const char* ior : {"0", "-1.5", "1"}) {
    const std::string rule = "must be greater than 0, and not 1 without --extinction";
    refuse_exact("--ior", ior, rule);
    expect_refusal({"fit", "fresnel-quadratic", "--target", "schlick", "--ior", ior},
                   "--ior '" + std::string(ior) + "' " + rule);
  }
  for (const char* ior : {"1e+300", "1e+17", "1e-300", "1e-320"})
    refuse_exact("--ior", ior,
                 "reflects all light at normal incidence, to the precision of a double: no reflectance is "
                 "above f0");
}

TEST(BadInput, Objectives) {
  const auto refuse = [](std::vector<std::string> arguments, const std::string& line) {
    arguments.insert(arguments.begin(), {"fit", "fresnel-quadratic"});
    expect_refusal(arguments, line);
  };
  refuse({"--norm", "max"}, "--norm 'max' is unknown: it must be one of least-squares, minimax");
  refuse({"--error", "percent"}, "--error 'percent' is unknown: it must be one of absolute, relative");
  refuse({"--f0", "1"}, "--f0 '1' is not a reflectance at normal incidence: it must be in [0, 1)");
  refuse({"--f0", "nan"}, "--f0 'nan' is not a finite number");
  refuse({"--f0", "0.04", "--ior", "1.5"}, "--f0 '0.04' does not apply: a surface of --ior has its own");
  refuse(
      {"--error", "relative", "--f0", "0"},
      "--error 'relative' divides by zero: with --f0 '0' the reflectance F is 0 at c = 1; end the domain below 1 "
      "or raise f0");
  expect_refusal(
      {"fit", "sg-offset", "--exponent", "100", "--error", "relative", "--domain", "0:0.5"},
      "--error 'relative' has no meaning for sg-offset at exponent 100 on 0:0.5: its target is below "
      "1/255, or that is below any double");
  refuse({"--weight", ""}, "--weight '' is empty: give a formula in c, such as '1 + 4 c'");
  refuse({"--weight", "c - 0.5"},
         "--weight is negative, or has no finite value, at c = 0.0015532579626752298");
  refuse({"--weight", "0"}, "--weight '0' is 0 in the whole range: no error would count");
  refuse({"--weight", std::string(60001, 'c')},
         "--weight: the formula is 60001 characters long: at most 4000");
  refuse({"--weight", "1 + x"},
         "--weight: formula '1 + x': expected one of c, pi, ln2 and the functions, not 'x' at place 5");
}

TEST(BadInput, Constraints) {
  const auto refuse = [](std::vector<std::string> arguments, const std::string& line) {
    arguments.insert(arguments.begin(), {"fit", "fresnel-quadratic", "--norm", "minimax"});
    expect_refusal(arguments, line);
  };
  refuse({"--fix", "b"}, "--fix 'b' is not NAME=VALUE with a finite number");
  refuse({"--fix", "b=inf"}, "--fix 'b=inf' is not NAME=VALUE with a finite number");
  refuse({"--fix", "x=1"}, "--fix 'x': the form has no such parameter");
  refuse({"--fix", "b=1", "--fix", "b=2"}, "--fix 'b': it is given a second time");
  refuse({"--exact-at", "0.5"}, "--exact-at '0.5' is not an end of the range of c");
  refuse({"--one-sided", "left"}, "--one-sided 'left' is unknown: it must be one of above, below");
  refuse({"--at-most", "one"}, "--at-most 'one' is not a finite number");
  refuse({"--at-most", "0.5", "--at-least", "0.75"},
         "the form cannot satisfy the constraints: no parameters keep the form <= 0.5 at c = 0");
  refuse({"--at-most", "0.9"},
         "the form cannot satisfy the constraints: no parameters keep the form <= 0.9 at c = 0");
  refuse({"--exact-at", "1"}, "the form cannot satisfy the constraints: the form cannot be exact at c = 1");
}

// A form that may not exceed its target touches it to the second order at c = 1: fewer places than parameters
// + 1 determine the optimum.
TEST(BadInput, AnOptimumWithoutAnAlternation) {
  const Outcome outcome =
      run_command_line({"fit", "fresnel-square", "--norm", "minimax", "--one-sided", "below", "--json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(outcome.err.starts_with("shadefit: the fit is not-converged: ")) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  const auto parsed = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(parsed["parameters"].is_null());
  EXPECT_TRUE(parsed["level"].is_null());
  EXPECT_FALSE(parsed["why"].is_null());
}

TEST(BadInput, OutputPaths) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("file", "kept");
  for (const std::string& place : {file, file + "/below"})
    expect_refusal({"run", "--out", place},
                   "cannot write to '" + place + "': '" + file + "' is not a directory");
  expect_refusal({"run", "--out", "--no-plots"},
                 "--out '--no-plots' looks like an option: name a value (a path may begin with './')");
  EXPECT_FALSE(std::filesystem::exists("--no-plots"));
  expect_refusal({"run", "--out", ""}, "output directory '' is empty: name a directory");
  EXPECT_EQ(read_file(file), "kept");
}

TEST(BadInput, WhatIsPrintedIsOneLineOfUtf8) {
  const std::string rule = " is not a pair A:B of finite numbers, such as 0:1 or cos(60deg):1";
  const auto expect_printed = [&](const std::string& text, const std::string& printed) {
    expect_refusal({"fit", "sg-offset", "--domain", text}, "--domain '" + printed + "'" + rule);
  };
  expect_printed("na\xC3\xAFve", "na\xC3\xAFve");
  expect_printed("\xFF\xFE", "\\xff\\xfe");
  expect_printed("cut \xE2\x82", "cut \\xe2\\x82");
  expect_printed("\x1B[31m\x7F", "\\x1b[31m\\x7f");
  expect_printed(
      "\xC2\x9B"
      "31m",
      "\\xc2\\x9b"
      "31m");  // U+009B begins a terminal's command as ESC [ does
}

// Every positive number is accepted, however small. The fit then ends with a status, never with a start
// value.
TEST(BadInput, NumbersAtTheEdgeOfADouble) {
  const auto expect_no_answer = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "fit");
    arguments.emplace_back("--json");
    const Outcome outcome = run_command_line(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    const auto parsed = nlohmann::json::parse(outcome.out);
    EXPECT_TRUE(parsed["parameters"].is_null()) << outcome.out;
    EXPECT_TRUE(parsed["rms_error"].is_null()) << outcome.out;
  };
  for (const char* domain : {"0:1e-10", "0:2e-10", "1e-300:1e-10"})
    expect_no_answer({"sg-offset", "--exponent", "5", "--domain", domain});
  // A domain that narrow cannot determine two parameters.
  for (const char* domain : {"0.5:0.5000000001", "0.9999999998:1"})
    expect_no_answer({"fresnel-quadratic", "--domain", domain});
  for (const char* ior : {"1.0000000000000002", "0.9999999999999999"})
    expect_no_answer({"fresnel-one-term", "--target", "exact", "--ior", ior});
  expect_no_answer({"sg-offset", "--exponent", "1e-320"});
  expect_refusal({"fit", "phong-blinn", "--exponent", "1e308"},
                 "--form has a pole, or no finite value, from every start: give another by --start, for "
                 "example --start x=2");
}

// It can determine one: the form must equal the target near c = 1/2, 2^(-A/2) = 2^-5.
TEST(BadInput, TheNarrowestDomainHasAnAnswer) {
  const Outcome outcome =
      run_command_line({"fit", "fresnel-one-term", "--domain", "0.5:0.5000000001", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  // exp2(-A c) = (1 - c)^5 at c = 0.5 for A = 10; across the domain A moves by 9e-10.
  EXPECT_NEAR(nlohmann::json::parse(outcome.out)["parameters"]["A"].get<double>(), 10, 1e-9);
}

// Next to c = 0 the target is exp2(-(5/ln 2) (c + c^2/2 + c^3/3)), and over 0:h the cubic term adds 4/3 h/3
// to the best 1/2.
TEST(BadInput, ADomainNextToZeroDeterminesTwoParameters) {
  const Outcome outcome = run_command_line({"fit", "fresnel-quadratic", "--domain", "0:1e-10", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto parameters = nlohmann::json::parse(outcome.out)["parameters"];
  EXPECT_NEAR(parameters["a"].get<double>(), -5 / std::numbers::ln2 * (0.5 + 4e-10 / 9), 1e-13);
  EXPECT_NEAR(parameters["b"].get<double>(), -5 / std::numbers::ln2, 1e-13);
}

TEST(BadInput, AVeryLongValueIsShortened) {
  const Outcome outcome = run_command_line({"fit", std::string(100000, 'x')});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_LT(outcome.err.size(), 700U);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  std::string accents;
  for (int i = 0; i < 10000; ++i) accents += "\xC3\xA9";
  const std::string shortened = run_command_line({"fit", "sg-offset", "--domain", accents}).err;
  EXPECT_LT(shortened.size(), 1300U);
  EXPECT_EQ(shortened.find("\\x"), std::string::npos) << "no code point was cut in two";
  expect_has(shortened, "\xC3\xA9 .. \xC3\xA9");
}

TEST(BadInput, Usage) {
  const auto see = [](const std::string& help) { return " (see 'shadefit help" + help + "')"; };
  expect_refusal(
      {},
      "name a command: list, run, fit, better, certify, verify, emit, scene, explain, cite, bench, stress, "
      "check, lint, help" +
          see(""));
  expect_refusal({"--verison"}, "unexpected argument '--verison' before a command");
  expect_refusal({"help", "fit", "more"}, "unexpected argument 'more'" + see(" help"));
  expect_refusal({"--completion", "tcsh"},
                 "--completion 'tcsh' is unknown: it must be one of bash, zsh, man");
  expect_refusal(
      {"fit"},
      "fit needs a family, a published constant, a study or --form (see 'shadefit list' and 'shadefit help fit')");
  expect_refusal(
      {"explain"},
      "explain needs CLAIM: a claim (see 'shadefit list'), a constant of one, a family, a study, or a number" +
          see(" explain"));
  expect_refusal({"run", "--outt", "x"}, "unknown option '--outt': did you mean '--out'?" + see(" run"));
  expect_refusal({"run", "--zzzzzz", "x"}, "unknown option '--zzzzzz'" + see(" run"));
  expect_refusal({"list", "nowhere"}, "no id contains 'nowhere': 'shadefit list' prints all ids");
  expect_refusal({"list", "missing.toml"}, "cannot read 'missing.toml': there is no such file");
  expect_refusal({"list", "schlick", "more"}, "unexpected argument 'more'" + see(" list"));
  expect_refusal({"stress", "lobe"}, "unexpected argument 'lobe'" + see(" stress"));
  expect_refusal({"fit", "sg-offset", "--json", "--csv"}, "--json excludes --csv" + see(" fit"));
  expect_refusal({"fit", "sg-offset", "--json", "--latex"}, "--json excludes --latex" + see(" fit"));
  expect_refusal({"fit", "sg-offset", "--csv", "--latex"}, "--csv excludes --latex" + see(" fit"));
  expect_refusal({"list", "--csv", "--json"}, "--json excludes --csv" + see(" list"));
  expect_refusal({"run", "--html", "--only", "acos-linear"}, "--only excludes --html" + see(" run"));
  expect_refusal({"fit", "sg-offset", "--json=3"}, "--json takes no value: '--json=3'");
  // What CLI11 says in its own words.
  for (const std::vector<std::string>& words : {std::vector<std::string>{"run", "--out"},
                                                {"fit", "sg-offset", "--exponent"},
                                                {"fit", "sg-offset", "--exponent", "5", "--exponent", "6"}}) {
    const Outcome outcome = run_command_line(words);
    EXPECT_EQ(outcome.exit_code, 2) << words.back();
    EXPECT_EQ(outcome.out, "") << words.back();
    EXPECT_TRUE(outcome.err.starts_with("shadefit: " + words[words.size() > 2 ? 2 : 1])) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with(see(" " + words.front()) + "\n")) << outcome.err;
  }
}

}  // namespace
}  // namespace shadefit
