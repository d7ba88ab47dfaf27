#include <bit>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bench/exhaustive/float_errors.hpp"
#include "fit/support/parallel.hpp"

namespace shadefit::bench {
namespace {

/// The truth at each float of a stretch.
struct TruthOfStretch {
  decltype(FloatSubject::truth) truth;
  std::optional<Stretch> stretch = {};
  std::vector<double> values = {};

  void prepare(const Stretch& wanted) {
    if (stretch == wanted) return;
    stretch = wanted;
    constexpr std::size_t size = 1024;
    const std::size_t pieces = (wanted.size() + size - 1) / size;
    values.resize(pieces * size);
    // The last piece goes beyond the stretch, where nobody looks.
    for_each_in_parallel(pieces, [&](std::size_t piece, const Checkpoint&) {
      std::vector<float> in(size);
      for (std::size_t i = 0; i < size; ++i)
        in[i] = std::bit_cast<float>(static_cast<std::uint32_t>(wanted.from + piece * size + i));
      truth(in.data(), &values[piece * size], size);
    });
  }
};

}  // namespace

void share_truth(std::span<FloatSubject* const> subjects) {
  const auto shared = std::make_shared<TruthOfStretch>(TruthOfStretch{subjects.front()->truth});
  for (FloatSubject* const subject : subjects) {
    subject->truth = [shared](const float* in, double* out, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i)
        out[i] = shared->values[std::bit_cast<std::uint32_t>(in[i]) - shared->stretch->from];
    };
    subject->prepare = [shared, own = std::move(subject->prepare)](const Stretch& stretch) {
      shared->prepare(stretch);
      if (own) own(stretch);
    };
  }
}

}  // namespace shadefit::bench
