#include "bench/tradeoff/report.hpp"

#include <utility>

namespace shadefit::bench {
namespace {

/// The columns of bench.csv, each with its cell in the row of a form.
std::vector<std::pair<const char*, Cell>> bench_cells(const TimedForm& timed, const Machine& machine) {
  const bool is_on_cpu = !timed.on_device;
  const DeviceTimes times = timed.on_device.value_or(DeviceTimes());
  return {{"target", timed.target},
          {"form", timed.form},
          {"constants", timed.constants},
          {"exp2_degree", static_cast<long>(timed.exp2_degree)},
          {"precision", precision_of(timed)},
          {"width", is_on_cpu ? std::string(forms::name(timed.width)) : ""},
          {"place", is_on_cpu ? name(timed.place) : ""},
          {"ns_per_element", measured(timed.ns.median)},
          {"spread", measured(timed.ns.width())},
          {"copies", measured(timed.copies)},
          {"times_faster_than_pow", measured(timed.pows)},
          {"max_abs_error", measured(timed.max_abs_error)},
          {"cpu", machine.cpu},
          {"compiler", machine.compiler},
          {"device", machine.device},
          {"driver", machine.driver},
          {"clock", machine.clock},
          {"multiply_adds", measured(timed.multiply_adds)},
          {"dependent_ns", measured(times.dependent_ns)},
          {"dependent_multiply_adds", measured(times.dependent_multiply_adds)}};
}

}  // namespace

Cell measured(double value) {
  return Number{value, 3};
}

Cell measured(const std::optional<double>& value) {
  return value ? measured(*value) : Cell{};
}

Table bench_table(const Trade& trade) {
  Table table;
  for (const auto& [column, ignored] : bench_cells({}, trade.machine)) table.columns.emplace_back(column);
  for (const auto* forms : {&trade.copies, &trade.forms}) {
    for (const TimedForm& timed : *forms) {
      auto& row = table.rows.emplace_back();
      for (const auto& [ignored, cell] : bench_cells(timed, trade.machine)) row.push_back(cell);
    }
  }
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
