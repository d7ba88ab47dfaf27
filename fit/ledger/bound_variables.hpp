#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace shadefit {

/// A variable that stands for a number, and for the item of a list.
template <class T>
struct Bound {
  std::string name;
  T value;
  std::string text = {};
  bool operator<(const Bound& other) const {
    return std::tie(name, value) < std::tie(other.name, other.value);
  }
};

/// The variables that are bound, the innermost last. It knows which were used.
template <class T>
class BoundVariables {
 public:
  /// Finds the innermost variable of that name. Returns null where no variable has it.
  const Bound<T>* find(std::string_view name) {
    const auto found =
        std::find_if(all_.rbegin(), all_.rend(), [&](const auto& bound) { return bound.name == name; });
    if (found == all_.rend()) return nullptr;
    outermost_ = std::min(outermost_, static_cast<std::size_t>(&*found - all_.data()));
    return &*found;
  }

  void with(const std::vector<Bound<T>>& variables, const std::function<void()>& visit) {
    all_.insert(all_.end(), variables.begin(), variables.end());
    visit();
    all_.erase(all_.end() - std::ssize(variables), all_.end());
  }

  /// Whether the visit used a variable that was bound before.
  bool used_by(const std::function<void()>& visit) {
    const std::size_t before = std::exchange(outermost_, none);
    visit();
    const bool is_used = outermost_ < all_.size();
    outermost_ = std::min(before, is_used ? outermost_ : none);
    return is_used;
  }

  const std::vector<Bound<T>>& all() const { return all_; }
  void use_all() { outermost_ = 0; }

 private:
  static constexpr auto none = std::numeric_limits<std::size_t>::max();
  std::vector<Bound<T>> all_;
  std::size_t outermost_ = none;  ///< of those that were used
};

}  // namespace shadefit
