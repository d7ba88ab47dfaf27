#pragma once

#include <functional>
#include <string>
#include <vector>

/// Where something said of a lobe holds: for which specular exponents.
namespace shadefit {

/// The exponents of a closed interval.
struct ExponentInterval {
  double from, to;
};

/// `from`, 2 from, 4 from, .. and `to`; 0 < from < to.
std::vector<double> doubling_exponents(double from, double to);

/// Where margin(k) >= 0, among the rising `exponents` and what lies between them: sign changes between
/// neighbours are refined to a root, in log k; two within one gap are missed, so the exponents have to be as
/// close as the function asks for. An end of an interval that is no root is the first or last exponent.
std::vector<ExponentInterval> where_not_negative(const std::function<double(double exponent)>& margin,
                                                 const std::vector<double>& exponents);

/// Whether one of the intervals holds all of [from, to].
bool covers(const std::vector<ExponentInterval>& intervals, double from, double to);

/// An exponent in a sentence: 4 digits, and whole thousands as they are.
std::string exponent_text(double exponent);

/// "from k = 13.87 on", "up to k = 8.067", "for k from 1 to 2", by "and" where there are several; "for every
/// k" and "for no k" of the `exponents` looked at.
std::string sentence(const std::vector<ExponentInterval>& intervals, const std::vector<double>& exponents);

}  // namespace shadefit
