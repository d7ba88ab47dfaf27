#include "approx/gloss.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "approx/cosine.hpp"
#include "approx/encoding.hpp"
#include "approx/lobe.hpp"
#include "fit/errors/effect.hpp"
#include "fit/ledger/agreement.hpp"
#include "fit/ledger/told.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/binary_logarithm.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"

namespace shadefit {
namespace {

/// The truth has 50 digits. Two methods agree to this, for values of the order of one.
constexpr double truths_agree = 1e-45;

double rounded(const Decimal50& x) {
  return x.convert_to<double>();
}

/// The inputs of a claim: numbers from `from` to `to` in `steps` equal steps.
template <class T>
std::vector<T> places(const Claim& claim) {
  const auto from = constant<T>(claim.inputs.at("from")), to = constant<T>(claim.inputs.at("to"));
  const int steps = static_cast<int>(given(claim, "steps"));
  std::vector<T> result;
  for (int i = 0; i <= steps; ++i) result.push_back(from + (to - from) * T(i) / T(steps));
  return result;
}

/// The powers of the glosses of a claim.
std::vector<double> powers(const Claim& claim) {
  std::vector<double> result;
  for (const double gloss : places<double>(claim))
    result.push_back(decode_gloss(gloss, given(claim, "doublings"), given(claim, "first")));
  return result;
}

std::string agreement(const Decimal50& a, const Decimal50& b) {
  return fmt::format("{}{:.1g}", abs(a - b) < truths_agree ? "agree to within " : "differ by more than ",
                     truths_agree);
}

/// "17 glosses from 0 to 1 (powers 2 to 2048)"
std::string glosses(const Claim& claim) {
  const auto all = powers(claim);
  return fmt::format("{} glosses from {} to {} (powers {:.6g} to {:.6g})", all.size(),
                     claim.inputs.at("from"), claim.inputs.at("to"), all.front(), all.back());
}

/// The effect of decoding M with the printed constant on exp2(M c - M), at the worst gloss.
std::string effect_on_lobe(const Claim& claim, double ratio) {
  Effect most;
  for (const double exponent : powers(claim)) {
    const auto lobe = [](double of) {
      return [of]<class T>(const Cosine<T>& c) {
        return gaussian_lobe_near_peak(c.one_minus_cos, lift<T>(of), integer<T>(0));
      };
    };
    most.include(
        effect_between(lobe(exponent), lobe(exponent * ratio), {Metric{}, {.concentration = 2 * exponent}}),
        {"power ", exponent});
  }
  return sentence(most, "the lobe",
                  fmt::format("every power is too {1} by the relative error {0:.2g}, which over {2}",
                              std::abs(ratio - 1), ratio < 1 ? "low" : "high", glosses(claim)));
}

Finding log2_constant(const Claim& claim) {
  const auto first = constant<Decimal50>(claim.inputs.at("first"));
  const Decimal50 exact = base_two_first(first);
  const Decimal50 other = first + log2_by_squares(Decimal50(1 / ln2<Decimal50>()));
  const Quantity& printed = claim.printed[0];
  // 2^(10 g + constant) over 2^(10 g + first)/ln 2
  const Decimal50 ratio = exp2(Decimal50(constant<Decimal50>(printed.value) - exact));
  return {judge_known_to(printed.value, rounded(exact), rounded(abs(exact - other))),
          decimal(rounded(exact), 10),
          told(claim, Told{"exact", rounded(exact)}, Told{"agree", agreement(exact, other)},
               Told{"glosses", glosses(claim)}, Told{"lowest", base_two_power(powers(claim).front())},
               Told{"highest", base_two_power(powers(claim).back())}),
          effect_on_lobe(claim, rounded(ratio))};
}

/// The effect of a printed factor on the normalisation, at the worst gloss.
std::string effect_on_normalisation(const Claim& claim, double factor, double constant_term) {
  const auto printed = [&](double exponent) {
    return base_two_normalisation(base_two_power(exponent), factor, constant_term);
  };
  const auto off = [&](double exponent) {
    return std::abs(printed(exponent) / game_normalisation(exponent) - 1);
  };
  const auto all = powers(claim);
  const double worst = *std::ranges::max_element(all, {}, off);
  return effect_of_factor(
      printed(worst), game_normalisation(worst),
      fmt::format("the error of the normalisation is largest at the power {:.5g}: there the normalisation",
                  worst));
}

Finding ln2_over_eight(const Claim& claim) {
  const auto exact = base_two_normalisation_factor<Decimal50>();
  const Decimal50 other = 1 / (8 * log2_by_squares(exp(Decimal50(1))));
  const Quantity& printed = claim.printed[0];
  return {judge_known_to(printed.value, rounded(exact), rounded(abs(exact - other))),
          decimal(rounded(exact), 10),
          told(claim, Told{"exact", rounded(exact)}, Told{"agree", agreement(exact, other)},
               Told{"glosses", glosses(claim)}),
          effect_on_normalisation(claim, number_of(printed.value), game_normalisation(0.0))};
}

Finding gloss_decode(const Claim& claim) {
  const RootsOfTwo<Decimal50> roots;
  const auto doublings = constant<Decimal50>(claim.inputs.at("doublings"));
  const auto first = constant<Decimal50>(claim.inputs.at("first"));
  const auto decode = [&](std::string_view gloss) {
    return roots.exp2(doublings * constant<Decimal50>(gloss) + first);
  };
  const Decimal50 lowest = decode(claim.inputs.at("from")), highest = decode(claim.inputs.at("to"));
  const double steps = given(claim, "levels") - 1;
  const double span = given(claim, "to") - given(claim, "from");
  const double ratio = exp2(given(claim, "doublings") * span / steps);
  const std::array parts{judge_known_to(claim.printed.at("lowest"), rounded(lowest), 0),
                         judge_known_to(claim.printed.at("highest"), rounded(highest), 0)};
  const auto exactly = [](const Decimal50& s) {
    return fmt::format("{}{:.10g}", s == floor(s) ? "exactly " : "", rounded(s));
  };
  return {worst(parts), fmt::format("lowest = {:.10g}, highest = {:.10g}", rounded(lowest), rounded(highest)),
          told(claim, Told{"lowest", exactly(lowest)}, Told{"highest", exactly(highest)},
               Told{"rises", ratio > 1 ? "rises" : "does not rise"},
               Told{"steps", counted(std::lround(steps), "step")}, Told{"ratio", ratio}),
          sentences(
              {effect_of_power(rounded(lowest), number_of(claim.printed.at("lowest")), "at the lowest gloss"),
               effect_of_power(rounded(highest), number_of(claim.printed.at("highest")),
                               "at the highest gloss")})};
}

/// Two sides of an identity at the places of a claim: the largest difference, and whether it is rounding.
struct Sides {
  Decimal50 difference = 0;

