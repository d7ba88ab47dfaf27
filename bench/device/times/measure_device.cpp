#include "bench/device/times/measure_device.hpp"

#include <algorithm>
#include <bit>
#include <deque>
#include <string_view>

#include "bench/device/device_clock.hpp"
#include "bench/device/spirv.hpp"
#include "bench/device/times/device_errors.hpp"
#include "bench/device/vulkan_device.hpp"
#include "bench/forms/forms.hpp"

namespace shadefit::device {

std::uint32_t turns_that_take(double seconds, std::uint32_t most,
                              const std::function<double(std::uint32_t)>& run) {
  for (std::uint32_t turns = 1;; turns *= 2) {
    if (run(turns) >= seconds || turns > most / 2) return turns;
  }
}

namespace {

/// Enough for every place in which a device can run a thread: a large GPU runs 270 000 at once. A CPU runs a
/// few dozen, and with fewer threads the turns are more and their loop is warm.
std::uint32_t threads_of(const DeviceInfo& info) {
  return is_the_cpu(info) ? 1U << 13 : 1U << 18;
}

/// A shader on the device with what a dispatch of it does, timed by the device.
class Timed {
 public:
  Timed(VulkanDevice& device, double& clock, const std::vector<std::uint32_t>& spirv, std::uint32_t threads)
      : device_(&device), clock_(&clock), program_(device.load(spirv)), threads_(threads) {}

  double run(std::uint32_t count, std::uint32_t second) const {
    return seconds_of_dispatch(device_->info(), [&] {
      return device_->run(program_, threads_, {count, second});
    });
  }
  /// The work of one dispatch with these push words.
  bench::Work work(std::uint32_t count, std::uint32_t second, std::size_t elements) const {
    return {[*this, count, second] { *clock_ += run(count, second); }, elements, false};
  }

 private:
  VulkanDevice* device_;
  double* clock_;
  Program program_;
  std::uint32_t threads_;
};

constexpr std::array chains{Chain::independent, Chain::dependent};

/// Where the times of a function are: by chain.
using Slots = std::array<std::size_t, chains.size()>;

/// All that is timed on a device.
class Programme {
 public:
  Programme(VulkanDevice& device, const DevicePlan& plan, const std::function<void()>& between)
      : device_(device), plan_(plan), between_(between), threads_(threads_of(device.info())) {
    const auto factor = std::bit_cast<std::uint32_t>(chain_factor);
    copy = work.size();
    add_copy();
    empty = work.size();
    const Timed idle = timed(timing_shader(chain_alone(), unit, ShaderPrecision::float32, Chain::dependent),
                             ShaderPrecision::float32);
    idle.run(0, factor);
    work.push_back(idle.work(0, factor, 1));
  }
  Programme(const Programme&) = delete;
  Programme& operator=(const Programme&) = delete;

  static constexpr std::array unit{Range{0, 1}};

  Slots add(const ShaderFunction& function, std::span<const Range> ranges, ShaderPrecision precision) {
    const Slots slots{work.size(), work.size() + 1};
    for (const Chain chain : chains) {
      between_();
      add(timed(timing_shader(function, ranges, precision, chain), precision));
    }
    return slots;
  }

  std::vector<bench::Samples> run(const std::function<void(double)>& between) const {
    const auto clock = [&] { return bench::Instant{seconds_, bench::now().cpu}; };
    return bench::time_interleaved(work, plan_.timing, clock, between);
  }

  std::vector<bench::Work> work;
  std::size_t copy = 0, empty = 0;

 private:
  Timed timed(const std::string& shader, ShaderPrecision precision) {
    auto spirv = compiler_.spirv(shader, ShaderLanguage::glsl);
    if (precision == ShaderPrecision::float16) spirv = with_halves(spirv);
    return {device_, seconds_, spirv, threads_};
  }

