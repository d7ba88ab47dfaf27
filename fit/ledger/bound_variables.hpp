#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
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

  template <class Visit>
  void with(std::initializer_list<Bound<T>> variables, const Visit& visit) {
    all_.insert(all_.end(), variables);
    visit();
    all_.erase(all_.end() - std::ssize(variables), all_.end());
  }

  /// The place of the outermost variable that the visit used, of those that were bound before; or `none`.
  template <class Visit>
  std::size_t used_by(const Visit& visit) {
    const std::size_t before = std::exchange(outermost_, none);
    visit();
    const std::size_t used = outermost_ < all_.size() ? outermost_ : none;
    outermost_ = std::min(before, used);
    return used;
  }
  void use(std::size_t place) { outermost_ = std::min(outermost_, place); }

  const std::vector<Bound<T>>& all() const { return all_; }
  static constexpr auto none = std::numeric_limits<std::size_t>::max();

 private:
  std::vector<Bound<T>> all_;
  std::size_t outermost_ = none;  ///< of those that were used
};

}  // namespace shadefit
