#include "approx/cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fit/errors/effect.hpp"
#include "fit/ledger/lobes/shader_forms.hpp"
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

Operations count_form(std::string_view name, const InstructionSet& instructions = {}) {
  return count_operations(shader_form(name), instructions);
}

std::string text_of_form(std::string_view name) {
  return to_text(shader_form(name).front());
}

/// "MAD, EXP2 (2)".
std::string with_total(const Operations& count) {
  return fmt::format("{} ({})", to_text(count), count.total());
}

/// ". Compilers emit .. for pow (..)", or nothing if no form was compiled.
std::string compiled_text(const std::vector<std::string_view>& forms) {
  std::vector<std::string> words;
  const auto pair = [](int alu, int transcendental) { return fmt::format("{}+{}", alu, transcendental); };
  for (const std::string_view form : forms) {
    for (const CompiledCost& cost : compiled_costs) {
      if (cost.form != form) continue;
      const std::string nvidia = pair(cost.nvidia_alu, cost.nvidia_transcendental);
      const std::string amd = pair(cost.amd_alu, cost.amd_transcendental);
      words.push_back(fmt::format("{} {}{}", form, nvidia, nvidia == amd ? "" : fmt::format(" and {}", amd)));
    }
  }
  if (words.empty()) return "";
  return fmt::format(
      ". Compilers emit this many instructions, vector arithmetic + transcendental: {} (own measurement: {}; "
      "{})",
      enumerated(words), nvidia_compiler, amd_compiler);
}

/// A wrong count in words: "1 instruction more than printed".
std::string effect_of_count(double printed, int counted_total) {
  const double difference = counted_total - printed;
  if (difference == 0) return "the number is right, but the instructions differ";
  return fmt::format("{}{} than printed", counted(std::lround(std::abs(difference)), "instruction"),
                     difference > 0 ? " more" : " fewer");
}

/// The parts of a finding, joined in order. A count changes no picture, so its meaning is the reason of a
/// "none".
struct Parts {
  std::vector<Verdict> verdicts;
  std::vector<std::string> computed, effects;
  std::string evidence;

  void add(Verdict verdict, const std::string& value, const std::string& sentence,
           const std::string& what = "") {
    verdicts.push_back(verdict);
    computed.push_back(value);
    evidence = sentences({evidence, sentence});
    if (!what.empty()) effects.push_back(what);
  }
  Finding finding(const std::string& context) const {
    return {worst(verdicts), fmt::format("{}", fmt::join(computed, "; ")), evidence + context,
            effects.empty() ? "none"
                            : none_because(fmt::format("no value changes; {}", fmt::join(effects, "; ")))};
  }
};

/// Each printed count belongs to the form that the input at the same place names.
Finding count_forms(const Claim& claim) {
  Parts parts;
  std::vector<std::string_view> forms;
  for (std::size_t i = 0; i < claim.inputs.size(); ++i) {
    const auto& [what, form] = claim.inputs[i];
    const Operations count = count_form(form);
    const PrintedCount printed = PrintedCount::of(claim, i);
    const bool is_right = printed.is(count);
    parts.add(verdict_of(is_right), fmt::format("{}: {}", what, with_total(count)),
              fmt::format("{} is {}", text_of_form(form), with_total(count)),
              is_right ? "" : fmt::format("{}: {}", what, effect_of_count(printed.total, count.total())));
    forms.push_back(form);
  }
  return parts.finding(compiled_text(forms));
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
  Parts parts;
  parts.add(verdict, with_total(count),
            fmt::format("{} is {}{}", text_of_form(form), with_total(count),
                        conventions_text(printed, conventions)),
            verdict == Verdict::confirmed ? ""
                                          : fmt::format("{}: {} per pixel, unless s + 1 is stored",
                                                        effect_of_count(printed.total, count.total()),
                                                        to_text(count - conventions.front().count)));
  return parts.finding("");
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
  Parts parts;
  parts.add(judge_count(printed, count, conventions), with_total(count),
            fmt::format("{} is {}{}", text_of_form(form), with_total(count),
                        conventions_text(printed, conventions)));
  parts.add(verdict_of(printed_squaring.is(squaring)), with_total(squaring),
            fmt::format("{} by squaring is {}", text_of_form(squared), with_total(squaring)));
  parts.effects.push_back(fmt::format(
      "with the subtraction counted on both sides, the count is {} with the free scale and {} by squaring. The "
      "free scale saves {}; the source says {}",
      scaled.total(), squaring.total(), counted(squaring.total() - scaled.total(), "instruction"),
      counted(std::lround(printed_squaring.total - printed.total), "instruction")));
  return parts.finding("");
}

Finding light_cost(const Claim& claim) {
  const int lights = static_cast<int>(given(claim, "lights"));
  const auto per_light = [&](std::string_view form, const InstructionSet& instructions) {
    return count_operations(shader_form(form, lights), instructions) -
           count_operations(shader_form(form, lights - 1), instructions);
  };
  const std::string_view form = claim.inputs.at("per light"), other = claim.inputs.at("with pow");
  const InstructionSet vector{.dot_products = true};
  const Operations count = per_light(form, vector), scalar = per_light(form, {}),
                   pow = per_light(other, vector);
  const PrintedCount printed = PrintedCount::of(claim, 0);
  const bool is_right = printed.is(count);
  Parts parts;
  parts.add(
      verdict_of(is_right), with_total(count),
      fmt::format("the last of {}, {}, adds {}; with {} it adds {}. Without dot products they add {} and {}",
                  counted(lights, "light"), text_of_form(form), with_total(count), text_of_form(other),
                  with_total(pow), with_total(scalar), with_total(per_light(other, {}))),
      is_right ? "" : effect_of_count(printed.total, count.total()));
  return parts.finding(compiled_text({form, other}));
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
  const bool is_saved = number_of(claim.printed[0].value) == pow - gaussian;
  Parts parts;
  parts.add(verdict_of(is_saved), std::to_string(pow - gaussian),
            fmt::format("decode, lobe, normalisation and product take {}", from_to(pow, gaussian)),
            is_saved ? "" : effect_of_count(number_of(claim.printed[0].value), pow - gaussian));
  parts.add(
      judge(claim.printed[1].value, {"(1-c)^5", percent(fresnel_pow, one_term)}, {}).verdict,
      fmt::format("{:.4g} %", percent(fresnel_pow, one_term)),
      fmt::format("(1-c)^5 takes {}: {:.4g} % less. The whole F0 + (1 - F0) (1-c)^5 takes {}: {:.2g} % less",
                  from_to(fresnel_pow, one_term), percent(fresnel_pow, one_term), from_to(whole_pow, whole),
                  percent(whole_pow, whole)));
  return parts.finding(
      compiled_text({claim.inputs.at("Fresnel with pow"), claim.inputs.at("Fresnel with one term")}));
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
