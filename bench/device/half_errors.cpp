#include "bench/device/half_errors.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "bench/device/evaluator.hpp"
#include "bench/device/form_bound.hpp"
#include "fit/input/parallel.hpp"
#include "fit/scalars/half.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit::device {
namespace {

std::uint16_t bits_of(Eigen::half x) {
  return Eigen::numext::bit_cast<std::uint16_t>(x);
}

std::vector<float> unit_halves() {
  std::vector<float> halves;
  for (std::uint16_t bits = 0; bits <= bits_of(Eigen::half(1.0F)); ++bits)
    halves.push_back(static_cast<float>(Eigen::numext::bit_cast<Eigen::half>(bits)));
  return halves;
}

/// The place of a number among all halves, in their order.
int place_of(double x) {
  const auto bits = static_cast<std::int16_t>(bits_of(round_to_half(x)));
  return bits < 0 ? INT16_MIN - bits : bits;
}

/// Of each cosine a bound of the distance between a form and its real value.
std::vector<double> bounds_at(const std::vector<float>& cosines, const ShaderFunction& function,
                              const GpuModel& model) {
  constexpr std::size_t piece = 1024;
  std::vector<double> bounds(cosines.size());
  for_each_in_parallel((cosines.size() + piece - 1) / piece, [&](std::size_t part, const Checkpoint&) {
    FormBound<HalfFormat> bound(function, model);
    for (std::size_t i = part * piece; i < std::min(cosines.size(), (part + 1) * piece); ++i) {
      const Domain place{cosines[i], cosines[i]};
      bounds[i] = bound.on(std::span(&place, 1));
    }
  });
  return bounds;
}

}  // namespace

void require_half(const DeviceInfo& info) {
  if (!info.has_half) throw UserError("device '" + info.name + "' has no arithmetic in half");
}

bench::FloatErrors errors_in_half(VulkanDevice& device, const ShaderFunction& function,
                                  const TruthOfCosines& truth, const GpuModel& model) {
  require_half(device.info());
  const std::vector<float> cosines = unit_halves();
  std::vector<double> exact(cosines.size());
  truth(cosines.data(), exact.data(), cosines.size());
  const ShaderCompiler compiler;
  Evaluator evaluator(device, compiler, function, ShaderLanguage::glsl, Arguments::input,
                      ShaderPrecision::float16);
  const auto results = evaluator.of_input(cosines);
  const FormInDouble in_double(function, ShaderPrecision::float16);
  const std::vector<double> bounds = bounds_at(cosines, function, model);
  bench::FloatErrors found;
  for (std::size_t i = 0; i < cosines.size(); ++i) {
    const auto c = static_cast<double>(cosines[i]);
    const auto result = std::bit_cast<float>(results[i]);
    const auto at = std::bit_cast<std::uint32_t>(cosines[i]);
    double real = 0;
    in_double(std::array{&c}, &real, 1);
    if (!std::isfinite(bounds[i])) {
      ++found.unbounded;
    } else if (!(std::abs(static_cast<double>(result) - real) <= bounds[i])) {
      found.note_beyond(at);
    }
    if (std::isnan(result)) {
      ++found.nans;
    } else {
      const int steps = std::abs(place_of(static_cast<double>(result)) - place_of(exact[i]));
      found.note(at, result, exact[i], static_cast<std::uint32_t>(steps));
    }
  }
  return found;
}

}  // namespace shadefit::device
