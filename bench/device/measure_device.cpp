#include "bench/device/measure_device.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "bench/device/evaluator.hpp"
#include "fit/scalars/half.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit::device {
namespace {

/// The places, rounded to the precision: so the error is that of the form, not of its argument.
bench::Places held(bench::Places places, ShaderPrecision precision) {
  if (precision == ShaderPrecision::float16) {
    for (std::vector<float>& axis : places) {
      for (float& x : axis) x = static_cast<float>(round_to_half(x));
    }
  }
  return places;
}

/// All arguments of the first place, then those of the second, and so on.
std::vector<float> arguments_of(const bench::Places& places) {
  std::vector<float> arguments;
  for (std::size_t i = 0; i < places.front().size(); ++i) {
    for (const std::vector<float>& axis : places) arguments.push_back(axis[i]);
  }
  return arguments;
}

/// The largest absolute error of each form in one precision. Empty if the target has no truth.
std::vector<std::optional<double>> errors_on_device(VulkanDevice& device, const bench::Trade& trade,
                                                    ShaderPrecision precision,
                                                    const std::function<void()>& between) {
  const ShaderCompiler compiler;
  std::vector<std::optional<double>> errors;
  const bench::TimedTarget* target = nullptr;
  std::vector<double> truth;
  std::vector<float> arguments;
  for (const bench::TimedForm& form : trade.forms) {
    between();
    if (target == nullptr || target->id != form.target) {
      target = &bench::target_of(trade, form);
      truth.clear();
      if (target->truth) {
        const bench::Places places = held(target->places, precision);
        truth = target->truth(places);
        arguments = arguments_of(places);
      }
    }
    if (truth.empty()) {
      errors.emplace_back();
      continue;
    }
    Evaluator evaluator(device, compiler, form.function, precision);
    errors.emplace_back(bench::largest_error(evaluator.of(arguments), truth));
  }
  return errors;
}

Rounds without(Rounds a, const Rounds& b, double times = 1) {
  for (std::size_t r = 0; r < a.size(); ++r) a[r] -= times * b[r];
  return a;
}

/// The slots of one precision: of the chain alone, of the multiply-adds, and of each form by its place.
struct InPrecision {
  ShaderPrecision precision;
  std::size_t alone, polynomial;
  std::vector<std::size_t> forms = {};
  std::vector<std::optional<double>> errors = {};
};

InPrecision add_all(Programme& programme, const bench::Trade& trade, ShaderPrecision precision,
                    const std::function<void()>& between) {
  const std::array unit{bench::Range{0, 1}};
  InPrecision all{.precision = precision,
                  .alone = programme.add(chain_alone(), unit, precision),
                  .polynomial = programme.add(bench::multiply_add_chain(), unit, precision)};
  for (std::size_t i = 0; i < trade.forms.size(); ++i) {
    between();
    const bench::TimedForm& form = trade.forms[i];
    all.forms.push_back(trade.is_timed_before(i)
                            ? all.forms.back()
                            : programme.add(form.function, target_of(trade, form).ranges, precision));
  }
  return all;
}

/// The time of a multiply-add.
Rounds multiply_add(const std::vector<Rounds>& times, const InPrecision& one) {
  Rounds ns = without(times[one.polynomial], times[one.alone]);
  for (double& x : ns) x /= bench::multiply_adds_of_chain;
  return ns;
}

/// The time of an evaluation of a function with so many arguments.
Rounds evaluation(const std::vector<Rounds>& times, const InPrecision& one, std::size_t slot,
                  std::size_t arguments) {
  return without(without(times[slot], times[one.alone]), multiply_add(times, one),
                 static_cast<double>(arguments - 1));
}

/// A row with times. `unit` is the time of a multiply-add in float.
bench::TimedForm timed_row(bench::TimedForm row, const Rounds& ns, double unit, ShaderPrecision precision) {
  row.ns = bench::spread_of(ns);
  row.multiply_adds = row.ns.median / unit;
  row.precision = precision;
  return row;
}

}  // namespace

bench::Trade measure_on_device(VulkanDevice& for_times, VulkanDevice& for_values, bench::Trade trade,
                               const bench::TimingPlan& plan, const std::function<void(double)>& between) {
  const DeviceInfo info = for_times.info();
  const auto go_on = [&] { between(0); };
  Programme programme(for_times);
  std::vector<InPrecision> all{add_all(programme, trade, ShaderPrecision::float32, go_on)};
  if (info.has_half) all.push_back(add_all(programme, trade, ShaderPrecision::float16, go_on));
  for (InPrecision& one : all) one.errors = errors_on_device(for_values, trade, one.precision, go_on);
  const std::vector<Rounds> times = programme.run(plan, between);

  trade.machine = {bench::this_cpu(), "", info.name, info.driver, name_of_clock(info)};
  trade.rounds = plan.rounds;
  const double unit = bench::spread_of(multiply_add(times, all.front())).median;
  // All times are divided by it. A clock that stands still, or is coarse, gives 0.
  if (!(unit > 0))
    throw CheckFailed(
        fmt::format("the clock of the device is too coarse: a multiply-add takes {:.3g} ns", unit));
  std::vector<bench::TimedForm> rows{
      {.form = "empty-dispatch", .label = "empty-dispatch", .ns = bench::spread_of(times.front())}};
  for (const InPrecision& one : all)
    rows.push_back(timed_row({.form = "multiply-add", .label = "multiply-add"}, multiply_add(times, one),
                             unit, one.precision));
  for (std::size_t i = 0; i < trade.forms.size(); ++i) {
    for (const InPrecision& one : all) {
      bench::TimedForm row = trade.forms[i];
      // An error that is known without a device is that of exact arithmetic: float is close to it, half is
      // not.
      if (one.errors[i] || one.precision == ShaderPrecision::float16) row.max_abs_error = one.errors[i];
      const Rounds ns = evaluation(times, one, one.forms[i], row.function.arguments.size());
      rows.push_back(timed_row(std::move(row), ns, unit, one.precision));
    }
  }
  trade.forms = std::move(rows);
  return trade;
}

}  // namespace shadefit::device
