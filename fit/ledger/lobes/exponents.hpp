#pragma once

#include <functional>
#include <string>
#include <vector>

/// The specular exponents for which a statement on a lobe holds.
namespace shadefit {

/// The exponents of a closed interval.
struct ExponentInterval {
  double from, to;
};

/// `from`, 2 from, 4 from, .. and `to`; 0 < from < to.
std::vector<double> doubling_exponents(double from, double to);

/// The intervals with margin(k) >= 0 over the rising `exponents`. Sign changes between neighbours are refined
/// to a root, in log k. Two changes within one gap are missed, so the exponents must be close enough for the
/// function. An end of an interval that is not a root is the first or last exponent.
std::vector<ExponentInterval> where_not_negative(const std::function<double(double exponent)>& margin,
                                                 const std::vector<double>& exponents);

/// Whether one of the intervals holds all of [from, to].
bool covers(const std::vector<ExponentInterval>& intervals, double from, double to);

/// An exponent in a sentence: 4 digits, and whole thousands as they are.
std::string exponent_text(double exponent);

/// "from k = 13.87 on", "up to k = 8.067", "for k from 1 to 2", joined by "and"; "for every k" and "for no k"
/// of the `exponents`.
std::string sentence(const std::vector<ExponentInterval>& intervals, const std::vector<double>& exponents);

}  // namespace shadefit
