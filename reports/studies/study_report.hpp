#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fit/better/better_study.hpp"
#include "fit/catalogue/study_file.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/files.hpp"
#include "reports/io/writers.hpp"

/// A study on a page.
namespace shadefit {

/// What "(proven)" behind a property means (fit/bounds/prove_shape.hpp).
inline constexpr std::string_view proven_in_words =
    "A proven property holds for all numbers of the range, but for 1e-12 of the target's largest value, which is rounding; exact is within 2^-24 of it.";

/// "acos-linear: the arc cosine by a line times a root".
OthersText study_title(const StudyFile& file);

/// One line for each fact of the study: what is approximated, over what, by which forms.
std::vector<OthersText> study_statement(const StudyFile& file);

/// What a source printed, and what is computed about it.
std::vector<OthersText> published_lines(const PublishedSet& set,
                                        const std::vector<StudyComparison>& comparisons);

/// What a study says and what is computed: title, formulas, each published set with its verdict, its source
/// and its places, and the comparison.
std::string study_explanation(const StudyFile& file, const std::vector<StudyComparison>& comparisons,
                              const Terminal& terminal);

/// The files of a run: report.md, better.csv.
std::vector<File> study_files_of(const StudyFile& file, const std::vector<StudyComparison>& comparisons,
                                 const std::vector<Figure>& figures);

}  // namespace shadefit
