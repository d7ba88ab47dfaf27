#include "approx/lobe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "approx/lobe_laws.hpp"
#include "fit/ledger/lobes/exponents.hpp"
#include "fit/ledger/lobes/lobe_errors.hpp"
#include "fit/ledger/told.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {
namespace {

/// The exponents of a claim, between its first and last.
std::vector<double> exponents_from_to(const Claim& claim) {
  return doubling_exponents(given(claim, "from"), given(claim, "to"));
}

/// "over k = 0.1 to 100000"
std::string looked_at(const std::vector<double>& exponents) {
  return fmt::format("over k = {} to {}", exponent_text(exponents.front()), exponent_text(exponents.back()));
}

/// A part of a claim on a range: it holds there, or only elsewhere, or nowhere.
Verdict verdict_of_range(bool holds, const std::vector<ExponentInterval>& where) {
  return holds ? Verdict::confirmed : where.empty() ? Verdict::refuted : Verdict::conditional;
}

Finding offset_bounds(const Claim& claim) {
  const auto exponents = parse_sweep(claim.inputs.at("exponents"));
  const double low = number_of(claim.printed.at("lowest")), high = number_of(claim.printed.at("highest"));
  std::vector<OffsetRange> ranges;
  std::vector<std::string> words;
  for (const Measure measure : measures) {
    const auto range = offset_range(measure, exponents);
    if (!range || !range->laws_hold)
      return {std::nullopt, "", "the fits do not converge, or not to the laws of blunt and sharp lobes"};
    ranges.push_back(*range);
    words.push_back(sentence(*range));
  }
  const OffsetRange& first = ranges.front();
  const auto within = where_not_negative(
      [&](double exponent) {
        const double offset = best_offset(exponent).value_or(std::nan(""));
        return std::min(offset - low, high - offset);
      },
      exponents);
  Finding finding;
  finding.verdict = verdict_of_range(first.is_within(low, high), within);
  if (*finding.verdict != Verdict::confirmed &&
      std::ranges::any_of(ranges, [&](const OffsetRange& r) { return r.is_within(low, high); }))
    finding.verdict = Verdict::other_objective;
  finding.computed = fmt::format("0 .. {:.4g}", first.highest);
  finding.evidence = sentences(words);
  if (*finding.verdict != Verdict::confirmed)
    finding.evidence += fmt::format(". Under the first measure it is in [{:.4g}, {:.4g}] {}", low, high,
                                    sentence(within, exponents));
  finding.effect =
      sentence(effect_of_offset(first.highest_at, first.highest, high), "the curve",
               fmt::format("x = {:.4g} instead of the best x at k = {:.3g}", high, first.highest_at));
  return finding;
}

/// The statement on the best offset at whole powers: up to one of them it is bad, at the next it is not.
struct BadPowers {
  bool holds;
  std::vector<ExponentInterval> where;  ///< the least-squares fit is bad
  std::string words;
};

double error_of_best_offset(double exponent) {
  const auto offset = best_offset(exponent);
  return offset ? largest_lobe_error(exponent, *offset).magnitude : std::nan("");
}

BadPowers bad_powers(double bad, int last, const std::vector<double>& exponents) {
  BadPowers result{
      true, where_not_negative([&](double k) { return error_of_best_offset(k) - bad; }, exponents), ""};
  std::vector<std::string> fitted, least;
  for (int whole = 1; whole <= last + 1; ++whole) {
    const double error = error_of_best_offset(whole), smallest = smallest_lobe_error(whole).error;
    const bool is_meant_bad = whole <= last;
    // bad for every x, even for the minimax offset
    result.holds = result.holds && (is_meant_bad ? smallest > bad : error <= bad);
    const std::string at = fmt::format(" at {}{}", whole == 1 ? "k = " : "", whole);
    fitted.push_back(fmt::format("{:.3g}{}", error, at));
    least.push_back(fmt::format("{:.3g}{}", smallest, at));
  }
  result.words = fmt::format(
      "With the least-squares x the error is above {:.3g} {}: {}. With the x of the smallest error it is {}",
      bad, sentence(result.where, exponents), enumerated(fitted), enumerated(least));
  return result;
}

Finding plain_accurate(const Claim& claim) {
  const double offset = given(claim, "offset"), accurate = given(claim, "accurate"),
               poor = given(claim, "poor");
  const auto exponents = exponents_from_to(claim);
  if (!std::ranges::all_of(exponents, [](double k) { return best_offset(k).has_value(); }))
    return {std::nullopt, "", "the least-squares fits do not converge"};
  const auto error = [&](double k) { return largest_lobe_error(k, offset).magnitude; };
  const auto is_accurate = where_not_negative([&](double k) { return accurate - error(k); }, exponents);
  const auto is_poor = where_not_negative([&](double k) { return error(k) - poor; }, exponents);
  const auto is_a_code =
      where_not_negative([&](double k) { return 1 - largest_lobe_codes(k, offset); }, exponents);
  const double above = number_of(claim.printed.at("accurate above"));
  const double below = number_of(claim.printed.at("poor below"));
  const BadPowers powers =
      bad_powers(given(claim, "bad"), static_cast<int>(number_of(claim.printed.at("bad up to"))), exponents);
  const std::array parts{verdict_of_range(covers(is_accurate, above, exponents.back()), is_accurate),
                         verdict_of_range(covers(is_poor, exponents.front(), below), is_poor),
                         verdict_of_range(powers.holds, powers.where)};
  const auto start = [](const std::vector<ExponentInterval>& w) {
    return w.empty() ? "none" : decimal(w.back().from, 4);
  };
  const auto end = [](const std::vector<ExponentInterval>& w) {
    return w.empty() ? "none" : decimal(w.front().to, 4);
  };
  return {
      worst(parts),
      fmt::format("accurate above = {}, poor below = {}, bad up to = {}", start(is_accurate), end(is_poor),
                  end(powers.where)),
      told(claim, Told{"looked_at", looked_at(exponents)},
           Told{"is_accurate", sentence(is_accurate, exponents)},
           Told{"is_poor", sentence(is_poor, exponents)}, Told{"is_a_code", sentence(is_a_code, exponents)},
           Told{"law", largest_error_law(offset)}, Told{"bad_powers", powers.words}),
      sentence(effect_of_gaussian(above, offset), "the curve", fmt::format("at k = {:.4g} the form", above))};
}

/// A crossing near the peak, and the gain between it and the peak.
struct PeakSide {
  double exponent;
  Cosine<double> crossing;
  bool holds;             ///< the plain form is closer from there to the peak, and not below
  Effect plain, shifted;  ///< of the two forms on the peak's side
};

std::optional<PeakSide> peak_side(double exponent, double offset) {
  const auto crossing = peak_crossing(exponent, offset);
  if (!crossing) return std::nullopt;
  PeakSide side{exponent, *crossing, true, {}, {}};
  // 64 places on the peak's side, and as many below the crossing, where the lobe has not yet vanished
  const double top = crossing->one_minus_cos, bottom = std::min(1.0, 16 * top);
  constexpr int places = 64;
  for (int i = 1; i <= 2 * places; ++i) {
    const double y = i <= places ? top * i / places : top + (bottom - top) * (i - places) / places;
    const Cosine<double> c{1 - y, y};
    const double plain = lobe_error_at(c, exponent, 0), shifted = lobe_error_at(c, exponent, offset);
    if (i != places) side.holds = side.holds && (i < places) == (plain < shifted);
    if (i > places) continue;
    show_gaussian(side.plain, c, exponent, 0);
    show_gaussian(side.shifted, c, exponent, offset);
  }
  return side;
}

std::string gain_in_codes(const PeakSide& side) {
  return fmt::format("{:.2g} at k = {}", side.shifted.srgb_codes - side.plain.srgb_codes,
                     exponent_text(side.exponent));
}

Finding plain_peak(const Claim& claim) {
  const double offset = given(claim, "offset");
  std::vector<std::string> words;
  std::vector<PeakSide> sides;
  for (const double exponent : parse_sweep(claim.inputs.at("exponents"))) {
    const auto side = peak_side(exponent, offset);
    if (!side)
      return {Verdict::refuted, "",
              fmt::format("the plain form is nowhere closer than the one with x = {:.4g}", offset)};
    sides.push_back(*side);
    words.push_back(fmt::format("{:.6g}{}{}", side->crossing.cos_theta,
                                sides.size() == 1 ? " at k = " : " at ", exponent_text(exponent)));
  }
  const bool holds = std::ranges::all_of(sides, &PeakSide::holds);
  const auto law = peak_crossing_law(offset);
  const PeakSide& last = sides.back();
  const double t = last.exponent * last.crossing.one_minus_cos;
  const auto most = *std::ranges::max_element(sides, {}, [](const PeakSide& side) {
    return side.shifted.absolute.magnitude - side.plain.absolute.magnitude;
  });
  return {
      verdict_of(holds), fmt::format("c > 1 - {:.4g}/k as k grows", law.limit),
      told(claim, Told{"cosines", enumerated(words)}, Told{"t", t}, Told{"limit", law.limit},
           Told{"slope", -law.slope}, Told{"first_gain", gain_in_codes(sides.front())},
           Told{"last_gain", gain_in_codes(sides.back())}),
      sentences(
          {sentence(
               most.plain, "the curve",
               fmt::format(
                   "between the crossing and the peak, at k = {}, the power that gains most, the form with "
                   "x = 0",
                   exponent_text(most.exponent))),
           sentence(most.shifted, "the curve", fmt::format("with x = {:.4g} it", offset))})};
}

/// The largest difference of two offsets over the exponents.
struct OffsetGap {
  double low, high;
  std::vector<ExponentInterval> is_subtle, is_a_code;
  bool is_known;  ///< closed form and search agree

