#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

/// The verdict on a published number. It is computed from the printed digits, never typed.
namespace shadefit {

enum class Verdict { confirmed, rounding, other_objective, conditional, refuted, undecidable };

/// The verdicts on claims, from `confirmed` to the worst. `undecidable` is for studies, where many objectives
/// are tried.
inline constexpr std::array all_verdicts{Verdict::confirmed, Verdict::rounding, Verdict::other_objective,
                                         Verdict::conditional, Verdict::refuted};

constexpr std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 6> names{"confirmed",   "rounding", "other-objective",
                                                  "conditional", "refuted",  "undecidable"};
  return names.at(static_cast<std::size_t>(verdict));
}

/// The difference of a printed number and the computed one, in units of the last printed digit. The computed
/// number is rounded to the same digits, half away from zero: 0 means that all printed digits are right.
/// `printed` is a decimal, like "-5.55473" or "5.4856e-13".
long units_off(std::string_view printed, double computed);

/// One unit in the last printed digit: 0.001 for "0.788".
double last_unit(std::string_view printed);

/// A computed number for a published one, and its metric or convention.
struct Alternative {
  std::string objective;
  double value;
};

struct Judgement {
  Verdict verdict;
  std::string
      objective;  ///< the objective that gives the printed digits, or the closest; empty for `refuted`
  double value;   ///< computed under that objective; for `refuted` under the first
};

/// Compares a printed number with the value under one objective, then under the others in their order:
/// `confirmed` if it has all printed digits, `rounding` if only the last one is off by one,
/// `other-objective` if one of the others has all of them, else `refuted`.
Judgement judge(std::string_view printed, const Alternative& computed, std::span<const Alternative> others);

}  // namespace shadefit