  void add(const Timed& shader) {
    constexpr std::uint32_t most = 1U << 24;  // a device that runs them in a millisecond does not exist
    const auto factor = std::bit_cast<std::uint32_t>(chain_factor);
    shader.run(1, factor);  // some drivers compile a shader when it runs first
    const std::uint32_t turns = turns_that_take(
        plan_.timing.seconds, most, [&](std::uint32_t count) { return shader.run(count, factor); });
    work.push_back(
        shader.work(turns, factor, std::size_t{threads_} * turns * std::size_t{evaluations_a_turn}));
  }

  void add_copy() {
    const Timed filling = timed(filling_shader(), ShaderPrecision::float32),
                copying = timed(copying_shader(), ShaderPrecision::float32);
    // Doubled as turns are, because a slow device must not copy 64 MiB at once; each word is written before
    // it is read, so that there is memory behind it.
    constexpr std::uint32_t first = 1U << 18;
    constexpr double enough = longest_dispatch / 8;
    const std::uint32_t words =
        first * turns_that_take(enough, plan_.copied_words / first, [&](std::uint32_t times) {
          filling.run(times * first, threads_);
          return copying.run(times * first, threads_);
        });
    work.push_back(copying.work(words, threads_, words));
  }

  VulkanDevice& device_;
  ShaderCompiler compiler_;
  DevicePlan plan_;
  std::function<void()> between_;
  std::uint32_t threads_;
  mutable double seconds_ = 0;  ///< the clock of the device: those of all dispatches
};

/// Times of a chain, one for each round.
using Rounds = std::vector<double>;

/// What has been measured, in ns.
class Measured {
 public:
  Measured(const Programme& programme, std::vector<bench::Samples> samples)
      : programme_(programme), samples_(std::move(samples)) {}

  /// ns of an element of that work, without what the empty kernel takes.
  Rounds step(std::size_t slot) const {
    Rounds ns = samples_.at(slot).real;
    const double idle = bench::spread_of(samples_.at(programme_.empty).real).median;
    for (double& x : ns) x -= idle / static_cast<double>(programme_.work.at(slot).elements);
    return ns;
  }
  const bench::Samples& samples(std::size_t slot) const { return samples_.at(slot); }
  long elements(std::size_t slot) const {
    return samples_.at(slot).calls * static_cast<long>(programme_.work.at(slot).elements);
  }

 private:
  const Programme& programme_;
  std::vector<bench::Samples> samples_;
};

Rounds less(Rounds a, const Rounds& b, double times = 1) {
  for (std::size_t r = 0; r < a.size(); ++r) a[r] -= times * b[r];
  return a;
}

/// The chain alone and the multiply-adds of a precision.
struct Floor {
  Slots alone{}, polynomial{};

  /// A multiply-add, in a chain of that kind.
  Rounds multiply_add(const Measured& measured, std::size_t chain) const {
    Rounds ns = less(measured.step(polynomial.at(chain)), measured.step(alone.at(chain)));
    for (double& x : ns) x /= forms::MultiplyAdds::count;
    return ns;
  }

