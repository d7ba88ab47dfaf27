#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "approx/environment_map.hpp"
#include "fit/ledger/agreement.hpp"
#include "fit/ledger/told.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"

namespace shadefit {
namespace {

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
  double wanted = 0;  ///< the printed one there
};

/// Powers of two are exact up to the last bits of exp2: they must agree with printed ones to 1e-12.
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
    if (is_right || std::abs(std::log(ratio)) <= std::abs(std::log(places.worst))) continue;
    places.worst = ratio;
    places.wanted = number_of(printed[i].value);
  }
  return places;
}

/// The effect of the series at its worst place.
std::string effect_of(const Places& places, std::string_view maker) {
  if (places.wrong == 0) return "none";
  if (places.wanted == 0) return none_because("the series have different lengths");
  const double found = places.wanted * places.worst;
  return effect_of_power(
      places.wanted, found,
      fmt::format("{} makes {} for a wrong power, up to {:.4g} times the right one: the lobe of power {:.4g} "
                  "instead of {:.4g}",
                  maker, counted(places.wrong, "level"), places.worst, found, places.wanted));
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
  double wanted = 0;       ///< there
  int worst_code = 0;      ///< there
  std::vector<int> found;  ///< the codes whose power is found within the allowed steps of the gloss
};

/// Whether more codes agree than the two ends of the gloss. The ends agree for any count: the first level has
/// g = 1, the last has g = 0.
bool has_more_than_the_ends(const std::vector<int>& codes, int last_code) {
  return std::ranges::any_of(codes, [&](int code) { return code != 0 && code != last_code; });
}

/// `count`: the shader's factor of 1 - g.
Selection select_levels(const Claim& claim, double count) {
  const double levels = given(claim, "levels");
  const double octaves = given(claim, "octaves");
  const double first_octave = given(claim, "first octave");
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
  const double octaves = given(claim, "octaves");
  const double first_octave = given(claim, "first octave");
  const auto by_formula = gloss_chain(levels, octaves, first_octave, false);
  const auto by_loop = gloss_chain(levels, octaves, first_octave, true);
  const Places formula = compare_with_printed(claim.printed, by_formula);
  const Places loop = compare_with_printed(claim.printed, by_loop);
  const Verdict verdict = loop.wrong == 0      ? Verdict::confirmed
                          : formula.wrong == 0 ? Verdict::conditional
                                               : Verdict::refuted;
  const std::string of_loop = loop.wrong == 0 ? "" : fmt::format("; by the loop {}", series(by_loop));
  return {verdict, series(by_formula) + of_loop,
          told(claim, Told{"levels", counted(levels, "level")}, Told{"by_formula", series(by_formula)},
               Told{"right", formula.right}, Told{"powers", counted(std::ssize(claim.printed), "power")},
               Told{"by_loop", series(by_loop)}, Told{"right_by_loop", loop.right}),
          effect_of(loop, "the loop as printed")};
}

Finding evaluate_sphere_powers(const Claim& claim) {
  const int spheres = static_cast<int>(given(claim, "spheres"));
  const auto powers = gloss_chain(spheres, given(claim, "octaves"), given(claim, "first octave"), false);
  const Places places = compare_with_printed(claim.printed, powers);
  return {verdict_of(places.wrong == 0), series(powers),
          told(claim, Told{"series", series(powers)}, Told{"right", counted(places.right, "power")},
               Told{"wrong", places.wrong}),
          effect_of(places, "the series")};
}

Finding evaluate_power_drop(const Claim& claim) {
  const double first = given(claim, "first power");
  const double drop = given(claim, "drop");
  const int levels = static_cast<int>(claim.printed.size());
  std::vector<double> powers;
  for (int level = 0; level < levels; ++level) powers.push_back(power_after_drops(first, drop, level));
  const Places places = compare_with_printed(claim.printed, powers);
  const auto drop_of_gloss = [&](int count) {
    return decimal(decode_gloss(gloss_of_level<double>(1, count) - 1, given(claim, "octaves"), 0.0), 4);
  };
  return {verdict_of(places.wrong == 0), series(powers),
          told(claim, Told{"series", series(powers)}, Told{"next", power_after_drops(first, drop, levels)},
               Told{"drop", drop_of_gloss(levels)}, Told{"levels", counted(levels, "level")},
               Told{"drop_over_more", drop_of_gloss(levels + 2)},
               Told{"more_levels", counted(levels + 2, "level")}),
          effect_of(places, "the series")};
}

Finding evaluate_mip_select(const Claim& claim) {
  const double levels = given(claim, "levels");
  const long codes = 1L << static_cast<int>(given(claim, "gloss bits"));
  const Selection printed = select_levels(claim, levels), inverse = select_levels(claim, levels - 1);
  const auto all = [&](const Selection& s) { return std::ssize(s.found) == codes; };
  const Verdict verdict = all(printed) ? Verdict::confirmed
                          : has_more_than_the_ends(printed.found, static_cast<int>(codes) - 1)
                              ? Verdict::conditional
                              : Verdict::refuted;
  const std::string_view steps = claim.inputs.at("gloss steps that count as found");
  const double found = printed.wanted * printed.worst_ratio;
  return {
      verdict, fmt::format("at worst {:.4g} times the wanted power", printed.worst_ratio),
      told(claim, Told{"codes", counted(codes, "gloss code")},
           Told{"within", steps == "1" ? "one code's step" : fmt::format("{} of a code's step", steps)},
           Told{"runs", runs_of(printed.found)}, Told{"worst_code", printed.worst_code}, Told{"found", found},
           Told{"wanted", printed.wanted}, Told{"inverse", counted(std::ssize(inverse.found), "code")}),
      verdict == Verdict::confirmed
          ? "none"
          : effect_of_power(
                printed.wanted, found,
                fmt::format("the lobe of power {:.4g} instead of {:.4g}", found, printed.wanted))};
}

}  // namespace

/// The claims on prefiltered chains: the powers for which their levels are made, and the level that is read.
std::vector<Evaluator> gloss_chain_evaluators() {
  return {{"mip-gloss-chain", evaluate_gloss_chain},
          {"mip-sphere-powers", evaluate_sphere_powers},
          {"mip-power-drop", evaluate_power_drop},
          {"mip-select", evaluate_mip_select}};
}

}  // namespace shadefit
