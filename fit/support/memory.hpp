#pragma once

#include <cstddef>
#include <functional>
#include <map>

namespace shadefit {

/// Answers that are computed once: generated programs have one expression thousands of times, and proofs ask
/// for one integral on the same boxes. All are forgotten when there are too many.
template <class Key, class Answer, class Before = std::less<Key>>
class Memory {
 public:
  /// The answer of an earlier call with this key, or that of `compute`.
  template <class Compute>
  Answer get(const Key& key, const Compute& compute) {
    const auto found = answers_.find(key);
    if (found != answers_.end()) return found->second;
    if (answers_.size() >= most_answers) answers_.clear();
    return answers_.emplace(key, compute()).first->second;
  }

 private:
  static constexpr std::size_t most_answers = 4096;
  std::map<Key, Answer, Before> answers_;
};

}  // namespace shadefit
