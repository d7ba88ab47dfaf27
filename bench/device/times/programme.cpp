#include "bench/device/times/programme.hpp"

#include <bit>
#include <utility>

namespace shadefit::device {
namespace {

constexpr auto factor_bits = std::bit_cast<std::uint32_t>(chain_factor);

/// Enough threads to fill the device: a large GPU runs 270 000 at once, a CPU a few dozen. On the CPU fewer
/// threads mean more turns, so that the loop is warm.
std::uint32_t threads_of(const DeviceInfo& info) {
  return is_the_cpu(info) ? 1U << 13 : 1U << 18;
}

}  // namespace

std::uint32_t turns_that_take(double seconds, std::uint32_t most,
                              const std::function<double(std::uint32_t)>& run) {
  for (std::uint32_t turns = 1;; turns *= 2) {
    if (run(turns) >= seconds || turns > most / 2) return turns;
  }
}

/// A shader on the device and the work of its dispatches. The clock is the device's.
struct Programme::Timed {
  VulkanDevice* device;
  double* clock;
  Program program;
  std::uint32_t threads;

  double run(std::uint32_t count, std::uint32_t second) const {
    return seconds_of_dispatch(device->info(), [&] {
      return device->run(program, threads, {count, second});
    });
  }
  /// The work of one dispatch with these push words.
  bench::Work work(std::uint32_t count, std::uint32_t second, std::size_t elements) const {
    return {[*this, count, second] { *clock += run(count, second); }, elements, false};
  }
};

Programme::Programme(VulkanDevice& device, const DevicePlan& plan, std::function<void()> between)
    : device_(device), plan_(plan), between_(std::move(between)), threads_(threads_of(device.info())) {
  add_copy();
  add_empty();
}

Slots Programme::add(const ShaderFunction& function, std::span<const Range> ranges,
                     ShaderPrecision precision) {
  const Slots slots{work_.size(), work_.size() + 1};
  for (const Chain chain : chains) {
    between_();
    add(timed(timing_shader(function, ranges, precision, chain), precision));
  }
  return slots;
}

std::vector<bench::Samples> Programme::run(const std::function<void(double)>& between) const {
  const auto clock = [&] { return bench::Instant{seconds_, bench::now().cpu}; };
  return bench::time_interleaved(work_, plan_.timing, clock, between);
}

Programme::Timed Programme::timed(const std::string& shader, ShaderPrecision precision) {
  return {&device_, &seconds_, device_.load(compiler_.spirv(shader, ShaderLanguage::glsl, precision)),
          threads_};
}

void Programme::add(const Timed& shader) {
  constexpr std::uint32_t most = 1U << 24;  // no device runs so many in a millisecond
  shader.run(1, factor_bits);               // some drivers compile a shader at its first run
  const std::uint32_t turns = turns_that_take(
      plan_.timing.seconds, most, [&](std::uint32_t count) { return shader.run(count, factor_bits); });
  work_.push_back(
      shader.work(turns, factor_bits, std::size_t{threads_} * turns * std::size_t{evaluations_a_turn}));
}

void Programme::add_copy() {
  const Timed filling = timed(filling_shader(), ShaderPrecision::float32),
              copying = timed(copying_shader(), ShaderPrecision::float32);
  // Doubled as the turns are, because a slow device must not copy 64 MiB at once. Each word is written before
  // it is read, so that there is memory behind it.
  constexpr std::uint32_t first = 1U << 18;
  constexpr double enough = longest_dispatch / 8;
  const std::uint32_t words =
      first * turns_that_take(enough, plan_.copied_words / first, [&](std::uint32_t times) {
        filling.run(times * first, threads_);
        return copying.run(times * first, threads_);
      });
  work_.push_back(copying.work(words, threads_, words));
}

void Programme::add_empty() {
  const std::array unit{Range{0, 1}};
  const Timed idle = timed(timing_shader(chain_alone(), unit, ShaderPrecision::float32, Chain::dependent),
                           ShaderPrecision::float32);
  idle.run(0, factor_bits);
  work_.push_back(idle.work(0, factor_bits, 1));
}

}  // namespace shadefit::device
