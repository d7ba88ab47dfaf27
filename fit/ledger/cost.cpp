#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fit/errors/effect.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"

namespace shadefit {
namespace {

/// The instructions of a text such as "SUB LOG2 MUL EXP2". Throws std::invalid_argument for an unknown one.
Operations instructions_of(std::string_view text) {
  struct Named {
    std::string_view name;
    int Operations::*count;
  };
  static constexpr std::array known{
      Named{"ADD", &Operations::add},      Named{"SUB", &Operations::add},
      Named{"MUL", &Operations::multiply}, Named{"MAD", &Operations::multiply_add},
      Named{"EXP2", &Operations::exp2},    Named{"LOG2", &Operations::log2},
      Named{"DOT3", &Operations::dot3},    Named{"DOT4", &Operations::dot4}};
  Operations found;
  for (const std::string& word : items_of(text, ' ')) {
    const auto named = std::ranges::find(known, word, &Named::name);
    if (named == known.end()) throw std::invalid_argument(fmt::format("no instruction '{}'", word));
    ++(found.*(named->count));
  }
  return found;
}

/// The printed instructions of a form: their number and their names.
struct PrintedCount {
  double total;
  Operations instructions;

  /// The i-th form of a claim: its printed quantities are a number and a list, in turn.
  static PrintedCount of(const Claim& claim, std::size_t i) {
    return {number_of(claim.printed[2 * i].value), instructions_of(claim.printed[2 * i + 1].value)};
  }
  bool is(const Operations& counted) const { return counted.total() == total && counted == instructions; }
};

Symbolic form_of(std::string_view formula) {
  return read_formula(formula, {.variables = {}, .takes_parameters = true}).formula;
}

Operations count_form(std::string_view formula, const InstructionSet& instructions = {}) {
  return count_operations(form_of(formula), instructions);
}

/// "MAD, EXP2 (2)".
std::string with_total(const Operations& count) {
  return fmt::format("{} ({})", to_text(count), count.total());
}

/// "exp2(A c - A) is MAD, EXP2 (2)".
std::string sentence_of(std::string_view formula, const Operations& count) {
  return fmt::format("{} is {}", to_text(form_of(formula)), with_total(count));
}

/// ". Compilers emit .. for pow (..)", or nothing if no form was compiled.
std::string compiled_text(const Claim& claim) {
  const auto compiled = std::ranges::find(claim.inputs, "compiled", &Quantity::name);
  if (compiled == claim.inputs.end()) return "";
  return fmt::format(
      ". Compilers emit this many instructions, vector arithmetic + transcendental: {} (own measurement: nvcc "
      "13.0.88 -arch=sm_75 --use_fast_math; clang 19.1.7 -mcpu=gfx1030 -cl-denorms-are-zero)",
      compiled->value);
}

/// A wrong count in words: "1 instruction more than printed".
std::string effect_of_count(double printed, int counted_total) {
  const double difference = counted_total - printed;
  if (difference == 0) return "the number is right, but the instructions differ";
  return fmt::format("{}{} than printed", counted(std::lround(std::abs(difference)), "instruction"),
                     difference > 0 ? " more" : " fewer");
}

/// A count changes no picture, so its meaning is the reason of a "none".
std::string effect_of_counts(const std::vector<std::string>& meanings) {
  return meanings.empty() ? "none"
                          : none_because(fmt::format("no value changes; {}", fmt::join(meanings, "; ")));
}

/// Each printed count belongs to the formula of the input at the same place.
Finding count_forms(const Claim& claim) {
  std::vector<Verdict> verdicts;
  std::vector<std::string> computed, evidence, effects;
  for (std::size_t i = 0; i < claim.printed.size() / 2; ++i) {
    const auto& [what, form] = claim.inputs[i];
    const Operations count = count_form(form);
    const PrintedCount printed = PrintedCount::of(claim, i);
    verdicts.push_back(verdict_of(printed.is(count)));
    computed.push_back(fmt::format("{}: {}", what, with_total(count)));
    evidence.push_back(sentence_of(form, count));
    if (!printed.is(count))
      effects.push_back(fmt::format("{}: {}", what, effect_of_count(printed.total, count.total())));
  }
  return {worst(verdicts), fmt::format("{}", fmt::join(computed, "; ")),
          sentences(evidence) + compiled_text(claim), effect_of_counts(effects)};
}

/// A count under a named convention.
struct CountingConvention {
  std::string name;
  Operations count;
};

/// `confirmed` if the formula as written has the printed instructions, `other-objective` if it has them under
/// a convention. `rounding` does not apply to a count.
Verdict judge_count(const PrintedCount& printed, const Operations& as_written,
                    std::span<const CountingConvention> conventions) {
  if (printed.is(as_written)) return Verdict::confirmed;
  for (const CountingConvention& convention : conventions) {
    if (printed.is(convention.count)) return Verdict::other_objective;
  }
  return Verdict::refuted;
}

/// "; with s + 1 given it is MAD, LOG2 (2), as printed".
std::string conventions_text(const PrintedCount& printed, std::span<const CountingConvention> conventions) {
  std::string out;
  for (const auto& [name, count] : conventions)
    out += fmt::format("; {} it is {}{}", name, with_total(count), printed.is(count) ? ", as printed" : "");
  return out;
}

Finding mip_level_cost(const Claim& claim) {
  const std::string_view form = claim.inputs.at("level"), with_sum = claim.inputs.at("level, s + 1 given");
  const Operations count = count_form(form);
  const std::array conventions{CountingConvention{"with s + 1 given", count_form(with_sum)}};
  const PrintedCount printed = PrintedCount::of(claim, 0);
  const Verdict verdict = judge_count(printed, count, conventions);
  return {verdict, with_total(count), sentence_of(form, count) + conventions_text(printed, conventions),
          verdict == Verdict::confirmed
              ? "none"
              : effect_of_counts({fmt::format("{}: {} per pixel, unless s + 1 is stored",
                                              effect_of_count(printed.total, count.total()),
                                              to_text(count - conventions.front().count))})};
}

Finding power_four_cost(const Claim& claim) {
  InstructionSet with_scales;
  with_scales.free_scales = numbers_of(claim.inputs.at("free scales of a result"), ' ');
  const std::string_view form = claim.inputs.at("by exp2"), squared = claim.inputs.at("by squaring");
  const Operations count = count_form(form), scaled = count_form(form, with_scales);
  const Operations squaring = count_form(squared);
  const std::array conventions{
      CountingConvention{"with a free scale of the result", scaled},
      CountingConvention{"with 1 - c also given",
                         count_form(claim.inputs.at("by exp2, 1 - c given"), with_scales)}};
  const PrintedCount printed = PrintedCount::of(claim, 0), printed_squaring = PrintedCount::of(claim, 1);
  const std::array verdicts{judge_count(printed, count, conventions),
                            verdict_of(printed_squaring.is(squaring))};
  return {
      worst(verdicts), fmt::format("{}; {}", with_total(count), with_total(squaring)),
      fmt::format("{}{}. {} by squaring is {}", sentence_of(form, count),
                  conventions_text(printed, conventions), to_text(form_of(squared)), with_total(squaring)),
      effect_of_counts({fmt::format(
          "with the subtraction counted on both sides, the count is {} with the free scale and {} by squaring. The "
          "free scale saves {}; the source says {}",
          scaled.total(), squaring.total(), counted(squaring.total() - scaled.total(), "instruction"),
          counted(std::lround(printed_squaring.total - printed.total), "instruction"))})};
}

Finding light_cost(const Claim& claim) {
  const int lights = static_cast<int>(given(claim, "lights"));
  const auto of_lights = [](std::string_view formula, int count, const InstructionSet& instructions) {
    std::vector<Symbolic> results;
    for (int i = 0; i < count; ++i)
      results.push_back(form_of(boost::replace_all_copy(std::string(formula), "l0", fmt::format("l{}", i))));
    return count_operations(results, instructions);
  };
  const auto per_light = [&](std::string_view formula, const InstructionSet& instructions) {
    return of_lights(formula, lights, instructions) - of_lights(formula, lights - 1, instructions);
  };
  const std::string_view form = claim.inputs.at("per light"), other = claim.inputs.at("with pow");
  const InstructionSet vector{.dot_products = true};
  const Operations count = per_light(form, vector), scalar = per_light(form, {}),
                   pow = per_light(other, vector);
  const PrintedCount printed = PrintedCount::of(claim, 0);
  return {verdict_of(printed.is(count)), with_total(count),
          fmt::format(
              "the last of {}, {}, adds {}; with {} it adds {}. Without dot products they add {} and {}{}",
              counted(lights, "light"), to_text(form_of(form)), with_total(count), to_text(form_of(other)),
              with_total(pow), with_total(scalar), with_total(per_light(other, {})), compiled_text(claim)),
          printed.is(count) ? "none" : effect_of_counts({effect_of_count(printed.total, count.total())})};
}

Finding saved_cost(const Claim& claim) {
  const auto total = [&](std::string_view input) { return count_form(claim.inputs.at(input)).total(); };
  const auto from_to = [](int before, int after) {
    return fmt::format("{} instructions instead of {}", after, before);
  };
  const auto percent = [](int before, int after) { return 100.0 * (before - after) / before; };
  const int pow = total("with pow"), gaussian = total("with the Gaussian");
  const int fresnel_pow = total("Fresnel with pow"), one_term = total("Fresnel with one term");
  const int whole_pow = total("whole Fresnel with pow"), whole = total("whole Fresnel with one term");
  const double printed = number_of(claim.printed[0].value), saved = percent(fresnel_pow, one_term);
  const std::array verdicts{verdict_of(printed == pow - gaussian),
                            judge(claim.printed[1].value, {"(1-c)^5", saved}, {}).verdict};
  return {
      worst(verdicts), fmt::format("{}; {:.4g} %", pow - gaussian, saved),
      fmt::format(
          "decode, lobe, normalisation and product take {}. (1-c)^5 takes {}: {:.4g} % less. The whole F0 + "
          "(1 - F0) (1-c)^5 takes {}: {:.2g} % less{}",
          from_to(pow, gaussian), from_to(fresnel_pow, one_term), saved, from_to(whole_pow, whole),
          percent(whole_pow, whole), compiled_text(claim)),
      printed == pow - gaussian ? "none" : effect_of_counts({effect_of_count(printed, pow - gaussian)})};
}

}  // namespace

std::vector<Evaluator> cost_evaluators() {
  return {{"cost-pow", count_forms},
          {"cost-sg", count_forms},
          {"cost-gloss-decode", count_forms},
          {"cost-saved", saved_cost},
          {"cost-power-four", power_four_cost},
          {"cost-phong-per-light", light_cost},
          {"cost-fresnel", count_forms},
          {"cost-mip", mip_level_cost}};
}

}  // namespace shadefit
