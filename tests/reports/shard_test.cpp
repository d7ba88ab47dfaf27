#include "reports/io/shard.hpp"

#include <gtest/gtest.h>

#include "tests/refusal.hpp"

namespace shadefit {
namespace {

using testing::refusal;

TEST(Shard, IsAPartOfAWhole) {
  EXPECT_EQ(parse_shard("2/4"), (Shard{2, 4}));
  EXPECT_EQ(parse_shard("1/1"), Shard{});
  EXPECT_EQ(text_of({2, 4}), "2/4");
  for (const char* text : {"3/2", "0/4", "a/b", "", "/", "1/", "/4", "1/4/2", "-1/4", "1/0", "1 /4", "1/4 ",
                           "+1/4", "1/99999999999"}) {
    EXPECT_EQ(
        refusal([&] { parse_shard(text); }),
        "--shard '" + std::string(text) + "' is not a part of a whole: it must be i/n with 1 <= i <= n");
  }
}

TEST(WorkIdentity, TheFirstDifferenceIsNamed) {
  const WorkIdentity one{{"version", "1"}, {"study", "a 12"}};
  EXPECT_EQ(difference(one, one), "");
  EXPECT_EQ(difference({{"version", "2"}, {"study", "b"}}, one), "another version: 2, not 1");
  EXPECT_EQ(difference({{"version", "1"}, {"study", "a 13"}}, one), "another study: a 13, not a 12");
  EXPECT_EQ(difference({{"version", "1"}}, one), "another study: none, not a 12");
  EXPECT_EQ(difference(one, {{"version", "1"}}), "another study: a 12, not none");
}

}  // namespace
}  // namespace shadefit
