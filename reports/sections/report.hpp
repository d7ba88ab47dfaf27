#pragma once

#include <string>
#include <vector>

#include "fit/run/results.hpp"
#include "reports/figures/figure.hpp"
#include "reports/io/files.hpp"

/// What a run leaves behind.
namespace shadefit {

/// report.md: a summary, then a section per family, what would be better, the normalisations, the
/// reflectances and the ledger. The sections show `figures`, whose pictures stand in plots/ beside the
/// report.
std::string write_report(const Results& results, const std::vector<Figure>& figures = {});

/// The summary and the normalisations as LaTeX tabulars, a paragraph each.
std::string write_latex_tables(const Results& results);

/// What `shadefit run` writes, but for plots/: report.md, better.csv, claims.csv, fits.csv, fresnel.csv,
/// normalization.csv, reflectance.csv, tables.tex.
std::vector<File> report_files(const Results& results, const std::vector<Figure>& figures = {});

}  // namespace shadefit
