#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/errors/effect.hpp"
#include "fit/ledger/claim.hpp"
#include "fit/verdicts/verdict.hpp"

/// The result of computing a claim, and the common functions of the ledger.
namespace shadefit {

/// A claim's verdict and its evidence.
struct Finding {
  std::optional<Verdict> verdict;  ///< empty where the evidence is weaker than the printed digits
  std::string computed;            ///< the computed numbers, for the column beside the printed ones
  std::string evidence;  ///< short sentences with their numbers, by `sentences` of fit/errors/effect.hpp
  /// The effect on a picture: `sentence` of fit/errors/effect.hpp, or several by `sentences`; or "none", or
  /// "none: " with the reason.
  std::string effect = "none";
};

/// The function that computes a claim from its record only. So a test can change a printed number and see the
/// finding change. Throws std::exception for a record that cannot be read. A claim of published constants
/// needs none, because fits judge it; with one, this checks the rest.
using Evaluate = Finding (*)(const Claim& claim);

struct Evaluator {
  std::string_view id;
  Evaluate evaluate;
};

/// The verdict of a row with several parts: the worst of the parts; empty if one part is empty.
std::optional<Verdict> worst(std::span<const std::optional<Verdict>> parts);
Verdict worst(std::span<const Verdict> parts);

/// `confirmed` or `refuted`, for a statement that is true or false.
constexpr Verdict verdict_of(bool holds) {
  return holds ? Verdict::confirmed : Verdict::refuted;
}

/// `conditional` if it holds in a part only.
constexpr Verdict verdict_of(bool holds, bool holds_in_part) {
  return holds ? Verdict::confirmed : holds_in_part ? Verdict::conditional : Verdict::refuted;
}

/// `confirmed` if all cases of a statement hold, `refuted` if none does, else `conditional`.
constexpr Verdict verdict_of_cases(std::size_t holding, std::size_t cases) {
  return verdict_of(holding == cases, holding > 0);
}

/// A quantity of the record as a number. Throws std::invalid_argument if it is not a number.
double number_of(std::string_view text);

/// An input of the record by its name, as a number.
double given(const Claim& claim, std::string_view name);

/// The items of a list in the inputs of a record, "0.5, 1" or "sRGB, gamma 2.2": what stands between the
/// separators, without the blanks around it. A text without a separator is one item.
std::vector<std::string> items_of(std::string_view text, char separator = ',');

/// The same as numbers. Throws std::invalid_argument if an item is not a number.
std::vector<double> numbers_of(std::string_view text, char separator = ',');

/// The effect of replacing a lobe c^from by c^to, after a lead; both powers are above 0.
std::string effect_of_power(double from, double to, std::string_view lead = {});

/// The effect of a wrong factor on the 255 linear greys, in the words of `sentence`. "none" if printed and
/// exact are equal. The lead names the constant or the place: "at k = 2 it".
std::string effect_of_factor(double printed, double exact, std::string_view lead = {});

}  // namespace shadefit
