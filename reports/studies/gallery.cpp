#include "reports/studies/gallery.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/io/escape.hpp"
#include "reports/io/writers.hpp"
#include "reports/studies/html.hpp"
#include "reports/studies/page_files.hpp"
#include "reports/studies/study_comparison.hpp"
#include "reports/studies/study_rows.hpp"

namespace shadefit {
namespace {

/// "owner/name" of each place, once.
OthersText repositories(const std::vector<OthersText>& places) {
  std::vector<std::string> names;
  for (const OthersText& of_others : places) {
    const std::string& place = of_others.unescaped();
    const std::string name = place.substr(0, place.find_first_of("@ :"));
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The largest error of a contender, if there is one.
Cell error_of(const StudyContender* contender) {
  if (contender == nullptr) return {};
  const double error = contender->max_error.magnitude;
  return error < rounding_alone ? word("exact") : Cell{Number{error, 4}};
}

std::vector<Cell> row_of(const GalleryEntry& entry, const StudyComparison& comparison,
                         const StudyContender& published) {
  std::vector<Cell> row{
      entry.file.id,
      published.form + (given_text(comparison.study).empty() ? "" : ", " + given_text(comparison.study)),
      short_source(published.origin),
      repositories(published.published->where),
      published.judgement ? verdict_text(*published.judgement) : "",
      error_in_words(comparison.error),
      Number{published.max_error.magnitude, 4},
      static_cast<long>(published.operations.total())};
  const StudyContender* best = better_at_the_same_cost(comparison, published);
  row.push_back(error_of(best));
  if (best == nullptr) {
    row.insert(row.end(), 3, Cell{});
  } else {
    const double least = best->max_error.magnitude;
    row.insert(row.end(),
               {least < rounding_alone ? Cell{} : Cell{Number{published.max_error.magnitude / least, 3}},
                static_cast<long>(best->operations.total()), best->form + ", " + best->origin});
  }
  const StudyContender* least = least_error_at_the_same_cost(comparison, published);
  row.push_back(error_of(least == best ? nullptr : least));
  row.push_back(least == best ? Cell{}
                              : Cell{to_text(lost_properties(published.properties, least->properties))});
  return row;
}

/// The same rows for the page: the important columns first, with titles in words.
Table table_of_page(const Table& rows) {
  Table table = columns_of(rows, {0, 3, 4, 6, 8, 9, 7, 10, 1, 12, 13, 2});
  table.columns = {
      "Constants",    "Used in",     "Verdict", "Error as published", "Best at the same cost", "Times better",
      "Instructions", "Of the best", "Form",    "Least error",        "which loses",           "Source"};
  return table;
}

std::string index_page(const Table& rows, const std::vector<JudgedStudy>& all) {
  std::string others;  // without a row
  for (const JudgedStudy& study : all)
    if (!study.is_published) others += fmt::format(" <a href=\"{0}.html\">{0}</a>", for_html(study.id));
  const auto studies =
      std::ranges::count_if(all, [](const JudgedStudy& study) { return study.is_published; });
  const auto improved = std::ranges::count_if(
      rows.rows, [](const auto& row) { return !std::holds_alternative<std::monostate>(row[8]); });
  const std::string body = fmt::format(fmt::runtime(embedded_text(page_files, "index")), rows.rows.size(),
                                       studies, improved, rows.rows.size()) +
                           html_table(table_of_page(rows), true) +
                           (others.empty() ? "" : "<p>Without a published set:" + others + "</p>\n");
  return html_page(std::string("Published constants of shading"), body);
}

}  // namespace

JudgedStudy judged_study(const GalleryEntry& entry) {
  JudgedStudy study{entry.file.id, !entry.file.published.empty(), {}, study_page(entry)};
  for (const StudyComparison& comparison : entry.comparisons) {
    for (const StudyContender& contender : comparison.contenders) {
      if (contender.published != nullptr) study.rows.push_back(row_of(entry, comparison, contender));
    }
  }
  return study;
}

Table gallery_table(const std::vector<JudgedStudy>& studies) {
  Table table{{"id", "form", "source", "used_in", "verdict", "error", "published", "instructions", "best",
               "ratio", "best_instructions", "best_form", "least", "loses"}};
  for (const JudgedStudy& study : studies)
    table.rows.insert(table.rows.end(), study.rows.begin(), study.rows.end());
  return table;
}

std::vector<File> gallery_files(const std::vector<JudgedStudy>& studies) {
  const Table rows = gallery_table(studies);
  std::vector<File> files{{"index.html", index_page(rows, studies)},
                          {"gallery.csv", write_csv(rows, Precision::report)}};
  for (const JudgedStudy& study : studies) files.push_back({study.id + ".html", study.page});
  return files;
}

}  // namespace shadefit
