#include "fit/ledger/light/gloss_chain.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "approx/environment_map.hpp"
#include "fit/ledger/light/agreement.hpp"
#include "fit/support/decimal.hpp"

namespace shadefit {
namespace {

/// The powers of a chain, the finest level first.
std::string series(const std::vector<double>& powers) {
  std::string out;
  for (const double s : powers) out += (out.empty() ? "" : " ") + decimal(s, 6);
  return out;
}

std::string number(long count) {
  return std::to_string(count);
}

/// Which places of the printed series a computed one agrees with; a place that only one of them has counts as
/// wrong.
struct Places {
  long right = 0;
  long wrong = 0;
  double worst = 1;   ///< computed over printed, the ratio furthest from 1
  double wanted = 0;  ///< the printed one there
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
    if (is_right || std::abs(std::log(ratio)) <= std::abs(std::log(places.worst))) continue;
    places.worst = ratio;
    places.wanted = number_of(printed[i].value);
  }
  return places;
}

/// What the series does at the place where it is furthest off.
std::string effect_of(const Places& places, std::string_view maker) {
  if (places.wrong == 0) return "none";
  if (places.wanted == 0) return none_because("the series have different lengths");
  const double found = places.wanted * places.worst;
  return effect_of_power(places.wanted, found,
                         std::string(maker) + " makes " + counted(places.wrong, "level") +
                             " for another power, up to " + decimal(places.worst, 4) +
                             " times the one meant: the lobe of power " + decimal(found, 4) +
                             " for that of " + decimal(places.wanted, 4));
}

/// The powers for which the levels of a chain are made. `is_whole_quotient`: level / (levels - 1) as the
/// integers of C divide.
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

/// What a shader finds in a prefiltered chain for each code of a stored gloss.
struct Selection {
  double worst_ratio = 1;  ///< power found over power wanted, furthest from 1
  double wanted = 0;       ///< there
  int worst_code = 0;      ///< there
  std::vector<int> found;  ///< the codes whose power is found within the steps of the gloss that count
};

/// Whether the codes say more than the two ends of the gloss, which any count finds: the first level is that
/// of g = 1 and the last one that of g = 0.
bool has_more_than_the_ends(const std::vector<int>& codes, int last_code) {
  return std::any_of(codes.begin(), codes.end(), [&](int code) { return code != 0 && code != last_code; });
}

/// `count`: what the shader multiplies 1 - g by.
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
    runs.push_back(std::to_string(codes[i]) + (last > i ? " to " + std::to_string(codes[last]) : ""));
    i = last + 1;
  }
  return runs.empty() ? "none" : enumerated(runs);
}

}  // namespace

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
  return {verdict, series(by_formula),
          "with a quotient of real numbers the " + counted(levels, "level") + " are made for " +
              series(by_formula) + ", " + number(formula.right) + " of the " +
              counted(static_cast<long>(claim.printed.size()), "power") +
              " printed; the loop as printed divides integers and makes them for " + series(by_loop) + ", " +
              number(loop.right) + " of them",
          effect_of(loop, "the loop as printed")};
}

Finding evaluate_sphere_powers(const Claim& claim) {
  const int spheres = static_cast<int>(given(claim, "spheres"));
  const auto powers = gloss_chain(spheres, given(claim, "octaves"), given(claim, "first octave"), false);
  const Places places = compare_with_printed(claim.printed, powers);
  return {verdict_of(places.wrong == 0), series(powers),
          counted(spheres, "sphere") + " with glosses from 1 to 0 in steps of " +
              decimal(1.0 / (spheres - 1), 6) + " have the powers " + series(powers) + ": " +
              counted(places.right, "power") + " as printed, " + number(places.wrong) + " not",
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
          "the series is " + series(powers) + " and goes on with " +
              decimal(power_after_drops(first, drop, levels), 6) + "; a gloss of " +
              std::string(claim.inputs.at("octaves")) + " octaves drops by " + drop_of_gloss(levels) +
              " a level over " + counted(levels, "level") + ", by " + drop_of_gloss(levels + 2) + " over " +
              counted(levels + 2, "level"),
          effect_of(places, "the series")};
}

Finding evaluate_mip_select(const Claim& claim) {
  const double levels = given(claim, "levels");
  const long codes = 1L << static_cast<int>(given(claim, "gloss bits"));
  const Selection printed = select_levels(claim, levels), inverse = select_levels(claim, levels - 1);
  const auto all = [&](const Selection& s) { return static_cast<long>(s.found.size()) == codes; };
  const Verdict verdict = all(printed) ? Verdict::confirmed
                          : has_more_than_the_ends(printed.found, static_cast<int>(codes) - 1)
                              ? Verdict::conditional
                              : Verdict::refuted;
  const std::string_view steps = claim.inputs.at("gloss steps that count as found");
  const double found = printed.wanted * printed.worst_ratio;
  return {verdict, "found / wanted = " + decimal(printed.worst_ratio, 4) + " at worst",
          "of the " + counted(codes, "gloss code") + " the power is found within " +
              (steps == "1" ? "one code's step" : std::string(steps) + " of a code's step") + " at " +
              runs_of(printed.found) + "; at worst, code " + std::to_string(printed.worst_code) +
              ", it finds " + decimal(found, 4) + " where " + decimal(printed.wanted, 4) + " is wanted, " +
              decimal(printed.worst_ratio, 4) +
              " of it; a shader that multiplies by levels - 1 = " + decimal(levels - 1, 3) + " finds it at " +
              counted(static_cast<long>(inverse.found.size()), "code") +
              "; at the worst the reflection is as wide as " +
              decimal(lobe_solid_angle(found) / lobe_solid_angle(printed.wanted), 3) +
              " times the solid angle meant",
          verdict == Verdict::confirmed ? "none"
                                        : effect_of_power(printed.wanted, found,
                                                          "the lobe of power " + decimal(found, 4) +
                                                              " for that of " + decimal(printed.wanted, 4))};
}

}  // namespace shadefit
