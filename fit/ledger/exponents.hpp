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

/// "for k from 8.067 to 15", by "and" where there are several; "for no k".
std::string sentence(const std::vector<ExponentInterval>& intervals, int digits = 4);

}  // namespace shadefit
