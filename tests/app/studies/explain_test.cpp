#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "app/commands/command_line.hpp"
#include "app/lint/lint_command.hpp"
#include "tests/app/refusal.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_lacks;
using testing::expect_refusal;
using testing::json_of;

std::string explained(const std::string& id) {
  const Outcome outcome = run_command_line({"explain", id});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.out;
}

// Every id that lint prints is one that the other commands know.
TEST(Explain, ListKnowsEachIdOfLint) {
  std::set<std::string> listed;
  const auto list = json_of({"list"});
  for (const auto& row : list["constants"]) listed.insert(row["id"].get<std::string>());
  for (const lint::KnownSet& set : known_constants({}).sets) {
    const bool is_family = set.form.empty();  // a family is listed by its claims
    EXPECT_TRUE(listed.contains(set.id) || is_family) << set.id;
  }
}

TEST(Explain, ExactConstantsAndFamilies) {
  EXPECT_TRUE(explained("luma-709").starts_with("luma-709: luminance of linear Rec. 709 and sRGB\n"));
  expect_has(explained("luma-709"), "ITU-R BT.709-6, 2015");
  const std::string family = explained("sg-offset");
  EXPECT_TRUE(family.starts_with("sg-offset: ")) << family;
  for (const char* part : {"\nForm: exp((k + x) (c - 1)); ", "\nsg-offset-mean\n", "\nsg-offset-k5\n"})
    expect_has(family, part);
  EXPECT_GE(json_of({"explain", "sg-offset"})["claims"].size(), 3U);
  expect_refusal({"explain", "luma-708"},
                 "unknown claim, family or study 'luma-708': did you mean 'luma-709'?");
}

TEST(Explain, ANumberNamesTheConstantsThatHaveIt) {
  const std::string pair = explained("5.55473");
  for (const char* part :
       {"fresnel-quadratic ", "the same digits", "\nNext: shadefit explain fresnel-quadratic\n"})
    expect_has(pair, part);
  expect_lacks(pair, "one digit differs");  // another constant has all digits
  expect_has(explained("0.7152"), "luma-709");
  for (const char* part : {"fresnel-quadratic", "one digit differs"}) expect_has(explained("5.55437"), part);
  expect_has(explained("2.2"), "srgb-decode-cubic");
  expect_has(explained("srgb-encode-standard"), "12.92");
  const auto json = json_of({"explain", "5.55473"});
  EXPECT_EQ(json["number"], "5.55473");
  EXPECT_EQ(json["constants"][0]["id"], "fresnel-quadratic");
  expect_refusal({"explain", "123456.789123"},
                 "no published constant that shadefit knows has the number '123456.789123'");
}

}  // namespace
}  // namespace shadefit