  /// An evaluation of a function of so many arguments. The additional multiply-adds of a chain that waits
  /// for itself run beside the first.
  Rounds evaluation(const Measured& measured, const Slots& slots, std::size_t chain,
                    std::size_t arguments) const {
    const Rounds ns = less(measured.step(slots.at(chain)), measured.step(alone.at(chain)));
    if (chains.at(chain) == Chain::dependent) return ns;
    return less(ns, multiply_add(measured, chain), static_cast<double>(arguments - 1));
  }
};

/// The functions of a precision among the work: the floor, and each form by its place.
struct InPrecision {
  ShaderPrecision precision;
  Floor floor;
  std::vector<Slots> forms;
  std::vector<std::optional<double>> errors;
};

InPrecision add_all(Programme& programme, const DeviceForms& forms, ShaderPrecision precision) {
  InPrecision all{precision,
                  {programme.add(chain_alone(), Programme::unit, precision),
                   programme.add(multiply_add_chain(), Programme::unit, precision)},
                  {},
                  {}};
  const DeviceForm* last = nullptr;
  for (const DeviceForm& form : forms.forms) {
    const bool is_timed = last != nullptr && last->target == form.target && last->shape == form.shape;
    all.forms.push_back(is_timed
                            ? all.forms.back()
                            : programme.add(form.function, forms.targets.at(form.target).ranges, precision));
    last = &form;
  }
  return all;
}

/// A row with times. `mads` has the float's multiply-add by chain.
bench::TimedForm timed_row(bench::TimedForm row, const std::array<Rounds, chains.size()>& times,
                           const std::array<double, chains.size()>& mads, bool is_half) {
  row.real = times[0];
  row.ns = bench::spread_of(times[0]);
  const double dependent = bench::spread_of(times[1]).median;
  row.multiply_adds = row.ns.median / mads[0];
  row.on_device = {is_half, dependent, dependent / mads[1]};
  return row;
}

std::array<double, chains.size()> medians(const std::array<Rounds, chains.size()>& times) {
  return {bench::spread_of(times[0]).median, bench::spread_of(times[1]).median};
}

/// The copy or the empty kernel: what has no chain.
bench::TimedForm plain_row(const char* name, const Measured& measured, std::size_t slot, const Rounds& ns) {
  bench::TimedForm row;
  row.form = row.label = name;
  row.real = ns;
  row.ns = bench::spread_of(ns);
  row.cpu = measured.samples(slot).cpu;
  row.elements = measured.elements(slot);
  row.on_device.emplace();
  return row;
}

}  // namespace

DeviceChoice choice_for_times(std::size_t place, const DevicePlan& plan) {
  return {.place = place, .words = plan.copied_words, .has_buffers_on_device = true};
}

bench::Trade measure_on_device(VulkanDevice& for_times, VulkanDevice& for_values, const DeviceForms& forms,
                               const DevicePlan& plan, const std::function<void(double)>& between) {
  const DeviceInfo info = for_times.info();
  const auto go_on = [&] { between(0); };
  Programme programme(for_times, plan, go_on);
  std::vector<InPrecision> all{add_all(programme, forms, ShaderPrecision::float32)};
  if (info.has_half) all.push_back(add_all(programme, forms, ShaderPrecision::float16));
  for (InPrecision& one : all) one.errors = errors_on_device(for_values, forms, one.precision, go_on);
  const Measured measured(programme, programme.run(between));

  bench::Trade trade;
  trade.machine = bench::this_machine();
  trade.machine.device = info.name;
  trade.machine.driver = info.driver;
  trade.machine.clock = name_of_clock(info);
  for (const DeviceTarget& target : forms.targets) trade.targets.push_back(target.heading);
  trade.copies = {
      plain_row("copy", measured, programme.copy, measured.step(programme.copy)),
      plain_row("empty-dispatch", measured, programme.empty, measured.samples(programme.empty).real)};
  std::array<double, chains.size()> mads{};
  for (const InPrecision& one : all) {
    const bool is_half = one.precision == ShaderPrecision::float16;
    const std::array floor{one.floor.multiply_add(measured, 0), one.floor.multiply_add(measured, 1)};
    if (!is_half) mads = medians(floor);
    bench::TimedForm row;
    row.form = row.label = "multiply-add";
    row.elements = measured.elements(one.floor.polynomial[0]) * forms::MultiplyAdds::count;
    row.cpu = measured.samples(one.floor.polynomial[0]).cpu;
    trade.copies.push_back(timed_row(row, floor, mads, is_half));
  }
  for (std::size_t i = 0; i < forms.forms.size(); ++i) {
    const DeviceForm& form = forms.forms[i];
    for (const InPrecision& one : all) {
      const Slots& slots = one.forms[i];
      const std::size_t arguments = form.function.arguments.size();
      bench::TimedForm row = form.row;
      if (one.errors[i]) row.max_abs_error = one.errors[i];
      row.elements = measured.elements(slots[0]);
      row.cpu = measured.samples(slots[0]).cpu;
      trade.forms.push_back(timed_row(row,
                                      {one.floor.evaluation(measured, slots, 0, arguments),
                                       one.floor.evaluation(measured, slots, 1, arguments)},
                                      mads, one.precision == ShaderPrecision::float16));
    }
  }
  bench::relate(trade);
  return trade;
}

}  // namespace shadefit::device
