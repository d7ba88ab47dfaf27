#pragma once

#include <string>
#include <vector>

#include "fit/catalogue/family.hpp"
#include "fit/stress/form_trial.hpp"
#include "reports/io/table.hpp"

/// The results of the stress tests of forms and fits, as tables.
namespace shadefit {

/// stress.csv: a row per form and format. Every cell is the same on every machine, though the functions of
/// the C library differ in their last bits:
/// - `worst_ulps`, of a naive form: a power of two that its largest error does not exceed (over the results
///   that are numbers). `worst_at`: the first input with more than half the largest error. Both are empty
///   below 16 ulps, where rounding decides, and for a robust form, which has a `bound` instead.
/// - `bound`, of a robust form, in ulps: "a + b L", where L is the number of e-folds by which the exponential
///   in the form falls. `kept`: "yes" if no input broke the bound, else "no".
/// - `nan`, `infinite`, `negative`, `above`: how many results are NaN, infinite, negative, or above 1.
///   `first_bad`: the first of these inputs, or of a robust form the first beyond its bound.
Table forms_stress_table(const std::vector<FormTrial>& trials);

/// stress-fits.csv: a row per family, exponent and domain, with its status and the digits of its parameters,
/// empty where it did not converge.
Table fits_stress_table(const std::vector<Fit>& fits);

/// A line for each robust form that breaks its bound or has an unusable result.
std::string broken_lines(const std::vector<FormTrial>& trials);

inline constexpr const char* forms_stress_file = "stress.csv";
inline constexpr const char* fits_stress_file = "stress-fits.csv";

}  // namespace shadefit