  void compare(const Decimal50& left, const Decimal50& right) {
    difference = std::max(difference, Decimal50(abs(left - right)));
  }
  bool agree(const Claim& claim) const {
    return difference < constant<Decimal50>(claim.inputs.at("agreement"));
  }
  /// "agree below 1e-45 of themselves", or by how much they differ
  std::string words(const Claim& claim) const {
    return agree(claim) ? fmt::format("agree to within {}", claim.inputs.at("agreement"))
                        : fmt::format("differ by up to {:.3g}", rounded(difference));
  }
};

Finding exp2_identity(const Claim& claim) {
  const RootsOfTwo<Decimal50> roots;
  const auto all = places<Decimal50>(claim);
  Sides sides;
  for (const Decimal50& a : all) {
    const Decimal50 truth = exp(a);
    sides.compare(exp_by_exp2(a) / truth, 1);
    sides.compare(roots.exp2(a / ln2<Decimal50>()) / truth, 1);
  }
  return {verdict_of(sides.agree(claim)), identity_if(verdict_of(sides.agree(claim))),
          told(claim, Told{"values", counted(std::ssize(all), "value")}, Told{"agree", sides.words(claim)})};
}

Finding normalised_mad(const Claim& claim) {
  const auto constant_term = constant<Decimal50>(claim.inputs.at("constant"));
  const auto factor = base_two_normalisation_factor<Decimal50>();
  Sides sides;
  for (const double s : powers(claim)) {
    const Decimal50 exponent(s), wanted = game_normalisation(exponent);
    sides.compare(base_two_normalisation(base_two_power(exponent), factor, constant_term) / wanted, 1);
  }
  const std::string_view printed = claim.inputs.at("factor");
  const std::array parts{verdict_of(sides.agree(claim)), judge(printed, {"", rounded(factor)}, {}).verdict};
  return {worst(parts), identity_if(worst(parts)),
          told(claim, Told{"exact", rounded(factor)}, Told{"agree", sides.words(claim)},
               Told{"glosses", glosses(claim)}),
          effect_on_normalisation(claim, number_of(printed), rounded(constant_term))};
}

/// The value of exp(log(c)) with it.
Effect effect_of_misprinted_log() {
  Effect effect;
  effect.show(1, exp(misprinted_log_by_log2(1.0)), at_cosine({1, 0}));
  for (const double y : search_points())
    effect.show(1 - y, exp(misprinted_log_by_log2(1 - y)), at_cosine({1 - y, y}));
  return effect;
}

Finding log2_first(const Claim& claim) {
  const RootsOfTwo<Decimal50> roots;
  const auto excess = [&](const Decimal50& u) {
    const Decimal50 a = roots.exp2(u);
    return Decimal50(log2_by_squares(Decimal50(a * ln2<Decimal50>())) - log(a));
  };
  Sides sides, formulas;
  const auto all = places<Decimal50>(claim);
  for (const Decimal50& u : all) {
    sides.compare(excess(u), 0);
    formulas.compare(misprinted_log_by_log2(roots.exp2(u)) - log(roots.exp2(u)), excess(u));
  }
  const double peak = exp(misprinted_log_by_log2(1.0));
  return {formulas.agree(claim) ? std::optional(verdict_of(sides.agree(claim))) : std::nullopt,
          fmt::format("only at a = {:.6g}", rounded(misprinted_log_is_right_at<Decimal50>())),
          told(claim, Told{"values", counted(std::ssize(all), "value")}, Told{"agree", sides.words(claim)},
               Told{"excess_at_from", rounded(excess(all.front()))},
               Told{"excess_at_to", rounded(excess(all.back()))},
               Told{"right_at", rounded(misprinted_log_is_right_at<Decimal50>())}, Told{"peak", peak}),
          sentence(effect_of_misprinted_log(), "the curve", "at k = 1, c^k computed with this logarithm")};
}

Finding log2_second(const Claim& claim) {
  const RootsOfTwo<Decimal50> roots;
  const auto all = places<Decimal50>(claim);
  Sides sides;
  for (const Decimal50& u : all) {
    for (const int divisor : {1, 3}) {
      const Decimal50 a = roots.exp2(u) / divisor;
      const Decimal50 truth = log(a), size = std::max(Decimal50(1), Decimal50(abs(truth)));
      sides.compare(log_by_log2(a) / size, truth / size);
      sides.compare(ln2<Decimal50>() * log2_by_squares(a) / size, truth / size);
    }
  }
  return {verdict_of(sides.agree(claim)), identity_if(verdict_of(sides.agree(claim))),
          told(claim, Told{"values", counted(std::ssize(all), "value")}, Told{"agree", sides.words(claim)})};
}

}  // namespace

std::vector<Evaluator> gloss_evaluators() {
  return {{"gloss-log2-constant", log2_constant},   {"gloss-ln2-over-8", ln2_over_eight},
          {"gloss-decode", gloss_decode},           {"exp2-identity", exp2_identity},
          {"gloss-normalised-mad", normalised_mad}, {"log2-identity-first", log2_first},
          {"log2-identity-second", log2_second}};
}

}  // namespace shadefit
