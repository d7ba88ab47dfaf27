#include "approx/lobe.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "approx/lobe_laws.hpp"
#include "fit/claims/lobe_errors.hpp"
#include "fit/ledger/topics.hpp"

namespace shadefit {
namespace {

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
  const auto within = where_positive(
      [&](double exponent) {
        const double offset = best_offset(exponent).value_or(std::nan(""));
        return std::min(offset - low, high - offset);
      },
      exponents);
  Verdict verdict = verdict_of(first.is_within(low, high), !within.empty());
  if (verdict != Verdict::confirmed &&
      std::ranges::any_of(ranges, [&](const OffsetRange& r) { return r.is_within(low, high); }))
    verdict = Verdict::other_objective;
  return told(claim, verdict,
              sentence(effect_of_offset(first.highest_at, first.highest, high), "the curve",
                       fmt::format("x = {:.4g} instead of the best x at k = {:.3g}", high, first.highest_at)),
              Told{"most", first.highest}, Told{"under_each_measure", sentences(words)});
}

/// The statement on the best offset at whole powers: up to one of them it is bad, at the next it is not.
struct BadPowers {
  bool holds = true;
  std::vector<Range> where;                ///< the least-squares fit is bad
  std::vector<std::string> fitted, least;  ///< "0.13 at k = 1": its error, and that of the best x
};

double error_of_best_offset(double exponent) {
  const auto offset = best_offset(exponent);
  return offset ? largest_lobe_error(exponent, *offset).magnitude : std::nan("");
}

BadPowers bad_powers(double bad, int last, const std::vector<double>& exponents) {
  BadPowers result;
  result.where = where_positive([&](double k) { return error_of_best_offset(k) - bad; }, exponents);
  for (int whole = 1; whole <= last + 1; ++whole) {
    const double error = error_of_best_offset(whole), smallest = smallest_lobe_error(whole).error;
    const bool is_meant_bad = whole <= last;
    // bad for every x, even for the minimax offset
    result.holds = result.holds && (is_meant_bad ? smallest > bad : error <= bad);
    const std::string at = fmt::format(" at {}{}", whole == 1 ? "k = " : "", whole);
    result.fitted.push_back(fmt::format("{:.3g}{}", error, at));
    result.least.push_back(fmt::format("{:.3g}{}", smallest, at));
  }
  return result;
}

Finding plain_accurate(const Claim& claim) {
  const double offset = given(claim, "offset"), accurate = given(claim, "accurate"),
               poor = given(claim, "poor");
  const auto exponents = doubling_exponents(given(claim, "from"), given(claim, "to"));
  const auto error = [&](double k) { return largest_lobe_error(k, offset).magnitude; };
  const auto is_accurate = where_positive([&](double k) { return accurate - error(k); }, exponents);
  const auto is_poor = where_positive([&](double k) { return error(k) - poor; }, exponents);
  const auto is_a_code =
      where_positive([&](double k) { return 1 - largest_lobe_codes(k, offset); }, exponents);
  const double above = number_of(claim.printed.at("accurate above"));
  const double below = number_of(claim.printed.at("poor below"));
  const BadPowers powers =
      bad_powers(given(claim, "bad"), static_cast<int>(number_of(claim.printed.at("bad up to"))), exponents);
  const std::array parts{verdict_of(covers(is_accurate, above, exponents.back()), !is_accurate.empty()),
                         verdict_of(covers(is_poor, exponents.front(), below), !is_poor.empty()),
                         verdict_of(powers.holds, !powers.where.empty())};
  const auto end = [](const std::vector<Range>& where) { return where.empty() ? 0 : where.front().to; };
  return told(
      claim, worst(parts),
      sentence(effect_of_gaussian(above, offset), "the curve", fmt::format("at k = {:.4g} the form", above)),
      Told{"accurate_from", is_accurate.empty() ? 0 : is_accurate.back().from}, Told{"poor_to", end(is_poor)},
      Told{"bad_to", end(powers.where)}, Told{"is_accurate", sentence(is_accurate, exponents)},
      Told{"is_poor", sentence(is_poor, exponents)}, Told{"is_a_code", sentence(is_a_code, exponents)},
      Told{"law", largest_error_law(offset)}, Told{"is_bad", sentence(powers.where, exponents)},
      Told{"fitted_errors", enumerated(powers.fitted)}, Told{"least_errors", enumerated(powers.least)});
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
  const auto gain_in_codes = [](const PeakSide& side) {
    return fmt::format("{:.2g} at k = {}", side.shifted.srgb_codes - side.plain.srgb_codes,
                       exponent_text(side.exponent));
  };
  const auto most = *std::ranges::max_element(sides, {}, [](const PeakSide& side) {
    return side.shifted.absolute.magnitude - side.plain.absolute.magnitude;
  });
  return told(
      claim, verdict_of(holds),
      sentences(
          {sentence(
               most.plain, "the curve",
               fmt::format(
                   "between the crossing and the peak, at k = {}, the power that gains most, the form with "
                   "x = 0",
                   exponent_text(most.exponent))),
           sentence(most.shifted, "the curve", fmt::format("with x = {:.4g} it", offset))}),
      Told{"cosines", enumerated(words)}, Told{"t", last.exponent * last.crossing.one_minus_cos},
      Told{"limit", law.limit}, Told{"slope", -law.slope}, Told{"first_gain", gain_in_codes(sides.front())},
      Told{"last_gain", gain_in_codes(sides.back())});
}

/// The largest difference of two offsets over the exponents.
struct OffsetGap {
  double low, high;
  std::vector<Range> is_subtle, is_a_code;
  bool is_known;  ///< closed form and search agree

