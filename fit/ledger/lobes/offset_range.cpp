#include "fit/ledger/lobes/offset_range.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "approx/lobe_laws.hpp"
#include "fit/ledger/lobes/exponents.hpp"
#include "fit/ledger/lobes/lobe_errors.hpp"
#include "fit/support/format.hpp"

namespace shadefit {
namespace {

double blunt_slope(Measure measure) {
  switch (measure) {
    case Measure::cosine:
      return blunt_offset_slope_cosine<double>();
    case Measure::angle:
      return blunt_offset_slope_angle<double>();
    case Measure::cosine_weighted:
      return blunt_offset_slope_cosine_weighted<double>();
  }
  throw std::logic_error("a measure without its law of blunt lobes");
}

}  // namespace

std::optional<OffsetRange> offset_range(Measure measure, const std::vector<double>& exponents) {
  std::vector<double> offsets;
  for (const double exponent : exponents) {
    const auto offset = best_offset(exponent, measure);
    if (!offset) return std::nullopt;
    offsets.push_back(*offset);
  }
  const auto least = static_cast<std::size_t>(std::ranges::min_element(offsets) - offsets.begin());
  const auto best = static_cast<std::size_t>(std::ranges::max_element(offsets) - offsets.begin());
  // The place of a maximum has half the digits, the largest x has all.
  std::uintmax_t steps = 30;
  const auto peak = boost::math::tools::brent_find_minima(
      [&](double log_exponent) { return -best_offset(std::exp(log_exponent), measure).value_or(0); },
      std::log(exponents[best == 0 ? 0 : best - 1]),
      std::log(exponents[std::min(best + 1, offsets.size() - 1)]), 20, steps);
  const auto [p, w] = peak_expansion(measure);
  const auto law = offset_law(p, w);
  const double slope = blunt_slope(measure), first = exponents.front(), last = exponents.back();
  // The next terms of both laws have coefficients of the order of one.
  const bool laws_hold = std::abs(offsets.front() / (slope * first) - 1) < 10 * first &&
                         std::abs(offsets.back() - law.limit - law.slope / last) < 10 / (last * last);
  return OffsetRange{measure,
                     offsets[least],
                     exponents[least],
                     std::max(offsets[best], -peak.second),
                     -peak.second >= offsets[best] ? std::exp(peak.first) : exponents[best],
                     slope,
                     law,
                     laws_hold};
}

std::string sentence(const OffsetRange& range) {
  const std::string law = fmt::format("{:.4g}{}{:.4g}/k", range.law.limit,
                                      range.law.slope < 0 ? " - " : " + ", std::abs(range.law.slope));
  const bool is_below_limit = range.highest < range.law.limit;
  return fmt::format(
      "under the {} measure the best x is {:.4g} k for small k ({:.4g} at k = {}){} for large k",
      name(range.measure), range.blunt_slope, range.lowest, exponent_text(range.lowest_at),
      is_below_limit ? fmt::format(" and rises as {}", law)
                     : fmt::format(", has its maximum {:.4g} at k = {:.3g} and is {}", range.highest,
                                   range.highest_at, law));
}

}  // namespace shadefit
