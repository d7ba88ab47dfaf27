#include "reports/studies/study_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/studies/study_comparison.hpp"
#include "reports/studies/study_rows.hpp"

namespace shadefit {
namespace {

/// One line for each fact of the study: what is approximated, over what, by which forms.
std::vector<std::string> statement_of(const StudyFile& file) {
  std::vector<std::string> lines;
  if (!file.about.empty()) lines.push_back(file.about);
  lines.push_back("Target: " +
                  (file.study.rows ? "the rows of " + file.study.rows->file : file.study.target));
  for (const StudyDefinition& definition : file.study.definitions) {
    const std::string arguments =
        definition.arguments.empty() ? "" : fmt::format("({})", fmt::join(definition.arguments, ", "));
    lines.push_back(fmt::format("where {}{} = {}", definition.name, arguments, definition.formula));
  }
  for (const StudyRange& range : file.study.over)
    if (!file.study.rows)
      lines.push_back(fmt::format("{} in [{}, {}]{}", range.variable, range.lower, range.upper,
                                  range.density == "1" ? "" : ", density " + range.density));
  for (const StudyForm& form : file.forms) lines.push_back(fmt::format("Form {}: {}", form.id, form.formula));
  return lines;
}

/// The contender of a set in a comparison, or null.
const StudyContender* contender_of(const StudyComparison& comparison, const PublishedSet& set) {
  for (const StudyContender& contender : comparison.contenders) {
    if (contender.published == &set) return &contender;
  }
  return nullptr;
}

/// What a source printed, and what is computed about it.
std::vector<std::string> lines_of(const PublishedSet& set, const std::vector<StudyComparison>& comparisons) {
  std::vector<std::string> lines{fmt::format("{}: {} ({})", set.form, printed_text(set.values), set.source)};
  for (const StudyComparison& comparison : comparisons) {
    const StudyContender* contender = contender_of(comparison, set);
    if (contender == nullptr) continue;
    lines.push_back(fmt::format("Verdict: {}", verdict_text(*contender->judgement)));
    if (set.claim)
      lines.push_back(fmt::format("Largest error: stated {}, computed {}: {}", set.claim->max_abs_error,
                                  text(Number{contender->max_abs_error.magnitude, 4}, Precision::report),
                                  name(*contender->claim)));
  }
  if (!set.where.empty()) lines.push_back(fmt::format("Used in: {}", fmt::join(set.where, "; ")));
  for (const MistypedCopy& copy : set.variants)
    lines.push_back(fmt::format("Mistyped: {} in {}", printed_text(copy.values), copy.seen));
  return lines;
}

std::string title_of(const StudyFile& file) {
  return file.title.empty() ? file.id : fmt::format("{}: {}", file.id, file.title);
}

}  // namespace

std::string study_explanation(const StudyFile& file, const std::vector<StudyComparison>& comparisons,
                              const Terminal& terminal) {
  std::string out = title_of(file) + "\n";
  for (const std::string& line : statement_of(file)) out += line + "\n";
  for (const PublishedSet& set : file.published)
    out += fmt::format("\n{}\n", fmt::join(lines_of(set, comparisons), "\n"));
  return with_coloured_verdicts(out, terminal);
}

std::vector<File> study_files_of(const StudyFile& file, const std::vector<StudyComparison>& comparisons,
                                 const std::vector<Figure>& figures) {
  std::string page = fmt::format("# Study {}\n\n", title_of(file));
  for (const std::string& line : statement_of(file)) page += line + "  \n";
  for (const PublishedSet& set : file.published) {
    page += "\n";
    for (const std::string& line : lines_of(set, comparisons)) page += line + "  \n";
  }
  for (const StudyComparison& comparison : comparisons) {
    page += fmt::format("\n## {}\n\n{}", target_of(comparison),
                        markdown_block(study_comparison_table(comparison)));
    page += left_out_lines(comparison);
  }
  page +=
      "\nThe largest errors are sampled. `beats` names published rows with a larger error at no fewer instructions.\n";
  for (const Figure& figure : figures)
    page += fmt::format("\n![{}](plots/{}.svg)\n", figure.caption, figure.name);
  return {{"report.md", page},
          {"better.csv", write_csv(study_comparisons_table(comparisons), Precision::report)}};
}

}  // namespace shadefit
