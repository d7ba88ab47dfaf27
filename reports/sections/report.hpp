#pragma once

#include <string>
#include <vector>

#include "fit/run/results.hpp"
#include "reports/figures/figure.hpp"
#include "reports/io/files.hpp"

/// What a run leaves behind.
namespace shadefit {

/// report.md: the news, contents and a summary, then a section for each family, what would be better, the
/// normalisations, the reflectances, the ledger and the sources. The sections show `figures`, whose pictures
/// stand in plots/ beside the report.
std::string write_report(const Results& results, const std::vector<Figure>& figures = {});

/// summary.md, for a pull request: the counts of verdicts, the claims that do not hold or only in part, the
/// constants, and Schlick's formula against the exact one.
std::string write_summary(const Results& results);

/// The summary and the normalisations as LaTeX tabulars, a paragraph each.
std::string write_latex_tables(const Results& results);

/// What `shadefit run` writes, but for plots/: report.md, summary.md, better.csv, claims.csv, fits.csv,
/// fresnel.csv, normalization.csv, reflectance.csv, tables.tex.
std::vector<File> report_files(const Results& results, const std::vector<Figure>& figures = {});

}  // namespace shadefit