  OffsetGap(double offset, double other, double subtle, const std::vector<double>& exponents)
      : low(std::min(offset, other)), high(std::max(offset, other)), is_known(true) {
    // "below" excludes the threshold itself, one point
    is_subtle = where_not_negative([&](double k) { return subtle - at(k); }, exponents);
    is_a_code =
        where_not_negative([&](double k) { return 1 - largest_offset_codes(k, low, high); }, exponents);
    for (const double k : exponents)
      is_known = is_known && std::abs(largest_offset_difference(k, low, high).magnitude - at(k)) < 1e-10;
  }
  double at(double exponent) const { return low == high ? 0 : widest_gap(exponent + low, exponent + high); }
  std::string pair() const { return fmt::format("x = {:.4g} and {:.4g}", low, high); }
};

Finding offset_one_low(const Claim& claim) {
  const double offset = number_of(claim.printed.at("x")), used_at = given(claim, "used at");
  const double low_from = given(claim, "low from"), low_to = given(claim, "low to");
  const double high_from = given(claim, "high from"), high_to = given(claim, "high to");
  const double nicely = given(claim, "nicely"), accurate = given(claim, "accurate"),
               subtle = given(claim, "subtle");
  const auto low = doubling_exponents(low_from, low_to), high = doubling_exponents(low_from, high_to);
  const auto error = [&](double k) { return largest_lobe_error(k, offset).magnitude; };
  const auto fits = where_not_negative([&](double k) { return nicely - error(k); }, low);
  const auto is_accurate = where_not_negative([&](double k) { return accurate - error(k); }, low);
  const auto is_a_code =
      where_not_negative([&](double k) { return 1 - largest_lobe_codes(k, offset); }, high);
  const OffsetGap gap(offset, 0, subtle, high);
  if (!gap.is_known) return {std::nullopt, "", "the closed form of the difference and the search disagree"};
  const std::array parts{verdict_of_range(covers(fits, low_from, low_to), fits),
                         verdict_of_range(covers(gap.is_subtle, high_from, high_to), gap.is_subtle)};
  const std::string x = fmt::format("x = {:.4g}", offset);
  return {worst(parts),
          fmt::format("{} fits low powers {}; it can be dropped {}", x, sentence(fits, low),
                      sentence(gap.is_subtle, high)),
          told(claim, Told{"looked_at", looked_at(low)}, Told{"low_error", error(low_from)},
               Told{"error", error(used_at)}, Told{"high_error", error(low_to)},
               Told{"fits", sentence(fits, low)}, Told{"is_accurate", sentence(is_accurate, low)},
               Told{"looked_higher", looked_at(high)}, Told{"is_a_code", sentence(is_a_code, high)},
               Told{"is_subtle", sentence(gap.is_subtle, high)}, Told{"gap", gap.at(high_from)},
               Told{"gap_is_a_code", sentence(gap.is_a_code, high)}),
          sentences({sentence(effect_of_gaussian(used_at, offset), "the curve",
                              fmt::format("at k = {:.4g} the form with {}", used_at, x)),
                     sentence(effect_of_offset(high_from, offset, 0), "the curve",
                              fmt::format("at k = {:.4g} dropping it", high_from))})};
}

Finding offset_matters(const Claim& claim) {
  const auto exponents = exponents_from_to(claim);
  const double from = number_of(claim.printed.at("k")), subtle = given(claim, "subtle");
  const double plain = given(claim, "plain"), fitted = given(claim, "fitted"),
               other = given(claim, "literature");
  const std::array gaps{OffsetGap(plain, fitted, subtle, exponents),
                        OffsetGap(fitted, other, subtle, exponents),
                        OffsetGap(plain, other, subtle, exponents)};
  const auto reaches = [&](const OffsetGap& gap) { return covers(gap.is_subtle, from, exponents.back()); };
  const auto held = std::ranges::count_if(gaps, reaches);
  std::vector<std::string> words, codes;
  double start = 0;
  for (const OffsetGap& gap : gaps) {
    if (!gap.is_known) return {std::nullopt, "", "the closed form of the difference and the search disagree"};
    words.push_back(fmt::format("{} {} ({:.3g} at k = {:.4g})", gap.pair(),
                                sentence(gap.is_subtle, exponents), gap.at(from), from));
    codes.push_back(sentence(gap.is_a_code, exponents));
    start = std::max(start, gap.is_subtle.empty() ? exponents.back() : gap.is_subtle.back().from);
  }
  const auto widest = *std::ranges::max_element(gaps, {}, [&](const OffsetGap& gap) { return gap.at(from); });
  return {
      verdict_of_cases(static_cast<std::size_t>(held), gaps.size()),
      fmt::format("all three differ subtly from k = {:.4g} on", start),
      told(claim, Told{"looked_at", looked_at(exponents)}, Told{"pairs", enumerated(words)},
           Told{"start", start}, Told{"codes", enumerated(codes)}),
      sentence(effect_of_offset(from, widest.low, widest.high), "the curve",
               fmt::format("at k = {:.4g} going from x = {:.4g} to {:.4g}", from, widest.low, widest.high))};
}

}  // namespace

std::vector<Evaluator> lobe_evaluators() {
  return {{"sg-offset-bounds", offset_bounds},
          {"sg-plain-accurate", plain_accurate},
          {"sg-plain-peak", plain_peak},
          {"sg-offset-one-low", offset_one_low},
          {"sg-offset-matters-below", offset_matters}};
}

}  // namespace shadefit
