#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <initializer_list>
#include <stdexcept>

#include "fit/formula/parse_formula.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/scalars/symbolic.hpp"

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

/// Each printed count belongs to the formula of the input at the same place.
Finding count_forms(const Claim& claim) {
  std::vector<Verdict> verdicts;
  std::vector<std::string> counts, forms;
  for (std::size_t i = 0; i < claim.printed.size() / 2; ++i) {
    const auto& [what, form] = claim.inputs[i];
    const Operations count = count_form(form);
    verdicts.push_back(verdict_of(PrintedCount::of(claim, i).is(count)));
    counts.push_back(fmt::format("{}: {}", what, with_total(count)));
    forms.push_back(sentence_of(form, count));
  }
  return told(claim, worst(verdicts), "none", Told{"counts", fmt::format("{}", fmt::join(counts, "; "))},
              Told{"forms", sentences(forms)});
}

/// `confirmed` if the formula as written has the printed instructions, `other-objective` if it has them under
/// a convention. `rounding` does not apply to a count.
Verdict judge_count(const PrintedCount& printed, const Operations& as_written,
                    std::initializer_list<Operations> under_conventions) {
  const auto is = [&](const Operations& count) { return printed.is(count); };
  return is(as_written)                               ? Verdict::confirmed
         : std::ranges::any_of(under_conventions, is) ? Verdict::other_objective
                                                      : Verdict::refuted;
}

Finding mip_level_cost(const Claim& claim) {
  const std::string_view form = claim.inputs.at("level");
  const Operations count = count_form(form), with_sum = count_form(claim.inputs.at("level, s + 1 given"));
  const PrintedCount printed = PrintedCount::of(claim, 0);
  return told(
      claim, judge_count(printed, count, {with_sum}),
      fmt::format("none: no value changes; {} more than printed: {} per pixel, unless s + 1 is stored",
                  counted(count.total() - std::lround(printed.total), "instruction"),
                  to_text(count - with_sum)),
      Told{"form", sentence_of(form, count)}, Told{"count", with_total(count)},
      Told{"with_sum", with_total(with_sum)});
}

Finding power_four_cost(const Claim& claim) {
  InstructionSet with_scales;
  with_scales.free_scales = numbers_of(claim.inputs.at("free scales of a result"), ' ');
  const std::string_view form = claim.inputs.at("by exp2"), squared = claim.inputs.at("by squaring");
  const Operations count = count_form(form), scaled = count_form(form, with_scales);
  const Operations given_y = count_form(claim.inputs.at("by exp2, 1 - c given"), with_scales);
  const Operations squaring = count_form(squared);
  const PrintedCount printed = PrintedCount::of(claim, 0), printed_squaring = PrintedCount::of(claim, 1);
  const std::array verdicts{judge_count(printed, count, {scaled, given_y}),
                            verdict_of(printed_squaring.is(squaring))};
  return told(
      claim, worst(verdicts),
      fmt::format(
          "none: no value changes; with the subtraction counted on both sides, the count is {} with the free scale and {} by "
          "squaring. The free scale saves {}; the source says {}",
          scaled.total(), squaring.total(), counted(squaring.total() - scaled.total(), "instruction"),
          counted(std::lround(printed_squaring.total - printed.total), "instruction")),
      Told{"form", sentence_of(form, count)}, Told{"count", with_total(count)},
      Told{"scaled", with_total(scaled)}, Told{"given_y", with_total(given_y)},
      Told{"squared", to_text(form_of(squared))}, Told{"squaring", with_total(squaring)});
}

Finding light_cost(const Claim& claim) {
  const int lights = static_cast<int>(given(claim, "lights"));
  const auto of_lights = [](std::string_view formula, int count, const InstructionSet& instructions) {
    std::vector<Symbolic> results;
    for (int i = 0; i < count; ++i)
      results.push_back(form_of(boost::replace_all_copy(std::string(formula), "l0", fmt::format("l{}", i))));
    return count_operations(results, instructions);
  };
  const auto per_light = [&](std::string_view input, bool dot_products) {
    const std::string_view formula = claim.inputs.at(input);
    const InstructionSet set{.dot_products = dot_products};
    return of_lights(formula, lights, set) - of_lights(formula, lights - 1, set);
  };
  const Operations count = per_light("per light", true);
  return told(claim, verdict_of(PrintedCount::of(claim, 0).is(count)), "none",
              Told{"count", with_total(count)},
              Told{"with_pow_count", with_total(per_light("with pow", true))},
              Told{"scalar", with_total(per_light("per light", false))},
              Told{"scalar_pow", with_total(per_light("with pow", false))});
}

Finding saved_cost(const Claim& claim) {
  const auto total = [&](std::string_view input) { return count_form(claim.inputs.at(input)).total(); };
  const int pow = total("with pow"), gaussian = total("with the Gaussian");
  const int fresnel_pow = total("Fresnel with pow"), one_term = total("Fresnel with one term");
  const double percent = 100.0 * (fresnel_pow - one_term) / fresnel_pow;
  const std::array verdicts{verdict_of(number_of(claim.printed[0].value) == pow - gaussian),
                            judge(claim.printed[1].value, {"", percent}, {}).verdict};
  return told(claim, worst(verdicts), "none", Told{"by_pow", pow}, Told{"by_gaussian", gaussian},
              Told{"fresnel_pow", fresnel_pow}, Told{"one_term", one_term}, Told{"percent", percent},
              Told{"whole_pow", total("whole Fresnel with pow")},
              Told{"whole", total("whole Fresnel with one term")});
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
