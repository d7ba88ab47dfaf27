#include "bench/device/measure_device.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "bench/forms/forms.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit::device {
namespace {

/// Times in ns, one for each round.
using Rounds = std::vector<double>;

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

  bool is_half() const { return precision == ShaderPrecision::float16; }
};

InPrecision add_all(Programme& programme, const bench::FormsToTime& forms, ShaderPrecision precision) {
  const std::array unit{bench::Range{0, 1}};
  InPrecision all{.precision = precision,
                  .alone = programme.add(chain_alone(), unit, precision),
                  .polynomial = programme.add(bench::multiply_add_chain(), unit, precision)};
  const bench::FormToTime* last = nullptr;
  for (const bench::FormToTime& form : forms.forms) {
    const bool is_timed = last != nullptr && last->target == form.target && last->shape == form.shape;
    all.forms.push_back(is_timed
                            ? all.forms.back()
                            : programme.add(form.function, forms.targets.at(form.target).ranges, precision));
    last = &form;
  }
  return all;
}

/// The times of all dispatches.
class Measured {
 public:
  Measured(const Programme& programme, std::vector<bench::Samples> samples)
      : programme_(programme), samples_(std::move(samples)) {}

  const Rounds& empty() const { return samples_.at(Programme::empty).ns; }

  /// The time of a multiply-add.
  Rounds multiply_add(const InPrecision& one) const {
    Rounds ns = without(step(one.polynomial), step(one.alone));
    for (double& x : ns) x /= forms::MultiplyAdds::count;
    return ns;
  }

  /// The time of an evaluation of a function with so many arguments.
  Rounds evaluation(const InPrecision& one, std::size_t slot, std::size_t arguments) const {
    return without(without(step(slot), step(one.alone)), multiply_add(one),
                   static_cast<double>(arguments - 1));
  }

 private:
  /// ns per element, less the time of the empty kernel.
  Rounds step(std::size_t slot) const {
    Rounds ns = samples_.at(slot).ns;
    const double idle = bench::spread_of(empty()).median;
    for (double& x : ns) x -= idle / static_cast<double>(programme_.elements(slot));
    return ns;
  }

  const Programme& programme_;
  std::vector<bench::Samples> samples_;
};

/// A row with times. `unit` is the time of a multiply-add in float.
bench::TimedForm timed_row(bench::TimedForm row, const Rounds& ns, double unit, bool is_half) {
  row.ns = bench::spread_of(ns);
  row.multiply_adds = row.ns.median / unit;
  row.is_half = is_half;
  return row;
}

}  // namespace

bench::Trade measure_on_device(VulkanDevice& for_times, VulkanDevice& for_values,
                               const bench::FormsToTime& forms, const bench::TimingPlan& plan,
                               const std::function<void(double)>& between) {
  const DeviceInfo info = for_times.info();
  const auto go_on = [&] { between(0); };
  Programme programme(for_times, plan, go_on);
  std::vector<InPrecision> all{add_all(programme, forms, ShaderPrecision::float32)};
  if (info.has_half) all.push_back(add_all(programme, forms, ShaderPrecision::float16));
  for (InPrecision& one : all) one.errors = errors_on_device(for_values, forms, one.precision, go_on);
  const Measured measured(programme, programme.run(between));

  bench::Trade trade{.machine = {bench::this_cpu(), "", info.name, info.driver, name_of_clock(info)},
                     .rounds = plan.rounds,
                     .shows_all_sets = forms.are_of_a_study};
  for (const bench::FormTarget& target : forms.targets) trade.targets.push_back(target.heading);
  const double unit = bench::spread_of(measured.multiply_add(all.front())).median;
  // All times are divided by it. A clock that stands still, or is coarse, gives 0.
  if (!(unit > 0))
    throw CheckFailed(
        fmt::format("the clock of the device is too coarse: a multiply-add takes {:.3g} ns", unit));
  trade.forms.push_back(
      {.form = "empty-dispatch", .label = "empty-dispatch", .ns = bench::spread_of(measured.empty())});
  for (const InPrecision& one : all)
    trade.forms.push_back(timed_row({.form = "multiply-add", .label = "multiply-add"},
                                    measured.multiply_add(one), unit, one.is_half()));
  for (std::size_t i = 0; i < forms.forms.size(); ++i) {
    const bench::FormToTime& form = forms.forms[i];
    for (const InPrecision& one : all) {
      bench::TimedForm row = form.row;
      // An error that is known without a device is that of exact arithmetic: float is close to it, half is
      // not.
      if (one.errors[i] || one.is_half()) row.max_abs_error = one.errors[i];
      trade.forms.push_back(timed_row(
          row, measured.evaluation(one, one.forms[i], form.function.arguments.size()), unit, one.is_half()));
    }
  }
  return trade;
}

}  // namespace shadefit::device
