#include "approx/environment_map.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "fit/ledger/agreement.hpp"
#include "fit/ledger/told.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
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
    // the second method: the face itself, by the closed form of a texel
    apart = std::max(apart, std::abs(found - power_of_solid_angle(texel_solid_angle(-1.0, -1.0, 2.0))));
  }
  const double width = widths.front();
  const double beyond = mip_level_of_power(width, printed) - std::log2(width);
  const std::optional<Verdict> verdict =
      apart <= tolerance ? std::optional(verdict_of(gap <= tolerance)) : std::nullopt;
  return {verdict, fmt::format("power = {:.10g}", found),
          told(claim, Told{"found", found}, Told{"agree", within(apart, claim.inputs.at("tolerance"))},
               Told{"beyond", beyond}),
          gap <= tolerance
              ? "none"
              : effect_of_power(printed, found, fmt::format("c^{:.3g} for c^{:.3g}", found, printed))};
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
  const double s = number_of(printed);
  std::string evidence =
      fmt::format("s = {}. At s = {:.6g} the lobe covers {:.4g} mean texels and belongs to level {:.3g}",
                  enumerated(words), s, lobe_solid_angle(s) / mean_texel_solid_angle(width, 0.0),
                  mip_level_of_power(width, s));
  if (closest.verdict == Verdict::other_objective)
    evidence +=
        fmt::format(". Among these {} the first {} are those of {}", counted(std::ssize(readings), "reading"),
                    counted(static_cast<long>(digits), "printed digit"), closest.objective);
  const double covering = readings.front().value * unit;
  return {
      closest.verdict, fmt::format("power = {:.6g}", closest.value * unit), evidence,
      effect_of_power(
          s, covering,
          fmt::format(
              "an unfiltered level 0, whose mean texel covers as much as a lobe of power {:.6g}, instead of "
              "power {:.6g}",
              covering, s))};
}

Finding evaluate_power_range(const Claim& claim) {
  const double octaves = given(claim, "octaves");
  const double step = relative_gloss_step(octaves, std::exp2(given(claim, "bits")) - 1);
  const double middle = decode_gloss(0.5, octaves, given(claim, "first octave"));
  return {judge(claim.printed[0].value, {"", 100 * step}, {}).verdict,
          fmt::format("step = {:.5g} %", 100 * step), told(claim, Told{"share", step}),
          effect_of_power(middle, middle * (1 + step),
                          fmt::format("one step of the gloss at power {:.4g}", middle))};
}

}  // namespace

std::vector<Evaluator> environment_map_evaluators() {
  return {{"mip-lambert", evaluate_lambert},
          {"mip-mean-power", evaluate_mean_power},
          {"power-range", evaluate_power_range}};
}

}  // namespace shadefit
