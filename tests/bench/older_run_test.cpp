#include "bench/tradeoff/older_run.hpp"

#include <gtest/gtest.h>

#include "bench/tradeoff/google_json.hpp"
#include "tests/bench/made_up_trade.hpp"
#include "tests/refusal.hpp"

namespace shadefit::bench {
namespace {

using testing::made_up_trade;

/// The medians of a trade as its file has them.
Medians written(const Trade& trade) {
  return medians_of(google_json(trade, {}), "old.json");
}

/// A trade whose rounds are its medians, on a machine that takes `factor` as long for everything.
Trade on_machine(double factor) {
  Trade trade = made_up_trade();
  for (auto* rows : {&trade.copies, &trade.forms}) {
    for (TimedForm& timed : *rows) {
      timed.ns.median *= factor;
      timed.real = {timed.ns.median};
    }
  }
  return trade;
}

TEST(OlderRun, ItsMediansAreReadBack) {
  Trade trade = made_up_trade();
  trade.forms[1].real = trade.forms[1].cpu = {5, 2, 3};
  const Medians medians = written(trade);
  EXPECT_EQ(medians.size(), trade.copies.size() + trade.forms.size());
  EXPECT_EQ(medians.at("lobe/pow/float/AVX2/L1"), 3000) << "the unit is a thousand elements";
}

TEST(OlderRun, TheSpeedOfTheMachineCancels) {
  const auto times = times_in_both(on_machine(1), written(on_machine(7)));
  ASSERT_EQ(times.size(), 5U)
      << "pow in AVX2, and cheap and bad: not pow itself, not in memory, not `other`, which "
         "has no reference, and not double, which has none in scalar";
  for (const FormTimes& form : times) {
    EXPECT_EQ(form.reference, "lobe/pow/float/scalar/L1");
    EXPECT_NEAR(form.more(), 0, 1e-15) << form.name;  // a few roundings
  }
  EXPECT_EQ(times[0].name, "lobe/pow/float/AVX2/L1");
  EXPECT_DOUBLE_EQ(times[0].now, 0.1);
  EXPECT_TRUE(slower_forms(times, 1e-6, "old.json").findings.empty());
}

TEST(OlderRun, AFormThatGotSlowerIsFoundOnBothSidesOfTheLimit) {
  Trade now = on_machine(1);
  now.forms[4].ns.median = 0.25;  // cheap in AVX2 took 0.2
  const auto times = times_in_both(now, written(on_machine(7)));
  EXPECT_TRUE(slower_forms(times, 0.26, "old.json").findings.empty());
  const findings::FindingReport report = slower_forms(times, 0.24, "old.json");
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.checked, 5U);
  EXPECT_EQ(
      report.findings[0].message,
      "lobe/cheap/exp2-3/float/AVX2/L1 takes 0.0125 times as long as lobe/pow/float/scalar/L1, and took 0.01 "
      "times as long in 'old.json': 25 % more");
  now.forms[4].ns.median = 0.1;
  EXPECT_TRUE(slower_forms(times_in_both(now, written(on_machine(7))), 0.24, "old.json").findings.empty())
      << "faster is no fault";
}

TEST(OlderRun, FormsOfOneRunAreNotCompared) {
  Trade now = on_machine(1);
  now.forms[4].form = "new";
  EXPECT_EQ(times_in_both(now, written(on_machine(1))).size(), 4U);
  now.forms[0].form = "another reference";
  EXPECT_TRUE(times_in_both(now, written(on_machine(1))).empty());
}

TEST(OlderRun, TimesInMemoryAreNotCompared) {
  Trade now = on_machine(1);
  now.forms.push_back(now.forms[0]);
  now.forms.back().place = DataPlace::memory;  // the reference of `cheap` there
  EXPECT_EQ(times_in_both(now, written(now)).size(), 5U);
}

TEST(OlderRun, AFormOfSeveralConstantsCountsOnce) {
  Trade now = on_machine(1);
  now.forms.insert(now.forms.begin() + 4, now.forms[4]);
  now.forms[4].constants = "others";
  EXPECT_EQ(times_in_both(now, written(on_machine(1))).size(), 5U);
}

TEST(OlderRun, RefusesWhatIsNoSuchFile) {
  const auto refusal_of = [](const std::string& text) {
    return shadefit::testing::refusal([&] { medians_of(text, "old.json"); });
  };
  const std::string begin = "'old.json' is not a file of 'shadefit bench --json': ";
  const std::string median = "a median needs a text 'run_name' and a 'real_time' above 0";
  EXPECT_EQ(refusal_of("[]"), begin + "it has no list 'benchmarks'");
  EXPECT_EQ(refusal_of(R"({"benchmarks": {}})"), begin + "it has no list 'benchmarks'");
  EXPECT_EQ(refusal_of(R"({"benchmarks": [1, {"aggregate_name": "mean"}]})"),
            begin + "it has no median of a form");
  for (const char* row : {R"("run_name": 1, "real_time": 1)", R"("run_name": "a", "real_time": 0)",
                          R"("run_name": "a", "real_time": "1")", R"("run_name": "a")"})
    EXPECT_EQ(refusal_of(R"({"benchmarks": [{"aggregate_name": "median", )" + std::string(row) + "}]}"),
              begin + median);
  EXPECT_NE(refusal_of("{"), "");
}

}  // namespace
}  // namespace shadefit::bench
