#include "bench/tradeoff/older_run.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "bench/tradeoff/google_json.hpp"
#include "fit/support/json_document.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit::bench {

Medians medians_of(std::string_view text, const std::string& file) {
  const nlohmann::json json = parse_json(text, file, [](std::string_view key) {
    return key == "benchmarks" || key == "run_name" || key == "aggregate_name" || key == "real_time";
  });
  const auto refuse = [&](const char* rule) {
    throw UserError(fmt::format("'{}' is not a file of 'shadefit bench --json': {}", file, rule));
  };
  if (!json.is_object() || !json.contains("benchmarks") || !json["benchmarks"].is_array())
    refuse("it has no list 'benchmarks'");
  Medians medians;
  for (const nlohmann::json& row : json["benchmarks"]) {
    if (!row.is_object() || row.value("aggregate_name", nlohmann::json()) != "median") continue;
    const nlohmann::json name = row.value("run_name", nlohmann::json());
    const nlohmann::json time = row.value("real_time", nlohmann::json());
    if (!name.is_string() || !time.is_number() || !(time.get<double>() > 0))
      refuse("a median needs a text 'run_name' and a 'real_time' above 0");
    medians.emplace(name.get<std::string>(), time.get<double>());
  }
  if (medians.empty()) refuse("it has no median of a form");
  return medians;
}

std::vector<FormTimes> times_in_both(const Trade& now, const Medians& before) {
  std::vector<FormTimes> times;
  std::set<std::string> seen;  // rows with other constants have the same times
  for (const TimedForm& timed : now.forms) {
    if (timed.place != DataPlace::first_cache) continue;
    const TimedForm* reference = reference_of(now, timed);
    const std::string name = benchmark_name(timed);
    if (reference == nullptr || reference == &timed || !seen.insert(name).second) continue;
    const std::string unit = benchmark_name(*reference);
    const auto old_time = before.find(name), old_unit = before.find(unit);
    if (name == unit || old_time == before.end() || old_unit == before.end()) continue;
    times.push_back(
        {name, unit, old_time->second / old_unit->second, timed.ns.median / reference->ns.median});
  }
  return times;
}

findings::FindingReport slower_forms(const std::vector<FormTimes>& forms, double share,
                                     const std::string& file) {
  findings::FindingReport report{
      "bench",
      {{"slower-form", "A form takes longer than in the older run",
        "Its time is divided by that of the reference of its target in the same run. Measure again on a quiet "
        "machine before you believe it."}},
      {},
      forms.size(),
      "forms"};
  for (const FormTimes& form : forms) {
    if (!(form.more() > share)) continue;
    const std::string& rule = report.rules.front().id;
    report.findings.push_back(
        {.rule = rule,
         .message = fmt::format("{} takes {:.4g} times as long as {}, and took {:.4g} times as long in '{}': "
                                "{:.3g} % more",
                                form.name, form.now, form.reference, form.before, file, 100 * form.more()),
         .fingerprint = fmt::format("{} {}", rule, form.name)});
  }
  return report;
}

}  // namespace shadefit::bench
