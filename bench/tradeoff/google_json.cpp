#include "bench/tradeoff/google_json.hpp"
#include "reports/io/escape.hpp"

#include <unistd.h>

#include <array>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string_view>

namespace shadefit::bench {
namespace {

using Json = nlohmann::ordered_json;

/// The elements of an iteration, because compare.py prints times as whole numbers.
constexpr int elements_an_iteration = 1000;

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values) {
  if (values.size() < 2) return 0;
  const double mean = mean_of(values);
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

struct Aggregate {
  const char* name;
  const char* unit;
  double (*of)(const std::vector<double>&);
};

constexpr std::array<Aggregate, 4> aggregates{{
    {"mean", "time", mean_of},
    {"median", "time", [](const std::vector<double>& values) { return spread_of(values).median; }},
    {"stddev", "time", deviation_of},
    {"cv", "percentage",
     [](const std::vector<double>& values) { return deviation_of(values) / mean_of(values); }},
}};

void add_rows(Json& rows, const TimedForm& timed, std::size_t family) {
  const std::string name = benchmark_name(timed);
  const std::size_t repetitions = timed.real.size();
  const auto add = [&](const std::string& suffix, const char* type, const Json& of_type, auto iterations,
                       double real, double cpu) {
    Json row{{"name", name + suffix}, {"family_index", family}, {"per_family_instance_index", 0},
             {"run_name", name},      {"run_type", type},       {"repetitions", repetitions}};
    row.update(of_type);
    row.update({{"iterations", iterations}, {"real_time", real}, {"cpu_time", cpu}, {"time_unit", "ns"}});
    rows.push_back(std::move(row));
  };
  for (std::size_t i = 0; i < repetitions; ++i) {
    add("", "iteration", {{"repetition_index", i}, {"threads", 1}}, timed.elements / elements_an_iteration,
        elements_an_iteration * timed.real[i], elements_an_iteration * timed.cpu[i]);
  }
  for (const auto& [aggregate, unit, of] : aggregates) {
    const int factor = unit == std::string_view("time") ? elements_an_iteration : 1;
    add(std::string("_") + aggregate, "aggregate",
        {{"threads", 1}, {"aggregate_name", aggregate}, {"aggregate_unit", unit}}, repetitions,
        factor * of(timed.real), factor * of(timed.cpu));
  }
}

}  // namespace

Occasion this_occasion() {
  const std::time_t seconds = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&seconds, &local);
  std::array<char, 32> date{};
  std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S%z", &local);
  std::string iso = date.data();  // +0100 is +01:00 there
  if (iso.size() > 5) iso.insert(iso.size() - 2, ":");
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return {iso, host.data(), "shadefit"};
}

std::string benchmark_name(const TimedForm& timed) {
  const std::string begin =
      (timed.target.empty() ? "" : timed.target + "/") + full_id(timed) + "/" + precision_of(timed) + "/";
  if (timed.on_device) return begin + "vulkan";
  return begin + std::string(forms::name(timed.width)) + "/" + name(timed.place);
}

std::string google_json(const Trade& trade, const Occasion& occasion) {
  Json rows = Json::array();
  std::size_t family = 0;
  for (const TimedForm& floor : trade.copies) add_rows(rows, floor, family++);
  const TimedForm* last = nullptr;
  for (const TimedForm& timed : trade.forms) {
    // Rows with other constants have the same times.
    const bool is_new = last == nullptr || !is_same_kernel(*last, timed) || last->place != timed.place;
    if (is_new) add_rows(rows, timed, family++);
    last = &timed;
  }
  Json caches = Json::array();
  if (trade.machine.last_cache > 0) {
    caches.push_back(
        {{"type", "Unified"}, {"level", 3}, {"size", trade.machine.last_cache}, {"num_sharing", 0}});
  }
  const Json json{{"context",
                   {{"date", occasion.date},
                    {"host_name", occasion.host},
                    {"executable", occasion.executable},
                    {"num_cpus", trade.machine.threads},
                    {"mhz_per_cpu", 0},
                    {"cpu_scaling_enabled", false},
                    {"caches", caches},
                    {"load_avg", Json::array()},
                    {"library_build_type", "release"},
                    {"cpu", trade.machine.cpu},
                    {"device", trade.machine.device},
                    {"driver", trade.machine.driver},
                    {"compiler", trade.machine.compiler}}},
                  {"benchmarks", rows}};
  return json_text(json);
}

}  // namespace shadefit::bench
