#pragma once

#include <string>
#include <vector>

#include "reports/files.hpp"
#include "reports/results.hpp"

/// What a run leaves behind.
namespace shadefit {

/// report.md: a summary, then a section per family, one for the normalisations and one for
/// the reflectances.
std::string write_report(const Results& results);

/// The summary and the normalisations as LaTeX tabulars, a paragraph each.
std::string write_latex_tables(const Results& results);

/// Everything that `shadefit run` writes: report.md, fits.csv, normalization.csv, reflectance.csv, tables.tex.
std::vector<File> report_files(const Results& results);

}  // namespace shadefit
