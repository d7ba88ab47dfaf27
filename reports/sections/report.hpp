#pragma once

#include <string>
#include <vector>

#include "fit/better/results.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/files.hpp"

/// The files of a run.
namespace shadefit {

/// report.md: the news, contents and a summary, then a section for each family, better alternatives, the
/// normalisations, the reflectances, the ledger and the sources. The sections show `figures`, whose pictures
/// stand in plots/ beside the report.
std::string write_report(const Results& results, const std::vector<Figure>& figures = {});

/// summary.md, for a pull request: the counts of verdicts, the refuted and conditional claims, the constants,
/// and Schlick's formula against the exact one.
std::string write_summary(const Results& results);

/// The summary, the normalisations and the claims as LaTeX tables.
std::string write_latex_tables(const Results& results);

/// The tables of a run that are compared with a baseline.
std::vector<File> table_files(const Results& results);

/// The files of `shadefit run` without plots/: report.md, summary.md, better.csv, claims.csv, fits.csv,
/// fresnel.csv, normalization.csv, reflectance.csv, tables.tex.
std::vector<File> report_files(const Results& results, const std::vector<Figure>& figures = {});

}  // namespace shadefit
