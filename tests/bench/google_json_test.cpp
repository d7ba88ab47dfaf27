#include "bench/tradeoff/google_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/bench/made_up_trade.hpp"

namespace shadefit::bench {
namespace {

using Json = nlohmann::json;

// The fields that Google Benchmark 1.7 writes, and tools/compare.py (gbench/report.py) reads.
TEST(GoogleJson, HasTheFieldsOfGoogleBenchmark) {
  const Trade trade = testing::made_up_trade();
  const Json json = Json::parse(google_json(trade, {"2012-01-31T12:00:00+00:00", "host", "shadefit"}));
  const Json& context = json.at("context");
  for (const char* field : {"date", "host_name", "executable", "num_cpus", "mhz_per_cpu",
                            "cpu_scaling_enabled", "caches", "load_avg", "library_build_type"})
    EXPECT_TRUE(context.contains(field)) << field;
  EXPECT_EQ(context.at("host_name"), "host");
  EXPECT_EQ(context.at("num_cpus"), 2);
  EXPECT_EQ(context.at("cpu"), "A CPU, made up");

  std::size_t iterations = 0, aggregates = 0;
  std::set<std::string> names;
  for (const Json& row : json.at("benchmarks")) {
    for (const char* field : {"name", "family_index", "per_family_instance_index", "run_name", "run_type",
                              "repetitions", "threads", "iterations", "real_time", "cpu_time", "time_unit"})
      EXPECT_TRUE(row.contains(field)) << row.at("name") << " " << field;
    EXPECT_EQ(row.at("time_unit"), "ns");
    const bool is_aggregate = row.at("run_type") == "aggregate";
    EXPECT_EQ(row.contains("repetition_index"), !is_aggregate);
    EXPECT_EQ(row.contains("aggregate_name"), is_aggregate);
    EXPECT_EQ(row.contains("aggregate_unit"), is_aggregate);
    const auto run_name = row.at("run_name").get<std::string>();
    if (is_aggregate) {
      EXPECT_EQ(row.at("name"), run_name + "_" + row.at("aggregate_name").get<std::string>());
    } else {
      EXPECT_EQ(row.at("name"), run_name);
      names.insert(run_name);
    }
    ++(is_aggregate ? aggregates : iterations);
  }
  const std::size_t count = trade.copies.size() + trade.forms.size();
  EXPECT_EQ(iterations, 2 * count) << "a row for every round";
  EXPECT_EQ(aggregates, 4 * count) << "mean, median, stddev, cv";
  EXPECT_EQ(names.size(), count) << "no two have one name";
}

TEST(GoogleJson, AggregatesAreOfTheRounds) {
  Trade trade;
  trade.forms = {testing::made_up("lobe", "form", 3, forms::Width::avx2, 1, {})};
  trade.forms[0].real = {1, 2, 6};
  trade.forms[0].cpu = {1, 1, 1};
  const Json json = Json::parse(google_json(trade, {}));
  const Json& rows = json.at("benchmarks");
  EXPECT_EQ(rows.at(0).at("name"), "lobe/form/exp2-3/float/AVX2/L1");
  EXPECT_EQ(rows.at(0).at("iterations"), 1);
  EXPECT_EQ(rows.at(2).at("real_time"), 6000);
  EXPECT_EQ(rows.at(2).at("repetition_index"), 2);
  EXPECT_EQ(rows.at(3).at("real_time"), 3000) << "mean";
  EXPECT_EQ(rows.at(4).at("real_time"), 2000) << "median";
  EXPECT_DOUBLE_EQ(rows.at(5).at("real_time"), 1000 * std::sqrt(7.0)) << "stddev: (4 + 1 + 9) / 2";
  EXPECT_DOUBLE_EQ(rows.at(6).at("real_time"), std::sqrt(7.0) / 3) << "cv";
  EXPECT_EQ(rows.at(6).at("aggregate_unit"), "percentage");
  EXPECT_EQ(rows.at(6).at("cpu_time"), 0);
}

TEST(GoogleJson, TheOccasionIsTold) {
  const Occasion occasion = this_occasion();
  EXPECT_EQ(occasion.date.size(), std::string("2012-01-31T12:00:00+00:00").size()) << occasion.date;
  EXPECT_FALSE(occasion.host.empty());
}

}  // namespace
}  // namespace shadefit::bench
