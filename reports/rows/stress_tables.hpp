#pragma once

#include <string>
#include <vector>

#include "fit/stress/starts.hpp"
#include "fit/stress/trial.hpp"
#include "reports/io/files.hpp"
#include "reports/table/table.hpp"

/// The results of the stress tests of forms and fits, as tables.
namespace shadefit {

/// stress.csv: a row per form and format. Every cell is the same on every machine, though functions of the
/// library are not, to the last bit:
/// - `worst_ulps`, of a naive form: the power of two that its largest error (of results that are numbers)
///   does not exceed, and `worst_at` the first input with more than half the largest; both empty below 16
///   ulps, where rounding decides, and for a robust form, whose `bound` in ulps they stay within:
/// - `bound` is "a + b L", L the e-folds by which the exponential in the form falls; `kept` says whether no
///   input broke it, "yes" or "no";
/// - `nan`, `infinite`, `negative`, `above`: how many results are none, wrongly infinite, wrongly negative,
/// or
///   above the largest exact value (1; 2048 of a decoded gloss; empty where there is none); `first_bad` is
///   the first input that they count, or of a robust form the first beyond its bound.
Table forms_stress_table(const std::vector<FormTrial>& trials);

/// stress-fits.csv: a row per family, exponent and domain. `status` is that of the fit from the family's own
/// starts; `right` says that every fit from drawn starts that converged did so at one optimum, none at a
/// start, with no fewer digits than it claims; `digits` of it against 50, empty where there is none.
/// `reached`: by all of them, most (nine in ten), some or none: a start at the edge of a basin may fall
/// either way.
Table fits_stress_table(const std::vector<StartsTrial>& trials);

/// Per topic the worst naive row and the robust one beside it, and the fits in short: for a console.
Table forms_stress_summary(const std::vector<FormTrial>& trials);
Table fits_stress_summary(const std::vector<StartsTrial>& trials);

/// One line for each bound that was broken and each fit that returned something wrong.
std::string broken_lines(const std::vector<FormTrial>& trials, const std::vector<StartsTrial>& fits);

inline constexpr const char* forms_stress_file = "stress.csv";
inline constexpr const char* fits_stress_file = "stress-fits.csv";

/// Both files, as the command writes them and `check --all` recomputes them.
std::vector<File> stress_files(const std::vector<FormTrial>& trials, const std::vector<StartsTrial>& fits);

}  // namespace shadefit
