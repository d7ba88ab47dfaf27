#include "bench/device/measure_device.hpp"

#include <fmt/format.h>

#include <utility>

#include "bench/forms/forms.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit::device {
namespace {

/// Times of a chain, one for each round.
using Rounds = std::vector<double>;

/// What has been measured, in ns.
class Measured {
 public:
  Measured(const Programme& programme, std::vector<bench::Samples> samples)
      : programme_(programme), samples_(std::move(samples)) {}

  /// ns per element of that work, less the time of the empty kernel.
  Rounds step(std::size_t slot) const {
    Rounds ns = samples_.at(slot).ns;
    const double idle = bench::spread_of(samples_.at(Programme::empty).ns).median;
    for (double& x : ns) x -= idle / static_cast<double>(programme_.elements(slot));
    return ns;
  }
  const bench::Samples& samples(std::size_t slot) const { return samples_.at(slot); }

 private:
  const Programme& programme_;
  std::vector<bench::Samples> samples_;
};

Rounds without(Rounds a, const Rounds& b, double times = 1) {
  for (std::size_t r = 0; r < a.size(); ++r) a[r] -= times * b[r];
  return a;
}

/// The dispatches of the chain alone and of the multiply-adds, in one precision.
struct Floor {
  Slots alone{}, polynomial{};

  /// The time of a multiply-add in a chain of that kind.
  Rounds multiply_add(const Measured& measured, std::size_t chain) const {
    Rounds ns = without(measured.step(polynomial.at(chain)), measured.step(alone.at(chain)));
    for (double& x : ns) x /= forms::MultiplyAdds::count;
    return ns;
  }

  std::array<Rounds, chains.size()> multiply_adds(const Measured& measured) const {
    return {multiply_add(measured, 0), multiply_add(measured, 1)};
  }

  /// The time of an evaluation of a function with so many arguments. In a dependent chain the multiply-adds
  /// of the other arguments run in parallel with the first, so only the chain itself is subtracted.
  Rounds evaluation(const Measured& measured, const Slots& slots, std::size_t chain,
                    std::size_t arguments) const {
    const Rounds ns = without(measured.step(slots.at(chain)), measured.step(alone.at(chain)));
    if (chains.at(chain) == Chain::dependent) return ns;
    return without(ns, multiply_add(measured, chain), static_cast<double>(arguments - 1));
  }
};

/// The dispatches of one precision: the floor, and each form by its index.
struct InPrecision {
  ShaderPrecision precision;
  Floor floor;
  std::vector<Slots> forms;
  std::vector<std::optional<double>> errors;
  bool is_half() const { return precision == ShaderPrecision::float16; }
};

InPrecision add_all(Programme& programme, const bench::FormsToTime& forms, ShaderPrecision precision) {
  const std::array unit{bench::Range{0, 1}};
  InPrecision all{precision,
                  {programme.add(chain_alone(), unit, precision),
                   programme.add(bench::multiply_add_chain(), unit, precision)},
                  {},
                  {}};
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

using ByChain = std::array<double, chains.size()>;

/// A row with times. `mads` has the time of a multiply-add in float for each chain.
bench::TimedForm timed_row(bench::TimedForm row, const std::array<Rounds, chains.size()>& times,
                           const ByChain& mads, bool is_half) {
  row.ns = bench::spread_of(times[0]);
  const double dependent = bench::spread_of(times[1]).median;
  row.multiply_adds = row.ns.median / mads[0];
  row.is_half = is_half;
  row.dependent_ns = dependent;
  row.dependent_multiply_adds = dependent / mads[1];
  return row;
}

ByChain medians(const std::array<Rounds, chains.size()>& times) {
  return {bench::spread_of(times[0]).median, bench::spread_of(times[1]).median};
}

/// All times are divided by that of a multiply-add. A clock that stands still, or is coarse, gives 0.
void require_above_zero(const ByChain& mads) {
  for (const double ns : mads) {
    if (!(ns > 0))
      throw CheckFailed(
          fmt::format("the clock of the device is too coarse: a multiply-add takes {:.3g} ns", ns));
  }
}

/// The rows without a form: the empty dispatch, and a multiply-add in each precision.
std::vector<bench::TimedForm> floor_rows(const Measured& measured, const std::vector<InPrecision>& all,
                                         const ByChain& mads) {
  std::vector<bench::TimedForm> rows{{.form = "empty-dispatch",
                                      .label = "empty-dispatch",
                                      .ns = bench::spread_of(measured.samples(Programme::empty).ns)}};
  for (const InPrecision& one : all)
    rows.push_back(timed_row({.form = "multiply-add", .label = "multiply-add"},
                             one.floor.multiply_adds(measured), mads, one.is_half()));
  return rows;
}

/// The row of form i in one precision.
bench::TimedForm form_row(const bench::FormToTime& form, std::size_t i, const InPrecision& one,
                          const Measured& measured, const ByChain& mads) {
  const Slots& slots = one.forms.at(i);
  const std::size_t arguments = form.function.arguments.size();
  bench::TimedForm row = form.row;
  // An error that is known without a device is that of exact arithmetic: float is close to it, half is not.
  if (one.errors.at(i) || one.is_half()) row.max_abs_error = one.errors[i];
  return timed_row(row,
                   {one.floor.evaluation(measured, slots, 0, arguments),
                    one.floor.evaluation(measured, slots, 1, arguments)},
                   mads, one.is_half());
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

  bench::Trade trade;
  trade.machine = {bench::this_cpu(), "", info.name, info.driver, name_of_clock(info)};
  trade.rounds = plan.rounds;
  trade.shows_all_sets = forms.are_of_a_study;
  for (const bench::FormTarget& target : forms.targets) trade.targets.push_back(target.heading);
  const ByChain mads = medians(all.front().floor.multiply_adds(measured));
  require_above_zero(mads);
  trade.forms = floor_rows(measured, all, mads);
  for (std::size_t i = 0; i < forms.forms.size(); ++i) {
    for (const InPrecision& one : all)
      trade.forms.push_back(form_row(forms.forms[i], i, one, measured, mads));
  }
  bench::relate(trade);
  return trade;
}

}  // namespace shadefit::device
