#include "approx/environment_map.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "fit/ledger/light/agreement.hpp"
#include "fit/ledger/light/gloss_chain.hpp"
#include "fit/ledger/light/solid_angle.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {
namespace {

Finding evaluate_lambert(const Claim& claim) {
  const std::vector<double> widths = parse_sweep(claim.inputs.at("widths"));
  const double tolerance = given(claim, "tolerance");
  const double printed = number_of(claim.printed[0].value);
  double found = 0, gap = 0, apart = 0;
  for (const double width : widths) {
    const double last_level = std::log2(width);
    found = power_of_solid_angle(mean_texel_solid_angle(width, last_level));
    gap = std::max(gap, std::abs(found - printed));
    // the second way: the face itself, by the closed form of a texel
    apart = std::max(apart, std::abs(found - power_of_solid_angle(texel_solid_angle(-1.0, -1.0, 2.0))));
  }
  const double width = widths.front();
  const double beyond = mip_level_of_power(width, printed) - std::log2(width);
  const std::optional<Verdict> verdict =
      apart <= tolerance ? std::optional(verdict_of(gap <= tolerance)) : std::nullopt;
  return {verdict, "power = " + decimal(found, 10),
          "the last level, log2(w), is one texel of " + decimal(lobe_solid_angle(found), 10) +
              " sr, which is the lobe of power " + decimal(found, 10) + " at " +
              counted(static_cast<long>(widths.size()), "width") + " from " + decimal(widths.front(), 6) +
              " to " + decimal(widths.back(), 6) + ", by the mean and by the closed form of a face " +
              within(apart, claim.inputs.at("tolerance")) + "; the lobe of power " + decimal(printed, 6) +
              " covers " + decimal(lobe_solid_angle(printed), 10) + " sr and lies " + decimal(beyond, 6) +
              " levels beyond the last; with both lobes scaled to the same integral the peak is " +
              decimal(lobe_solid_angle(printed) / lobe_solid_angle(found), 3) + " times as bright",
          gap <= tolerance
              ? "none"
              : effect_of_power(printed, found, "c^" + decimal(found, 3) + " for c^" + decimal(printed, 3))};
}

/// A way to read "unblurred", and the power from which on it holds.
std::vector<Alternative> readings_of_unblurred(const Claim& claim) {
  const double width = given(claim, "width"), size = 2 / width;
  const auto power_that_covers = [](double solid_angle) { return power_of_solid_angle(solid_angle); };
  std::vector<Alternative> readings{
      {"a lobe that covers a mean texel", power_that_covers(mean_texel_solid_angle(width, 0.0))},
      {"a lobe that covers a texel at a face's centre", power_that_covers(texel_solid_angle(0.0, 0.0, size))},
      {"a lobe that covers a corner texel", power_that_covers(texel_solid_angle(1 - size, 1 - size, size))}};
  for (const double folds : parse_sweep(claim.inputs.at("falls by e to the minus"))) {
    readings.push_back({"a lobe that has fallen to e^-" + decimal(folds, 3) + " at the next texel",
                        power_that_falls(folds, size)});
  }
  return readings;
}

Finding evaluate_mean_power(const Claim& claim) {
  const double width = given(claim, "width");
  const std::string_view printed = claim.printed[0].value;
  const auto digits = static_cast<std::size_t>(given(claim, "significant digits"));
  const std::string_view leading = printed.substr(0, digits);
  const double unit = power(10.0, static_cast<int>(printed.size() - leading.size()));
  std::vector<Alternative> readings = readings_of_unblurred(claim);
  std::vector<std::string> words;
  for (Alternative& reading : readings) {
    words.push_back(decimal(reading.value, 6) + " for " + reading.objective);
    reading.value /= unit;
  }
  // The source names no criterion, so each reading is a convention that the digits may come from.
  const Judgement closest = judge(leading, readings.front(), std::span(readings).subspan(1));
  const double s = number_of(printed);
  std::string evidence = "s = " + enumerated(words) + "; at " + decimal(s, 6) + " the lobe covers " +
                         decimal(lobe_solid_angle(s) / mean_texel_solid_angle(width, 0.0), 4) +
                         " mean texels and belongs to level " + decimal(mip_level_of_power(width, s), 3);
  if (closest.verdict == Verdict::other_objective)
    evidence += "; of these " + counted(static_cast<long>(readings.size()), "reading") + " the first " +
                counted(static_cast<long>(digits), "printed digit") + " are those of " + closest.objective;
  const double covering = readings.front().value * unit;
  return {closest.verdict, "power = " + decimal(closest.value * unit, 6), evidence,
          effect_of_power(s, covering,
                          "an unfiltered level 0, whose mean texel is a lobe of power " +
                              decimal(covering, 6) + ", in the place of " + decimal(s, 6))};
}

Finding evaluate_power_range(const Claim& claim) {
  const auto input = [&](std::string_view name) { return given(claim, name); };
  const auto steps = [](double bits) { return std::exp2(bits) - 1; };
  const double step = relative_gloss_step(input("octaves"), steps(input("bits")));
  const double range = std::log2(input("most") / input("least"));
  const auto percent = [](double share) { return decimal(100 * share, 5) + " %"; };
  const double middle = decode_gloss(0.5, input("octaves"), input("first octave"));
  const auto bits = [&](std::string_view name) { return std::string(claim.inputs.at(name)) + " bits"; };
  const double lowest = decode_gloss(0.0, input("octaves"), input("first octave"));
  const double highest = decode_gloss(1.0, input("octaves"), input("first octave"));
  return {
      judge(claim.printed[0].value, {"", 100 * step}, {}).verdict, "step = " + percent(step),
      "a gloss of " + bits("bits") + " over [" + decimal(lowest, 6) + ", " + decimal(highest, 6) +
          "] steps by " + percent(step) + " of the power; over the " + decimal(range, 4) + " octaves from " +
          decimal(input("least"), 6) + " to " + decimal(input("most"), 6) + " by " +
          percent(relative_gloss_step(range, steps(input("bits")))) + ", with " + bits("more bits") + " by " +
          percent(relative_gloss_step(range, steps(input("more bits")))) +
          "; a power stored as a whole number of " + bits("bits") + " steps by " + percent(1) +
          " at 1, ends at " + decimal(steps(input("bits")), 6) + " and has no power below 1",
      effect_of_power(middle, middle * (1 + step), "one step of the gloss at power " + decimal(middle, 4))};
}

}  // namespace

std::span<const Evaluator> environment_map_evaluators() {
  static constexpr std::array evaluators{Evaluator{"cap-solid-angle", evaluate_cap},
                                         Evaluator{"lobe-solid-angle", evaluate_lobe},
                                         Evaluator{"texel-solid-angle", evaluate_texel},
                                         Evaluator{"mip-level", evaluate_mip_level},
                                         Evaluator{"mip-lambert", evaluate_lambert},
                                         Evaluator{"mip-mean-power", evaluate_mean_power},
                                         Evaluator{"mip-gloss-chain", evaluate_gloss_chain},
                                         Evaluator{"mip-sphere-powers", evaluate_sphere_powers},
                                         Evaluator{"mip-power-drop", evaluate_power_drop},
                                         Evaluator{"mip-select", evaluate_mip_select},
                                         Evaluator{"power-range", evaluate_power_range}};
  return evaluators;
}

}  // namespace shadefit
