#include "approx/gloss.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "approx/cosine.hpp"
#include "approx/lobe.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/binary_logarithm.hpp"
#include "fit/scalars/multiprecision.hpp"

namespace shadefit {
namespace {

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

/// Two sides of an identity at some places: the largest difference, and whether it is rounding.
struct Sides {
  std::string_view tolerance = "1e-45";  ///< of 50 digits, for values of the order of one
  Decimal50 difference = 0;

  void compare(const Decimal50& left, const Decimal50& right) {
    difference = std::max(difference, Decimal50(abs(left - right)));
  }
  bool agree() const { return difference < constant<Decimal50>(tolerance); }
  /// "agree to within 1e-45", or by how much they differ
  std::string words() const {
    return agree() ? fmt::format("agree to within {}", tolerance)
                   : fmt::format("differ by up to {:.3g}", rounded(difference));
  }
};

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

/// A printed constant that two methods compute.
Finding told_constant(const Claim& claim, const Decimal50& exact, const Decimal50& other,
                      const std::string& effect) {
  Sides methods;
  methods.compare(exact, other);
  return told(claim, judge_known_to(claim.printed[0].value, rounded(exact), rounded(abs(exact - other))),
              effect, Told{"exact", rounded(exact)}, Told{"agree", methods.words()},
              Told{"glosses", glosses(claim)});
}

Finding log2_constant(const Claim& claim) {
  const auto first = constant<Decimal50>(claim.inputs.at("first"));
  const Decimal50 exact = base_two_first(first);
  const Decimal50 other = first + log2_by_squares(Decimal50(1 / ln2<Decimal50>()));
  // 2^(10 g + constant) over 2^(10 g + first)/ln 2
  const Decimal50 ratio = exp2(Decimal50(constant<Decimal50>(claim.printed[0].value) - exact));
  return told_constant(claim, exact, other, effect_on_lobe(claim, rounded(ratio)));
}

/// The effect of a printed factor on the normalisation, at the worst gloss.
std::string effect_on_normalisation(const Claim& claim, double factor, double constant_term) {
  const auto printed = [&](double exponent) {
    return base_two_normalisation(base_two_power(exponent), factor, constant_term);
  };
  const auto all = powers(claim);
  const double worst = *std::ranges::max_element(
      all, {}, [&](double power) { return std::abs(printed(power) / game_normalisation(power) - 1); });
  return effect_of_factor(
      printed(worst), game_normalisation(worst),
      fmt::format("the error of the normalisation is largest at the power {:.5g}: there the normalisation",
                  worst));
}

Finding ln2_over_eight(const Claim& claim) {
  const auto exact = base_two_normalisation_factor<Decimal50>();
  const Decimal50 other = 1 / (8 * log2_by_squares(exp(Decimal50(1))));
  return told_constant(
      claim, exact, other,
      effect_on_normalisation(claim, number_of(claim.printed[0].value), game_normalisation(0.0)));
}

Finding gloss_decode(const Claim& claim) {
  const RootsOfTwo<Decimal50> roots;
  const auto decode = [&](std::string_view gloss) {
    return rounded(roots.exp2(constant<Decimal50>(claim.inputs.at("doublings")) *
                                  constant<Decimal50>(claim.inputs.at(gloss)) +
                              constant<Decimal50>(claim.inputs.at("first"))));
  };
  const double lowest = decode("from"), highest = decode("to");
  const std::array parts{judge_known_to(claim.printed.at("lowest"), lowest, 0),
                         judge_known_to(claim.printed.at("highest"), highest, 0)};
  return told(claim, worst(parts), "none", Told{"low", lowest}, Told{"high", highest},
              Told{"rises", lowest < highest ? "rises" : "does not rise"});
}

Finding exp2_identity(const Claim& claim) {
  const RootsOfTwo<Decimal50> roots;
  Sides sides{claim.inputs.at("agreement")};
  for (const Decimal50& a : places<Decimal50>(claim)) {
    const Decimal50 truth = exp(a);
    sides.compare(exp_by_exp2(a) / truth, 1);
    sides.compare(roots.exp2(a / ln2<Decimal50>()) / truth, 1);
  }
  return told(claim, verdict_of(sides.agree()), "none", Told{"agree", sides.words()});
}

Finding normalised_mad(const Claim& claim) {
  const auto constant_term = constant<Decimal50>(claim.inputs.at("constant"));
  const auto factor = base_two_normalisation_factor<Decimal50>();
  Sides sides{claim.inputs.at("agreement")};
  for (const double s : powers(claim)) {
    const Decimal50 exponent(s), wanted = game_normalisation(exponent);
    sides.compare(base_two_normalisation(base_two_power(exponent), factor, constant_term) / wanted, 1);
  }
  const std::string_view printed = claim.inputs.at("factor");
  const std::array parts{verdict_of(sides.agree()), judge(printed, {"", rounded(factor)}, {}).verdict};
  return told(claim, worst(parts), effect_on_normalisation(claim, number_of(printed), rounded(constant_term)),
              Told{"exact", rounded(factor)}, Told{"agree", sides.words()}, Told{"glosses", glosses(claim)});
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
  Sides sides{claim.inputs.at("agreement")}, formulas;
  const auto all = places<Decimal50>(claim);
  for (const Decimal50& u : all) {
    sides.compare(excess(u), 0);
    formulas.compare(misprinted_log_by_log2(roots.exp2(u)) - log(roots.exp2(u)), excess(u));
  }
  return told(claim, formulas.agree() ? std::optional(verdict_of(sides.agree())) : std::nullopt,
              sentence(effect_of_misprinted_log(), "the curve", "at k = 1, c^k computed with this logarithm"),
              Told{"agree", sides.words()}, Told{"excess_at_from", rounded(excess(all.front()))},
              Told{"excess_at_to", rounded(excess(all.back()))},
              Told{"right_at", rounded(misprinted_log_is_right_at<Decimal50>())},
              Told{"peak", exp(misprinted_log_by_log2(1.0))});
}

Finding log2_second(const Claim& claim) {
  const RootsOfTwo<Decimal50> roots;
  Sides sides{claim.inputs.at("agreement")};
  for (const Decimal50& u : places<Decimal50>(claim)) {
    for (const int divisor : {1, 3}) {
      const Decimal50 a = roots.exp2(u) / divisor;
      const Decimal50 truth = log(a), size = std::max(Decimal50(1), Decimal50(abs(truth)));
      sides.compare(log_by_log2(a) / size, truth / size);
      sides.compare(ln2<Decimal50>() * log2_by_squares(a) / size, truth / size);
    }
  }
  return told(claim, verdict_of(sides.agree()), "none", Told{"agree", sides.words()});
}

}  // namespace

std::vector<Evaluator> gloss_evaluators() {
  return {{"gloss-log2-constant", log2_constant},   {"gloss-ln2-over-8", ln2_over_eight},
          {"gloss-decode", gloss_decode},           {"exp2-identity", exp2_identity},
          {"gloss-normalised-mad", normalised_mad}, {"log2-identity-first", log2_first},
          {"log2-identity-second", log2_second}};
}

}  // namespace shadefit
