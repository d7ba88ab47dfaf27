#include "approx/environment_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fit/ledger/topics.hpp"

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
    // the second method: the face itself, by the closed form of a texel
    apart = std::max(apart, std::abs(found - power_of_solid_angle(texel_solid_angle(-1.0, -1.0, 2.0))));
  }
  const std::optional<Verdict> verdict =
      apart <= tolerance ? std::optional(verdict_of(gap <= tolerance)) : std::nullopt;
  return told(claim, verdict,
              effect_of_power(printed, found, fmt::format("c^{:.3g} for c^{:.3g}", found, printed)),
              Told{"found", found}, Told{"agree", within(apart, claim.inputs.at("tolerance"))},
              Told{"beyond", mip_level_of_power(widths[0], printed) - std::log2(widths[0])});
}

/// A meaning of "unblurred", and the power from which on it holds.
std::vector<Alternative> readings_of_unblurred(const Claim& claim) {
  const double width = given(claim, "width"), size = 2 / width;
  const auto power_that_covers = [](double solid_angle) { return power_of_solid_angle(solid_angle); };
  std::vector<Alternative> readings{
      {"a lobe that covers a mean texel", power_that_covers(mean_texel_solid_angle(width, 0.0))},
      {"a lobe that covers a texel at a face's centre", power_that_covers(texel_solid_angle(0.0, 0.0, size))},
      {"a lobe that covers a corner texel", power_that_covers(texel_solid_angle(1 - size, 1 - size, size))}};
  for (const double folds : parse_sweep(claim.inputs.at("falls by e to the minus"))) {
    readings.push_back({fmt::format("a lobe that has fallen to e^-{:.3g} at the next texel", folds),
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
    words.push_back(fmt::format("{:.6g} for {}", reading.value, reading.objective));
    reading.value /= unit;
  }
  // The source names no criterion, so each meaning is a convention that may give the digits.
  const Judgement closest = judge(leading, readings.front(), std::span(readings).subspan(1));
  const double s = number_of(printed), covering = readings.front().value * unit;
  return told(
      claim, closest.verdict,
      effect_of_power(
          s, covering,
          fmt::format("an unfiltered level 0, whose mean texel covers as much as a lobe of power {:.6g}, "
                      "instead of power {:.6g}",
                      covering, s)),
      Told{"closest", closest.value * unit}, Told{"reading", closest.objective},
      Told{"words", enumerated(words)}, Told{"readings", readings.size()},
      Told{"covers", lobe_solid_angle(s) / mean_texel_solid_angle(width, 0.0)},
      Told{"level", mip_level_of_power(width, s)});
}

Finding evaluate_power_range(const Claim& claim) {
  const double octaves = given(claim, "octaves");
  const double step = relative_gloss_step(octaves, std::exp2(given(claim, "bits")) - 1);
  const double middle = decode_gloss(0.5, octaves, given(claim, "first octave"));
  return told(claim, judge(claim.printed[0].value, {"", 100 * step}, {}).verdict,
              effect_of_power(middle, middle * (1 + step),
                              fmt::format("one step of the gloss at power {:.4g}", middle)),
              Told{"share", step});
}

/// The powers of a chain, the finest level first.
std::string series(const std::vector<double>& powers) {
  return fmt::format("{:.6g}", fmt::join(powers, " "));
}

/// The places where a computed series agrees with the printed one. A place that only one of them has counts
/// as wrong.
struct Places {
  long right = 0;
  long wrong = 0;
  double worst = 1;   ///< computed over printed, the ratio furthest from 1
  double wanted = 1;  ///< the printed one there
};

/// Powers of two are exact up to the last bits of exp2: they must agree with printed ones to 1e-12.
Places compare_with_printed(const Quantities& printed, const std::vector<double>& powers) {
  Places places{.wrong = std::abs(std::ssize(printed) - std::ssize(powers))};
  for (std::size_t i = 0; i < std::min(printed.size(), powers.size()); ++i) {
    const double ratio = powers[i] / number_of(printed[i].value);
    const bool is_right = std::abs(ratio - 1) <= 1e-12;
    ++(is_right ? places.right : places.wrong);
    if (is_right || std::abs(std::log(ratio)) <= std::abs(std::log(places.worst))) continue;
    places.worst = ratio;
    places.wanted = number_of(printed[i].value);
  }
  return places;
}

/// The powers of the levels of a chain. `is_whole_quotient`: level / (levels - 1) with C's integer division.
std::vector<double> gloss_chain(int levels, double octaves, double first_octave, bool is_whole_quotient) {
  if (levels < 2) throw std::invalid_argument("a chain has at least two levels");
  std::vector<double> powers;
  for (int level = 0; level < levels; ++level) {
    const double gloss =
        is_whole_quotient ? 1.0 - level / (levels - 1) : gloss_of_level<double>(level, levels);
    powers.push_back(std::round(decode_gloss(gloss, octaves, first_octave)));
  }
  return powers;
}

/// The powers that a shader finds in a prefiltered chain, for each code of a stored gloss.
struct Selection {
  double worst_ratio = 1;  ///< power found over power wanted, furthest from 1
  double wanted = 1;       ///< there
  int worst_code = 0;      ///< there
  std::vector<int> found;  ///< the codes whose power is found within the allowed steps of the gloss
};

/// `count`: the shader's factor of 1 - g.
Selection select_levels(const Claim& claim, double count) {
  const double levels = given(claim, "levels");
  const double octaves = given(claim, "octaves"), first_octave = given(claim, "first octave");
  const int last_code = (1 << static_cast<int>(given(claim, "gloss bits"))) - 1;
  const double steps = given(claim, "gloss steps that count as found");
  Selection result;
  for (int code = 0; code <= last_code; ++code) {
    const double gloss = static_cast<double>(code) / last_code;
    const double level = level_of_gloss(gloss, count, levels - 1);
    const double wanted = decode_gloss(gloss, octaves, first_octave);
    const double ratio = decode_gloss(gloss_of_level(level, levels), octaves, first_octave) / wanted;
    // Codes that are exactly a step apart count: the slack is far above the rounding and below any step.
    if (std::abs(std::log2(ratio)) <= steps * octaves / last_code + 1e-9) result.found.push_back(code);
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
    runs.push_back(fmt::format("{}{}", codes[i], last > i ? fmt::format(" to {}", codes[last]) : ""));
    i = last + 1;
  }
  return runs.empty() ? "none" : enumerated(runs);
}

Finding evaluate_gloss_chain(const Claim& claim) {
  const double ratio = given(claim, "width") / given(claim, "last width");
  const int levels = static_cast<int>(std::lround(std::log2(ratio))) + 1;
  const double octaves = given(claim, "octaves"), first_octave = given(claim, "first octave");
  const auto by_formula = gloss_chain(levels, octaves, first_octave, false);
  const auto by_loop = gloss_chain(levels, octaves, first_octave, true);
  const Places formula = compare_with_printed(claim.printed, by_formula);
  const Places loop = compare_with_printed(claim.printed, by_loop);
  const double found = loop.wanted * loop.worst;
  return told(claim, verdict_of(loop.wrong == 0, formula.wrong == 0),
              effect_of_power(
                  loop.wanted, found,
                  fmt::format("the loop as printed makes {} for a wrong power, up to {:.4g} times the right "
                              "one: the lobe of power {:.4g} instead of {:.4g}",
                              counted(loop.wrong, "level"), loop.worst, found, loop.wanted)),
              Told{"levels", counted(levels, "level")}, Told{"by_formula", series(by_formula)},
              Told{"right", formula.right}, Told{"powers", counted(std::ssize(claim.printed), "power")},
              Told{"by_loop", series(by_loop)}, Told{"right_by_loop", loop.right});
}

Finding evaluate_sphere_powers(const Claim& claim) {
  const int spheres = static_cast<int>(given(claim, "spheres"));
  const auto powers = gloss_chain(spheres, given(claim, "octaves"), given(claim, "first octave"), false);
  const Places places = compare_with_printed(claim.printed, powers);
  return told(claim, verdict_of(places.wrong == 0), "none", Told{"series", series(powers)},
              Told{"right", counted(places.right, "power")}, Told{"wrong", places.wrong});
}

Finding evaluate_power_drop(const Claim& claim) {
  const double first = given(claim, "first power"), drop = given(claim, "drop");
  const int levels = static_cast<int>(claim.printed.size());
  std::vector<double> powers;
  for (int level = 0; level < levels; ++level) powers.push_back(power_after_drops(first, drop, level));
  const auto drop_of_gloss = [&](int count) {
    return decode_gloss(gloss_of_level<double>(1, count) - 1, given(claim, "octaves"), 0.0);
  };
  return told(claim, verdict_of(compare_with_printed(claim.printed, powers).wrong == 0), "none",
              Told{"series", series(powers)}, Told{"next", power_after_drops(first, drop, levels)},
              Told{"levels", levels}, Told{"drop_per_level", drop_of_gloss(levels)},
              Told{"drop_over_more", drop_of_gloss(levels + 2)});
}

Finding evaluate_mip_select(const Claim& claim) {
  const double levels = given(claim, "levels");
  const int codes = 1 << static_cast<int>(given(claim, "gloss bits"));
  const Selection printed = select_levels(claim, levels), inverse = select_levels(claim, levels - 1);
  // The two ends agree for any count: the first level has g = 1, the last has g = 0.
  const auto is_inside = [&](int code) { return code != 0 && code != codes - 1; };
  const Verdict verdict =
      verdict_of(std::ssize(printed.found) == codes, std::ranges::any_of(printed.found, is_inside));
  const double found = printed.wanted * printed.worst_ratio;
  return told(
      claim, verdict,
      effect_of_power(printed.wanted, found,
                      fmt::format("the lobe of power {:.4g} instead of {:.4g}", found, printed.wanted)),
      Told{"worst_ratio", printed.worst_ratio}, Told{"codes", counted(codes, "gloss code")},
      Told{"runs", runs_of(printed.found)}, Told{"worst_code", printed.worst_code}, Told{"found", found},
      Told{"wanted", printed.wanted}, Told{"inverse", counted(std::ssize(inverse.found), "code")});
}

}  // namespace

/// The claims on levels of environment maps and on prefiltered chains: the powers for which their levels are
/// made, and the level that is read.
std::vector<Evaluator> environment_map_evaluators() {
  return {{"mip-lambert", evaluate_lambert},
          {"mip-mean-power", evaluate_mean_power},
          {"power-range", evaluate_power_range},
          {"mip-gloss-chain", evaluate_gloss_chain},
          {"mip-sphere-powers", evaluate_sphere_powers},
          {"mip-power-drop", evaluate_power_drop},
          {"mip-select", evaluate_mip_select}};
}

}  // namespace shadefit
