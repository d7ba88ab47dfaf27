#pragma once

#include <string>
#include <vector>

#include "fit/support/decimal.hpp"
#include "fit/support/root.hpp"

/// The ranges in which a condition holds, of cosines and of specular exponents.
namespace shadefit {

struct Range {
  double from, to;
};

/// The ranges on which a function is positive, of those between the first and the last of the rising
/// `places`. Changes of its sign between neighbours are refined, to 34 bits for ten digits; two changes
/// within one gap are missed.
template <class F>
std::vector<Range> where_positive(const F& f, const std::vector<double>& places, unsigned bits = 34) {
  std::vector<Range> ranges;
  double left = places.front(), at_left = f(left);
  if (at_left > 0) ranges.push_back({left, places.back()});
  for (const double right : places) {
    const double at_right = f(right);
    if ((at_left > 0) != (at_right > 0)) {
      const double change = root_between(f, left, right, at_left, at_right, bits);
      if (at_right > 0) {
        ranges.push_back({change, places.back()});
      } else {
        ranges.back().to = change;
      }
    }
    left = right;
    at_left = at_right;
  }
  return ranges;
}

/// `from`, 2 from, 4 from, .. and `to`; 0 < from < to.
std::vector<double> doubling_exponents(double from, double to);

/// Whether one of the intervals holds all of [from, to].
bool covers(const std::vector<Range>& intervals, double from, double to);

/// An exponent in a sentence: 4 digits, and whole thousands as they are.
std::string exponent_text(double exponent);

/// "from k = 13.87 on", "up to k = 8.067", "for k from 1 to 2", joined by "and"; "for every k" and "for no k"
/// of the `exponents`.
std::string sentence(const std::vector<Range>& intervals, const std::vector<double>& exponents);

/// "from c = 0.1 to 0.2 and from c = 0.5 to 1", or "nowhere".
inline std::string ranges_in_words(const std::vector<Range>& ranges, int digits) {
  std::vector<std::string> words;
  for (const auto& [from, to] : ranges)
    words.push_back("from c = " + decimal(from, digits) + " to " + decimal(to, digits));
  return words.empty() ? "nowhere" : enumerated(words);
}

}  // namespace shadefit
