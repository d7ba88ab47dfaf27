#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

/// Whether a published number is right: decided by its printed digits, never typed in.
namespace shadefit {

enum class Verdict { confirmed, rounding, other_objective, conditional, refuted };

/// All of them, each further from `confirmed` than the one before.
inline constexpr std::array all_verdicts{Verdict::confirmed, Verdict::rounding, Verdict::other_objective,
                                         Verdict::conditional, Verdict::refuted};

constexpr std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::confirmed:
      return "confirmed";
    case Verdict::rounding:
      return "rounding";
    case Verdict::other_objective:
      return "other-objective";
    case Verdict::conditional:
      return "conditional";
    case Verdict::refuted:
      return "refuted";
  }
  return "unknown";
}

/// How many units of its last printed digit a printed number is from the computed one, rounded half away from
/// zero to the same digits: 0 where all printed digits are right. `printed` is plain decimal, like
/// "-5.55473".
long units_off(std::string_view printed, double computed);

/// One unit in the last printed digit: 0.001 for "0.788".
double last_unit(std::string_view printed);

/// A number that a published one can be held against, and the metric or convention that it comes from.
struct Alternative {
  std::string objective;
  double value;
};

struct Judgement {
  Verdict verdict;
  std::string objective;  ///< under which the printed digits come out, or come closest; empty for `refuted`
  double value;           ///< computed under that objective; for `refuted` under the first
};

/// Judges a printed number against the value computed under one objective, then under the others in their
/// order: `confirmed` if it has all printed digits, `rounding` if only the last one is off by one,
/// `other-objective` if one of the others has all of them, else `refuted`.
Judgement judge(std::string_view printed, const Alternative& computed, std::span<const Alternative> others);

}  // namespace shadefit
