#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fit/formula/shader_calls.hpp"
#include "fit/scalars/symbolic.hpp"

/// Random formulas, the same in every run.
namespace shadefit::testing {

class AnyExpression {
 public:
  AnyExpression(std::uint64_t seed, std::vector<std::string> names)
      : state_(seed), names_(std::move(names)) {}

  Symbolic of_depth(int depth) {
    const auto part = [&] { return draw(4) == 0 || depth == 0 ? leaf() : of_depth(depth - 1); };
    switch (draw(13)) {
      case 0:
        return part() + part();
      case 1:
        return part() - part();
      case 2:
        return part() * part();
      case 3:
        return part() / part();
      case 4:
        return -part();
      case 5:
        return power(part(), static_cast<int>(draw(7)) - 3);
      case 6:
        return raised(part(), part());
      case 7:
        return exp2(part());
      case 8:
        return function_of(part());
      case 9:
        return function_of(part(), part());
      case 10:
        return atan2(part(), part());
      case 11:
        return sqrt(part());
      default: {
        const Symbolic limit = part();
        return select(less(part(), limit), part(), part());
      }
    }
  }

 private:
  /// A linear congruential generator (Knuth's MMIX constants).
  std::uint64_t draw(std::uint64_t n) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return (state_ >> 33) % n;
  }

  Symbolic leaf() {
    if (draw(5) < 3) return Symbolic::variable(names_[draw(names_.size())]);
    if (draw(3) == 0) return pi<Symbolic>();
    if (draw(2) == 0) return constant<Symbolic>(draw(2) == 0 ? "0.775" : "-0.5");
    return integer<Symbolic>(static_cast<int>(draw(9)));
  }

  Symbolic function_of(const Symbolic& x) {
    const auto& all = functions_of_one<Symbolic>;
    return all[draw(all.size())](x);
  }

  Symbolic function_of(const Symbolic& x, const Symbolic& y) {
    const auto& all = functions_of_two<Symbolic>;
    return all[draw(all.size())](x, y);
  }

  std::uint64_t state_;
  std::vector<std::string> names_;
};

}  // namespace shadefit::testing
