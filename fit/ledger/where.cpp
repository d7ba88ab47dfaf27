#include "fit/ledger/where.hpp"

#include <algorithm>

#include "fit/support/format.hpp"

namespace shadefit {

std::vector<double> doubling_exponents(double from, double to) {
  std::vector<double> exponents;
  for (double exponent = from; exponent < to; exponent *= 2) exponents.push_back(exponent);
  exponents.push_back(to);
  return exponents;
}

bool covers(const std::vector<Range>& intervals, double from, double to) {
  return std::ranges::any_of(
      intervals, [&](const Range& interval) { return interval.from <= from && to <= interval.to; });
}

std::string exponent_text(double exponent) {
  return decimal(exponent, exponent < 1000 ? 4 : 6);
}

std::string sentence(const std::vector<Range>& intervals, const std::vector<double>& exponents) {
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
