#include "bench/tradeoff/report.hpp"

namespace shadefit::bench {
namespace {

std::vector<Cell> bench_row(const TimedForm& timed, const Machine& machine) {
  const bool is_on_cpu = !timed.on_device;
  const DeviceTimes times = timed.on_device.value_or(DeviceTimes());
  return {timed.target,
          timed.form,
          timed.constants,
          static_cast<long>(timed.exp2_degree),
          precision_of(timed),
          is_on_cpu ? std::string(forms::name(timed.width)) : "",
          is_on_cpu ? name(timed.place) : "",
          measured(timed.ns.median),
          measured(timed.ns.width()),
          measured(timed.copies),
          measured(timed.pows),
          measured(timed.max_abs_error),
          machine.cpu,
          machine.compiler,
          machine.device,
          machine.driver,
          machine.clock,
          measured(timed.multiply_adds),
          measured(times.dependent_ns),
          measured(times.dependent_multiply_adds)};
}

}  // namespace

Cell measured(double value) {
  return Number{value, 3};
}

Cell measured(const std::optional<double>& value) {
  return value ? measured(*value) : Cell{};
}

Table bench_table(const Trade& trade) {
  Table table{{"target",
               "form",
               "constants",
               "exp2_degree",
               "precision",
               "width",
               "place",
               "ns_per_element",
               "spread",
               "copies",
               "times_faster_than_pow",
               "max_abs_error",
               "cpu",
               "compiler",
               "device",
               "driver",
               "clock",
               "multiply_adds",
               "dependent_ns",
               "dependent_multiply_adds"},
              {}};
  for (const TimedForm& floor : trade.copies) table.rows.push_back(bench_row(floor, trade.machine));
  for (const TimedForm& timed : trade.forms) table.rows.push_back(bench_row(timed, trade.machine));
  return table;
}

Table front_table(const Trade& trade, const std::string& target) {
  Table table{{"form", "precision", "width", "max abs error", "ns", "spread", "x copy", "x faster than pow",
               "ns in memory", "x copy in memory"},
              {}};
  for (const TimedForm& timed : front_of_target(trade, target)) {
    const TimedForm* far = in_memory(trade, timed);
    table.rows.push_back({timed.label, precision_of(timed), std::string(forms::name(timed.width)),
                          measured(timed.max_abs_error), measured(timed.ns.median),
                          measured(timed.ns.width()), measured(timed.copies), measured(timed.pows),
                          far != nullptr ? measured(far->ns.median) : Cell{},
                          far != nullptr ? measured(far->copies) : Cell{}});
  }
  return table;
}

Table goals_table(const Trade& trade) {
  Table table{{"ratio", "wanted", "reached", "met"}, {}};
  for (const Goal& goal : trade.goals) {
    table.rows.push_back({goal.what,
                          (goal.at_most ? "<= " : ">= ") + text(Number{goal.wanted, 3}, Precision::report),
                          measured(goal.reached),
                          std::string(!goal.reached   ? "not measured"
                                      : goal.is_met() ? "yes"
                                                      : "no")});
  }
  return table;
}

}  // namespace shadefit::bench