  OffsetGap(double offset, double other, double subtle, const std::vector<double>& exponents)
      : low(std::min(offset, other)), high(std::max(offset, other)), is_known(true) {
    // "below" excludes the threshold itself, one point
    is_subtle = where_positive([&](double k) { return subtle - at(k); }, exponents);
    is_a_code = where_positive([&](double k) { return 1 - largest_offset_codes(k, low, high); }, exponents);
    for (const double k : exponents)
      is_known = is_known && std::abs(largest_offset_difference(k, low, high).magnitude - at(k)) < 1e-10;
  }
  double at(double exponent) const { return low == high ? 0 : widest_gap(exponent + low, exponent + high); }
};

Finding offset_one_low(const Claim& claim) {
  const double offset = number_of(claim.printed.at("x")), used_at = given(claim, "used at");
  const double low_from = given(claim, "low from"), low_to = given(claim, "low to");
  const double high_from = given(claim, "high from"), high_to = given(claim, "high to");
  const double nicely = given(claim, "nicely"), accurate = given(claim, "accurate"),
               subtle = given(claim, "subtle");
  const auto low = doubling_exponents(low_from, low_to), high = doubling_exponents(low_from, high_to);
  const auto error = [&](double k) { return largest_lobe_error(k, offset).magnitude; };
  const auto fits = where_positive([&](double k) { return nicely - error(k); }, low);
  const auto is_accurate = where_positive([&](double k) { return accurate - error(k); }, low);
  const auto is_a_code = where_positive([&](double k) { return 1 - largest_lobe_codes(k, offset); }, high);
  const OffsetGap gap(offset, 0, subtle, high);
  if (!gap.is_known) return {std::nullopt, "", "the closed form of the difference and the search disagree"};
  const std::array parts{verdict_of(covers(fits, low_from, low_to), !fits.empty()),
                         verdict_of(covers(gap.is_subtle, high_from, high_to), !gap.is_subtle.empty())};
  return told(claim, worst(parts),
              sentences({sentence(effect_of_gaussian(used_at, offset), "the curve",
                                  fmt::format("at k = {:.4g} the form with x = {:.4g}", used_at, offset)),
                         sentence(effect_of_offset(high_from, offset, 0), "the curve",
                                  fmt::format("at k = {:.4g} dropping it", high_from))}),
              Told{"low_error", error(low_from)}, Told{"error", error(used_at)},
              Told{"high_error", error(low_to)}, Told{"fits", sentence(fits, low)},
              Told{"is_accurate", sentence(is_accurate, low)}, Told{"is_a_code", sentence(is_a_code, high)},
              Told{"is_subtle", sentence(gap.is_subtle, high)}, Told{"gap", gap.at(high_from)},
              Told{"gap_is_a_code", sentence(gap.is_a_code, high)});
}

Finding offset_matters(const Claim& claim) {
  const auto exponents = doubling_exponents(given(claim, "from"), given(claim, "to"));
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
    words.push_back(fmt::format("x = {:.4g} and {:.4g} {} ({:.3g} at k = {:.4g})", gap.low, gap.high,
                                sentence(gap.is_subtle, exponents), gap.at(from), from));
    codes.push_back(sentence(gap.is_a_code, exponents));
    start = std::max(start, gap.is_subtle.empty() ? exponents.back() : gap.is_subtle.back().from);
  }
  const auto widest = *std::ranges::max_element(gaps, {}, [&](const OffsetGap& gap) { return gap.at(from); });
  return told(
      claim, verdict_of_cases(static_cast<std::size_t>(held), gaps.size()),
      sentence(effect_of_offset(from, widest.low, widest.high), "the curve",
               fmt::format("at k = {:.4g} going from x = {:.4g} to {:.4g}", from, widest.low, widest.high)),
      Told{"pairs", enumerated(words)}, Told{"start", start}, Told{"codes", enumerated(codes)});
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
