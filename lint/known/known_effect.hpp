#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "fit/support/memory.hpp"
#include "lint/known/known_set.hpp"

namespace shadefit::lint {

/// The effects of numbers in sets that outlive this object. Each is computed once.
class KnownEffects {
 public:
  /// See effect_of().
  Effect of(const KnownSet& set, const Symbolic& form, const std::vector<double>& constants) {
    return effects_.get({&set, to_text(form), constants}, [&] { return effect_of(set, form, constants); });
  }

  /// See is_shown().
  bool are_shown(const KnownSet& set) {
    return shown_.get(&set, [&] { return is_shown(set); });
  }

 private:
  Memory<std::tuple<const KnownSet*, std::string, std::vector<double>>, Effect> effects_;
  Memory<const KnownSet*, bool> shown_;
};

}  // namespace shadefit::lint
