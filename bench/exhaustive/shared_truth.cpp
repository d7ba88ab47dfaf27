#include "bench/exhaustive/shared_truth.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <future>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace shadefit::bench {
namespace {

/// The truth at each float of a stretch.
class TruthOfStretch {
 public:
  TruthOfStretch(decltype(FloatSubject::truth) truth, unsigned threads)
      : truth_(std::move(truth)), threads_(std::max(threads, 1U)) {}

  void prepare(const Stretch& stretch) {
    if (stretch_ == stretch) return;
    stretch_ = stretch;
    values_.resize(stretch.size() + block);
    std::vector<std::future<void>> parts;
    for (std::size_t part = 0; part < threads_; ++part)
      parts.push_back(std::async(std::launch::async, [this, part] { compute(part); }));
    for (auto& part : parts) part.get();
  }

  void at(const float* in, double* out, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i)
      out[i] = values_[std::bit_cast<std::uint32_t>(in[i]) - stretch_->from];
  }

 private:
  static constexpr std::size_t block = 1024;

  /// Every block whose turn it is. The last one goes beyond the stretch, where nobody looks.
  void compute(std::size_t part) {
    std::array<float, block> in;
    for (std::size_t first = part * block; first < stretch_->size(); first += threads_ * block) {
      for (std::size_t i = 0; i < block; ++i)
        in[i] = std::bit_cast<float>(static_cast<std::uint32_t>(stretch_->from + first + i));
      truth_(in.data(), &values_[first], block);
    }
  }

  decltype(FloatSubject::truth) truth_;
  std::size_t threads_;
  std::optional<Stretch> stretch_;
  std::vector<double> values_;
};

}  // namespace

void share_truth(std::span<FloatSubject* const> subjects, unsigned threads) {
  const auto shared = std::make_shared<TruthOfStretch>(subjects.front()->truth, threads);
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
