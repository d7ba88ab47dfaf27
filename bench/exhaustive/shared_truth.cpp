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
class TruthOfStretch {
 public:
  explicit TruthOfStretch(decltype(FloatSubject::truth) truth) : truth_(std::move(truth)) {}

  void prepare(const Stretch& stretch) {
    if (stretch_ == stretch) return;
    stretch_ = stretch;
    const std::size_t blocks = (stretch.size() + block - 1) / block;
    values_.resize(blocks * block);
    for_each_in_parallel(blocks, [this](std::size_t i, const Checkpoint&) { compute(i * block); });
  }

  void at(const float* in, double* out, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i)
      out[i] = values_[std::bit_cast<std::uint32_t>(in[i]) - stretch_->from];
  }

 private:
  static constexpr std::size_t block = 1024;

  /// A block of floats from the first one. The last block goes beyond the stretch, where nobody looks.
  void compute(std::size_t first) {
    std::vector<float> in(block);
    for (std::size_t i = 0; i < block; ++i)
      in[i] = std::bit_cast<float>(static_cast<std::uint32_t>(stretch_->from + first + i));
    truth_(in.data(), &values_[first], block);
  }

  decltype(FloatSubject::truth) truth_;
  std::optional<Stretch> stretch_;
  std::vector<double> values_;
};

}  // namespace

void share_truth(std::span<FloatSubject* const> subjects) {
  const auto shared = std::make_shared<TruthOfStretch>(subjects.front()->truth);
  for (FloatSubject* const subject : subjects) {
    subject->truth = [shared](const float* in, double* out, std::size_t count) {
      shared->at(in, out, count);
    };
    subject->prepare = [shared, own = std::move(subject->prepare)](const Stretch& stretch) {
      shared->prepare(stretch);
      if (own) own(stretch);
    };
  }
}

}  // namespace shadefit::bench
