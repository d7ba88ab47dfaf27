#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fit/better/better_study.hpp"
#include "reports/io/table.hpp"

/// The published constants of a study and the alternatives, as rows and as JSON.
namespace shadefit {

/// ", n in 2:10": ranges, to follow a word.
std::string ranges_text(const std::vector<StudyRange>& ranges);

/// "acos(x), x in 0:1", with the given constants.
OthersText target_of(const StudyComparison& comparison);

/// "max abs error": the name of an error of a comparison in words.
std::string error_in_words(std::string_view key);

/// What a curve of that error shows: "form − target", "relative error" or "weighted error".
std::string curve_in_words(std::string_view key);

/// "Use this: row 5, 2.11 times as accurate as row 1, same cost, keeps all its properties: COMMAND", of the
/// first published set and what is better at its cost, or that nothing is. A second line names the set with
/// the smallest error at that cost, if it is another one, and what it loses. Empty without a published set.
std::string advice_text(const StudyComparison& comparison, const std::string& command);

/// One row for each contender, numbered; `beats` has numbers of published rows. Errors have four digits, as
/// they are sampled.
Table study_comparison_table(const StudyComparison& comparison);

/// One row for each target and contender, for a file: better.csv of a study.
Table study_comparisons_table(const std::vector<StudyComparison>& comparisons);

/// One object for each target.
nlohmann::ordered_json study_comparison_json(const StudyComparison& comparison);

}  // namespace shadefit
