#include "bench/device/programme.hpp"

#include <array>
#include <bit>

#include "bench/tradeoff/trade.hpp"

namespace shadefit::device {
namespace {

/// Enough threads to fill the device: a large GPU runs 270 000 at once, a CPU a few dozen. On the CPU fewer
/// threads mean more turns, so that the loop is warm.
std::uint32_t threads_of(const DeviceInfo& info) {
  return is_the_cpu(info) ? 1U << 13 : 1U << 18;
}

}  // namespace

Programme::Programme(VulkanDevice& device) : device_(device), threads_(threads_of(device.info())) {
  const Program empty = load(chain_alone(), std::array{bench::Range{0, 1}}, ShaderPrecision::float32);
  const auto dispatches = [=, this](long count) {
    double seconds = 0;
    for (long i = 0; i < count; ++i) seconds += seconds_of(empty, 0);
    return seconds;
  };
  dispatches(1);  // some drivers compile a shader at its first run
  work_.push_back({dispatches, 1});
}

std::size_t Programme::add(const ShaderFunction& function, std::span<const bench::Range> ranges,
                           ShaderPrecision precision) {
  const Program program = load(function, ranges, precision);
  const auto turns = [=, this](long count) { return seconds_of(program, count); };
  turns(1);
  work_.push_back({turns, static_cast<double>(threads_) * evaluations_a_turn});
  return work_.size() - 1;
}

std::vector<Rounds> Programme::run(const bench::TimingPlan& plan,
                                   const std::function<void(double)>& between) const {
  const std::vector<bench::Samples> samples = bench::time_interleaved(work_, plan, between);
  std::vector<Rounds> times{samples.front().ns};
  const double idle = bench::spread_of(times.front()).median;
  for (std::size_t slot = 1; slot < samples.size(); ++slot) {
    const double evaluations = static_cast<double>(samples[slot].repeats) * work_[slot].elements;
    for (double& ns : times.emplace_back(samples[slot].ns)) ns -= idle / evaluations;
  }
  return times;
}

Program Programme::load(const ShaderFunction& function, std::span<const bench::Range> ranges,
                        ShaderPrecision precision) const {
  return device_.load(compiler_.spirv(timing_shader(function, ranges, precision), precision));
}

double Programme::seconds_of(const Program& program, long turns) const {
  return seconds_of_dispatch(device_.info(), [&] {
    return device_.run(program, threads_,
                       {static_cast<std::uint32_t>(turns), std::bit_cast<std::uint32_t>(chain_factor)});
  });
}

}  // namespace shadefit::device
