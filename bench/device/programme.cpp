#include "bench/device/programme.hpp"

#include <array>
#include <bit>
#include <utility>

#include "bench/tradeoff/trade.hpp"

namespace shadefit::device {
namespace {

/// Enough threads to fill the device: a large GPU runs 270 000 at once, a CPU a few dozen. On the CPU fewer
/// threads mean more turns, so that the loop is warm.
std::uint32_t threads_of(const DeviceInfo& info) {
  return is_the_cpu(info) ? 1U << 13 : 1U << 18;
}

}  // namespace

Programme::Programme(VulkanDevice& device, const bench::TimingPlan& plan, std::function<void()> between)
    : device_(device), plan_(plan), between_(std::move(between)), threads_(threads_of(device.info())) {
  const std::array unit{bench::Range{0, 1}};
  add(timing_shader(chain_alone(), unit, ShaderPrecision::float32), ShaderPrecision::float32, true);
}

std::size_t Programme::add(const ShaderFunction& function, std::span<const bench::Range> ranges,
                           ShaderPrecision precision) {
  between_();
  add(timing_shader(function, ranges, precision), precision, false);
  return work_.size() - 1;
}

std::vector<Rounds> Programme::run(const std::function<void(double)>& between) const {
  const auto clock = [&] { return seconds_; };
  std::vector<Rounds> times;
  for (bench::Samples& samples : bench::time_interleaved(work_, plan_, clock, between))
    times.push_back(std::move(samples.ns));
  const double idle = bench::spread_of(times.front()).median;
  for (std::size_t slot = 1; slot < times.size(); ++slot)
    for (double& ns : times[slot]) ns -= idle / static_cast<double>(work_[slot].elements);
  return times;
}

double Programme::seconds_of(const Program& program, std::uint32_t turns) const {
  return seconds_of_dispatch(device_.info(), [&] {
    return device_.run(program, threads_, {turns, std::bit_cast<std::uint32_t>(chain_factor)});
  });
}

void Programme::add(const std::string& shader, ShaderPrecision precision, bool is_empty) {
  constexpr long most = 1L << 24;  // no device runs so many in a millisecond
  const Program program = device_.load(compiler_.spirv(shader, precision));
  seconds_of(program, is_empty ? 0 : 1);  // some drivers compile a shader at its first run
  const auto run = [&](long turns) { return seconds_of(program, static_cast<std::uint32_t>(turns)); };
  const auto turns =
      is_empty ? 0U : static_cast<std::uint32_t>(bench::repeats_that_take(plan_.seconds, most, run));
  const std::size_t evaluations =
      is_empty ? 1 : std::size_t{threads_} * turns * std::size_t{evaluations_a_turn};
  work_.push_back({[=, this] { seconds_ += seconds_of(program, turns); }, evaluations, false});
}

}  // namespace shadefit::device
