#include "fit/ledger/lobes/exponents.hpp"

#include <algorithm>
#include <cmath>

#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"
#include "fit/support/root.hpp"

namespace shadefit {

std::vector<double> doubling_exponents(double from, double to) {
  std::vector<double> exponents;
  for (double exponent = from; exponent < to; exponent *= 2) exponents.push_back(exponent);
  exponents.push_back(to);
  return exponents;
}

std::vector<ExponentInterval> where_not_negative(const std::function<double(double exponent)>& margin,
                                                 const std::vector<double>& exponents) {
  const auto at_log = [&](double log_exponent) { return margin(std::exp(log_exponent)); };
  std::vector<ExponentInterval> intervals;
  double left = exponents.front(), at_left = margin(left);
  if (at_left >= 0) intervals.push_back({left, left});
  for (auto next = exponents.begin() + 1; next != exponents.end(); ++next) {
    const double right = *next, at_right = margin(right);
    const bool was = at_left >= 0, is = at_right >= 0;
    if (was != is) {
      // 34 bits: ten digits, more than are printed.
      const double crossing =
          std::exp(root_between(at_log, std::log(left), std::log(right), at_left, at_right, 34));
      if (is) {
        intervals.push_back({crossing, right});
      } else {
        intervals.back().to = crossing;
      }
    } else if (is) {
      intervals.back().to = right;
    }
    left = right;
    at_left = at_right;
  }
  return intervals;
}

bool covers(const std::vector<ExponentInterval>& intervals, double from, double to) {
  return std::ranges::any_of(intervals, [&](const ExponentInterval& interval) {
    return interval.from <= from && to <= interval.to;
  });
}

std::string exponent_text(double exponent) {
  return decimal(exponent, exponent < 1000 ? 4 : 6);
}

std::string sentence(const std::vector<ExponentInterval>& intervals, const std::vector<double>& exponents) {
  if (intervals.empty()) return "for no k";
  std::vector<std::string> words;
  for (const auto& [from, to] : intervals) {
    const bool is_open_below = from <= exponents.front(), is_open_above = to >= exponents.back();
    words.push_back(is_open_below && is_open_above ? "for every k"
                    : is_open_above                ? fmt::format("from k = {} on", exponent_text(from))
                    : is_open_below
                        ? fmt::format("up to k = {}", exponent_text(to))
                        : fmt::format("for k from {} to {}", exponent_text(from), exponent_text(to)));
  }
  return enumerated(words);
}

}  // namespace shadefit
