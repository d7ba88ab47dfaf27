#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "approx/records/claim.hpp"
#include "fit/verdicts/verdict.hpp"

/// What computing a claim gave, and what the computations of the ledger share.
namespace shadefit {

/// A claim's verdict with what it rests on.
struct Finding {
  std::optional<Verdict> verdict;  ///< empty where the evidence is weaker than the printed digits
  std::string computed;            ///< what stands beside the printed numbers
  std::string evidence;  ///< short sentences with their numbers, by `sentences` of fit/errors/effect.hpp
  /// What the difference does to a picture: `sentence` of fit/errors/effect.hpp, or several by `sentences`;
  /// or "none", or "none: " with the reason.
  std::string effect = "none";
};

/// How a claim is computed: from the record alone, so that a test may change what is printed or given and see
/// the finding change. Throws std::exception for a record that cannot be read. A claim of published constants
/// needs none; where it has one, this holds what fits do not check.
using Evaluate = Finding (*)(const Claim& claim);

struct Evaluator {
  std::string_view id;
  Evaluate evaluate;
};

/// The verdict of a row with several parts: of all parts the one furthest from `confirmed`; empty where one
/// part is.
std::optional<Verdict> worst(std::span<const std::optional<Verdict>> parts);
Verdict worst(std::span<const Verdict> parts);

/// `confirmed` or `refuted`, for what is either so or not.
constexpr Verdict verdict_of(bool holds) {
  return holds ? Verdict::confirmed : Verdict::refuted;
}

/// `confirmed` where all of a statement's cases hold, `refuted` where none does, else `conditional`.
constexpr Verdict verdict_of_cases(std::size_t holding, std::size_t cases) {
  return holding == cases ? Verdict::confirmed : holding == 0 ? Verdict::refuted : Verdict::conditional;
}

/// What stands beside an identity: "identity" where it was confirmed.
std::string identity_if(const std::optional<Verdict>& verdict);

/// Judges a printed number against a value that is known to `error` (absolute). Empty where that is not
/// enough to say: where both ends of value +- error do not lead to one verdict.
std::optional<Verdict> judge_known_to(std::string_view printed, double value, double error);

/// A quantity of the record as a number. Throws std::invalid_argument where it is none.
double number_of(std::string_view text);

/// What the record gives the computation under that name, as a number.
double given(const Claim& claim, std::string_view name);

/// The largest shift in 8-bit sRGB codes when every colour in [0, 1] is multiplied by that ratio; sampled at
/// the 255 linear greys.
double codes_of_factor(double ratio);

/// What a wrong constant does to what it multiplies: to the 255 linear greys, in the words of `sentence`.
/// "none" where printed and exact are equal. The lead says which constant it is, or where: "at k = 2 it".
std::string effect_of_factor(double printed, double exact, std::string_view lead = {});

/// "none: no value changes", of a difference that no picture shows.
std::string none_because(std::string_view reason);

}  // namespace shadefit
