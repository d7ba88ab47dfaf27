#include "approx/environment_map.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "fit/decimal.hpp"
#include "fit/ledger/agreement.hpp"
#include "fit/ledger/solid_angle.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/sweep.hpp"

namespace shadefit {
namespace {

/// The powers of a chain, the finest level first.
std::string series(const std::vector<double>& powers) {
  std::string out;
  for (const double s : powers) out += (out.empty() ? "" : " ") + decimal(s, 6);
  return out;
}

/// Which places of the printed series a computed one agrees with; a place that only one of them has counts as
/// wrong.
struct Places {
  long right = 0;
  long wrong = 0;
  double worst = 1;  ///< computed over printed, the ratio furthest from 1
};

/// Powers of two are exact up to the last bits of exp2: a printed one is met within 1e-12 of itself.
Places compare_with_printed(const Quantities& printed, const std::vector<double>& powers) {
  Places places;
  for (std::size_t i = 0; i < std::max(printed.size(), powers.size()); ++i) {
    if (i >= printed.size() || i >= powers.size()) {
      ++places.wrong;
      continue;
    }
    const double ratio = powers[i] / number_of(printed[i].value);
    const bool is_right = std::abs(ratio - 1) <= 1e-12;
    ++(is_right ? places.right : places.wrong);
    if (!is_right && std::abs(std::log(ratio)) > std::abs(std::log(places.worst))) places.worst = ratio;
  }
  return places;
}

std::string effect_of(const Places& places) {
  if (places.wrong == 0) return "none";
  return counted(places.wrong, "power") + " of the series off, by a factor of up to " +
         decimal(places.worst, 4);
}

/// The powers for which the levels of a chain are made. `is_whole_quotient`: level / (levels - 1) as the
/// integers of C divide.
std::vector<double> gloss_chain(int levels, double octaves, double first_octave, bool is_whole_quotient) {
  std::vector<double> powers;
  for (int level = 0; level < levels; ++level) {
    const double gloss = is_whole_quotient ? 1.0 - level / (levels - 1)
                                           : gloss_of_level<double>(level, levels);
    powers.push_back(std::round(power_of_gloss(gloss, octaves, first_octave)));
  }
  return powers;
}

Finding evaluate_lambert(const Claim& claim) {
  const std::vector<double> widths = parse_sweep(claim.inputs.at("widths"));
  const double tolerance = number_of(claim.inputs.at("tolerance"));
  const double printed = number_of(claim.printed[0].value);
  double power = 0, gap = 0, apart = 0;
  for (const double width : widths) {
    const double last_level = std::log2(width);
    power = power_of_solid_angle(mean_texel_solid_angle(width, last_level));
    gap = std::max(gap, std::abs(power - printed));
    // the second way: the face itself, by the closed form of a texel
    apart = std::max(apart, std::abs(power - power_of_solid_angle(texel_solid_angle(-1.0, -1.0, 2.0))));
  }
  const double width = widths.front();
  const double beyond = mip_level_of_power(width, printed) - std::log2(width);
  const std::optional<Verdict> verdict =
      apart <= tolerance ? std::optional(verdict_of(gap <= tolerance)) : std::nullopt;
  return {verdict, "power = " + decimal(power, 10),
          "the last level, log2(w), is one texel of " + decimal(lobe_solid_angle(power), 10) +
              " sr, which is the lobe of power " + decimal(power, 10) + " at " +
              counted(static_cast<long>(widths.size()), "width") + " from " + decimal(widths.front(), 6) +
              " to " + decimal(widths.back(), 6) + "; the lobe of power " + decimal(printed, 6) +
              " covers " + decimal(lobe_solid_angle(printed), 10) + " sr and lies " + decimal(beyond, 6) +
              " levels beyond the last",
          gap <= tolerance
              ? "none"
              : "c^" + decimal(power, 3) + " for c^" + decimal(printed, 3) + " " +
                    effect_of_power(printed, power) + "; with both lobes scaled to the same integral the "
                    "peak is " + decimal(lobe_solid_angle(printed) / lobe_solid_angle(power), 3) +
                    " times as bright"};
}

/// A way to read "unblurred", and the power from which on it holds.
std::vector<Alternative> readings_of_unblurred(const Claim& claim) {
  const double width = number_of(claim.inputs.at("width")), size = 2 / width;
  const auto power_that_covers = [](double solid_angle) { return power_of_solid_angle(solid_angle); };
  std::vector<Alternative> readings{
      {"the lobe covers a mean texel", power_that_covers(mean_texel_solid_angle(width, 0.0))},
      {"the lobe covers a texel that touches a face's centre",
       power_that_covers(texel_solid_angle(0.0, 0.0, size))},
      {"the lobe covers a corner texel", power_that_covers(texel_solid_angle(1 - size, 1 - size, size))}};
  for (const double folds : parse_sweep(claim.inputs.at("falls by e to the minus"))) {
    // cos(theta) = 1/sqrt(1 + size^2) at the centre of the next texel
    readings.push_back({"the lobe has fallen to e^-" + decimal(folds, 3) + " at the next texel",
                        2 * folds / std::log1p(size * size)});
  }
  return readings;
}

Finding evaluate_mean_power(const Claim& claim) {
  const double width = number_of(claim.inputs.at("width"));
  const std::string_view printed = claim.printed[0].value;
  const auto digits = static_cast<std::size_t>(number_of(claim.inputs.at("significant digits")));
  const std::string_view leading = printed.substr(0, digits);
  const double unit = power(10.0, static_cast<int>(printed.size() - leading.size()));
  std::vector<Alternative> readings = readings_of_unblurred(claim);
  std::vector<std::string> words;
  for (Alternative& reading : readings) {
    words.push_back(decimal(reading.value, 6) + " where " + reading.objective);
    reading.value /= unit;
  }
  const Judgement judgement = judge(leading, readings.front(), std::span(readings).subspan(1));
  const double s = number_of(printed);
  std::string evidence = "the power is " + enumerated(words) + "; at " + decimal(s, 6) + " it covers " +
                         decimal(lobe_solid_angle(s) / mean_texel_solid_angle(width, 0.0), 4) +
                         " mean texels";
  if (judgement.verdict == Verdict::other_objective)
    evidence += "; the printed digits are those of: " + judgement.objective;
  return {judgement.verdict, "power = " + decimal(judgement.value * unit, 6), evidence,
          "a chain whose level 0 is unfiltered has the power " + decimal(s, 6) + " at level " +
              decimal(mip_level_of_power(width, s), 3) + ", by the size of a mean texel"};
}

Finding evaluate_gloss_chain(const Claim& claim) {
  const double ratio = number_of(claim.inputs.at("width")) / number_of(claim.inputs.at("last width"));
  const int levels = static_cast<int>(std::lround(std::log2(ratio))) + 1;
  const double octaves = number_of(claim.inputs.at("octaves"));
  const double first_octave = number_of(claim.inputs.at("first octave"));
  const auto by_formula = gloss_chain(levels, octaves, first_octave, false);
  const auto by_loop = gloss_chain(levels, octaves, first_octave, true);
  const Places formula = compare_with_printed(claim.printed, by_formula);
  const Places loop = compare_with_printed(claim.printed, by_loop);
  const Verdict verdict = loop.wrong == 0      ? Verdict::confirmed
                          : formula.wrong == 0 ? Verdict::conditional
                                               : Verdict::refuted;
  return {verdict, series(by_formula),
          counted(levels, "level") + ": with a quotient of real numbers " + series(by_formula) + ", " +
              counted(formula.right, "printed power") + " of " +
              decimal(static_cast<double>(claim.printed.size()), 3) +
              "; the loop as printed divides integers and yields " + series(by_loop) + ", right at " +
              counted(loop.right, "level"),
          verdict == Verdict::confirmed
              ? "none"
              : "as the loop is printed " + counted(loop.wrong, "level") +
                    " would be made for a wrong power, up to " + decimal(loop.worst, 4) +
                    " times the one meant"};
}

Finding evaluate_sphere_powers(const Claim& claim) {
  const int spheres = static_cast<int>(number_of(claim.inputs.at("spheres")));
  const auto powers = gloss_chain(spheres, number_of(claim.inputs.at("octaves")),
                                  number_of(claim.inputs.at("first octave")), false);
  const Places places = compare_with_printed(claim.printed, powers);
  return {verdict_of(places.wrong == 0), series(powers),
          counted(spheres, "gloss") + " from 1 to 0 in steps of " + decimal(1.0 / (spheres - 1), 6) +
              " have the powers " + series(powers) + ": " + counted(places.right, "power") +
              " as printed, " + decimal(static_cast<double>(places.wrong), 3) + " not",
          effect_of(places)};
}

Finding evaluate_power_drop(const Claim& claim) {
  const double first = number_of(claim.inputs.at("first power"));
  const double drop = number_of(claim.inputs.at("drop"));
  const int levels = static_cast<int>(claim.printed.size());
  std::vector<double> powers;
  for (int level = 0; level < levels; ++level) powers.push_back(power_after_drops(first, drop, level));
  const Places places = compare_with_printed(claim.printed, powers);
  const auto drop_of_gloss = [&](int count) {
    return decimal(std::exp2(-number_of(claim.inputs.at("octaves")) / (count - 1)), 4);
  };
  return {verdict_of(places.wrong == 0), series(powers),
          "the series is " + series(powers) + " and goes on with " +
              decimal(power_after_drops(first, drop, levels), 6) + "; a gloss of " +
              std::string(claim.inputs.at("octaves")) + " octaves drops by " + drop_of_gloss(levels) +
              " a level over " + counted(levels, "level") + ", by " + drop_of_gloss(levels + 2) + " over " +
              counted(levels + 2, "level"),
          effect_of(places)};
}

/// What a shader finds in a prefiltered chain for each code of a stored gloss.
struct Selection {
  double worst_ratio = 1;  ///< power found over power wanted, furthest from 1
  double wanted = 0;       ///< there
  int worst_code = 0;      ///< there
  std::vector<int> found;  ///< the codes whose power is found within a step of the gloss
};

/// `count`: what the shader multiplies 1 - g by.
Selection select_levels(const Claim& claim, double count) {
  const double levels = number_of(claim.inputs.at("levels"));
  const double octaves = number_of(claim.inputs.at("octaves"));
  const double first_octave = number_of(claim.inputs.at("first octave"));
  const int last_code = (1 << static_cast<int>(number_of(claim.inputs.at("gloss bits")))) - 1;
  Selection result;
  for (int code = 0; code <= last_code; ++code) {
    const double gloss = static_cast<double>(code) / last_code;
    const double level = level_of_gloss(gloss, count, levels - 1);
    const double wanted = power_of_gloss(gloss, octaves, first_octave);
    const double ratio = power_of_gloss(gloss_of_level(level, levels), octaves, first_octave) / wanted;
    // Codes that are exactly a step apart count: the slack is far above the rounding and below any step.
    if (std::abs(std::log2(ratio)) <= octaves / last_code + 1e-9) result.found.push_back(code);
    if (std::abs(std::log2(ratio)) > std::abs(std::log2(result.worst_ratio)) + 1e-9) {
      result.worst_ratio = ratio;
      result.wanted = wanted;
      result.worst_code = code;
    }
  }
  return result;
}

/// "0 to 1 and 250 to 255"
std::string runs_of(const std::vector<int>& codes) {
  std::vector<std::string> runs;
  for (std::size_t i = 0; i < codes.size();) {
    std::size_t last = i;
    while (last + 1 < codes.size() && codes[last + 1] == codes[last] + 1) ++last;
    runs.push_back(std::to_string(codes[i]) + (last > i ? " to " + std::to_string(codes[last]) : ""));
    i = last + 1;
  }
  return runs.empty() ? "none" : enumerated(runs);
}

Finding evaluate_mip_select(const Claim& claim) {
  const double levels = number_of(claim.inputs.at("levels"));
  const long codes = 1L << static_cast<int>(number_of(claim.inputs.at("gloss bits")));
  const Selection printed = select_levels(claim, levels), inverse = select_levels(claim, levels - 1);
  const auto all = [&](const Selection& s) { return static_cast<long>(s.found.size()) == codes; };
  const Verdict verdict = all(printed)             ? Verdict::confirmed
                          : printed.found.empty() ? Verdict::refuted
                                                   : Verdict::conditional;
  const double found = printed.wanted * printed.worst_ratio;
  return {verdict, "found / wanted = " + decimal(printed.worst_ratio, 4) + " at worst",
          "of the " + counted(codes, "gloss code") + " the power is found within one code's step at " +
              runs_of(printed.found) + "; at worst, code " + std::to_string(printed.worst_code) +
              ", it finds " + decimal(found, 4) + " where " + decimal(printed.wanted, 4) + " is wanted, " +
              decimal(printed.worst_ratio, 4) + " of it; a shader that multiplies by levels - 1 = " +
              decimal(levels - 1, 3) + " finds it at " + counted(static_cast<long>(inverse.found.size()), "code"),
          verdict == Verdict::confirmed
              ? "none"
              : "at worst " + effect_of_power(printed.wanted, found) + "; the reflection is as wide as " +
                    decimal(lobe_solid_angle(found) / lobe_solid_angle(printed.wanted), 3) +
                    " times the solid angle meant"};
}

Finding evaluate_power_range(const Claim& claim) {
  const auto input = [&](std::string_view name) { return number_of(claim.inputs.at(name)); };
  const auto steps = [](double bits) { return std::exp2(bits) - 1; };
  const double step = relative_gloss_step(input("octaves"), steps(input("bits")));
  const double range = std::log2(input("most") / input("least"));
  const auto percent = [](double share) { return decimal(100 * share, 4) + " %"; };
  const double middle = power_of_gloss(0.5, input("octaves"), input("first octave"));
  const auto bits = [&](std::string_view name) { return std::string(claim.inputs.at(name)) + " bits"; };
  const double lowest = power_of_gloss(0.0, input("octaves"), input("first octave"));
  const double highest = power_of_gloss(1.0, input("octaves"), input("first octave"));
  return {judge(claim.printed[0].value, {"", 100 * step}, {}).verdict,
          "step = " + percent(step),
          "a gloss of " + bits("bits") + " over [" + decimal(lowest, 6) + ", " + decimal(highest, 6) +
              "] steps by " + percent(step) + " of the power; over the " + decimal(range, 4) +
              " octaves from " + decimal(input("least"), 6) + " to " + decimal(input("most"), 6) + " by " +
              percent(relative_gloss_step(range, steps(input("bits")))) + ", with " + bits("more bits") +
              " by " + percent(relative_gloss_step(range, steps(input("more bits")))) +
              "; a power stored as a whole number of " + bits("bits") + " steps by " + percent(1) +
              " at 1, ends at " + decimal(steps(input("bits")), 6) + " and has no power below 1",
          "one step of the gloss at power " + decimal(middle, 4) + " " +
              effect_of_power(middle, middle * (1 + step))};
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
