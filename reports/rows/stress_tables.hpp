#pragma once

#include <string>
#include <vector>

#include "fit/stress/starts.hpp"
#include "fit/stress/trial.hpp"
#include "reports/io/files.hpp"
#include "reports/table/table.hpp"

/// The results of the stress tests of forms and fits, as tables.
namespace shadefit {

/// stress.csv: a row per form and format. Every cell is the same on every machine, though the functions of
/// the C library differ in their last bits:
/// - `worst_ulps`, of a naive form: a power of two that its largest error does not exceed (over the results
///   that are numbers). `worst_at`: the first input with more than half the largest error. Both are empty
///   below 16 ulps, where rounding decides, and for a robust form, which has a `bound` instead.
/// - `bound`, of a robust form, in ulps: "a + b L", where L is the number of e-folds by which the exponential
///   in the form falls. `kept`: "yes" if no input broke the bound, else "no".
/// - `nan`, `infinite`, `negative`, `above`: how many results are NaN, wrongly infinite, wrongly negative, or
///   above the largest exact value (1; 2048 of a decoded gloss; empty where there is none). `first_bad`: the
///   first of these inputs, or of a robust form the first beyond its bound.
Table forms_stress_table(const std::vector<FormTrial>& trials);

/// stress-fits.csv: a row per family, exponent and domain. `status`: of the fit from the family's own starts.
/// `right`: every fit from a drawn start that converged did so at one optimum, none stopped at its start, and
/// none has fewer digits than it claims. `digits`: how many digits agree with the optimum in 50 digits; empty
/// where there is none. `reached`: how many of the drawn starts reach it: all, most (nine in ten), some or
/// none. A start at the edge of a basin may end on either side.
Table fits_stress_table(const std::vector<StartsTrial>& trials);

/// For a console: per topic the worst naive row and the robust one beside it, and a summary of the fits.
Table forms_stress_summary(const std::vector<FormTrial>& trials);
Table fits_stress_summary(const std::vector<StartsTrial>& trials);

/// One line for each bound that was broken and each fit that returned something wrong.
std::string broken_lines(const std::vector<FormTrial>& trials, const std::vector<StartsTrial>& fits);

inline constexpr const char* forms_stress_file = "stress.csv";
inline constexpr const char* fits_stress_file = "stress-fits.csv";

/// Both files, as the command writes them and `check --all` recomputes them.
std::vector<File> stress_files(const std::vector<FormTrial>& trials, const std::vector<StartsTrial>& fits);

}  // namespace shadefit
