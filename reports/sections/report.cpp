#include "reports/sections/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/io/writers.hpp"
#include "reports/rows/citation.hpp"
#include "reports/rows/tables.hpp"
#include "reports/sections/ledger_section.hpp"
#include "reports/sections/prose.hpp"
#include "reports/sections/sections.hpp"
#include "reports/studies/study_comparison.hpp"

namespace shadefit {
namespace {

/// The publications that the records of these results cite, by year.
std::string sources_section(const Results& results) {
  std::vector<const Source*> sources;
  const auto add = [&](const Source& source) {
    const bool is_there =
        std::ranges::any_of(sources, [&](const Source* other) { return other->title == source.title; });
    if (!is_there) sources.push_back(&source);
  };
  for (const JudgedClaim& judged : results.claims) add(judged.claim->source);
  for (const Refit& refit : results.refits) {
    for (const Published* number : refit.numbers) add(number->source);
  }
  for (const NormalisationCheck& check : results.normalisations) add(check.record->source);
  for (const FresnelLink& link : results.fresnel_chain) add(link.surface->source);
  if (sources.empty()) return "";
  std::ranges::stable_sort(sources, [](const Source* a, const Source* b) { return a->year < b->year; });
  std::string out = "## Sources\n\n";
  for (const Source* source : sources)
    out += fmt::format("- {}, *{}*, {}\n", linked(*source), source->title, source->place);
  return out;
}

Table better_table(const std::vector<TargetComparison>& targets) {
  std::vector<StudyComparison> comparisons;
  for (const TargetComparison& target : targets) comparisons.push_back(target.comparison);
  if (comparisons.empty()) comparisons.push_back({.study = {}, .error = "max_abs_error", .variables = {"c"}});
  return study_comparisons_table(comparisons);
}

}  // namespace

std::string write_report(const Results& results, const std::vector<Figure>& figures) {
  std::string out = section_text("how-to-read") + "## Summary\n\n";
  out += exact_fresnel_lead(results.fresnel_chain);
  const Table summary = summary_table(results);
  if (!summary.rows.empty()) out += markdown_block(summary);
  for (const Refit& refit : results.refits) out += family_section(refit, figures);
  if (!results.fresnel_chain.empty()) out += exact_fresnel_section(results.fresnel_chain);
  if (!results.comparisons.empty()) out += better_section(results.comparisons);
  if (!results.normalisations.empty()) out += normalisation_section(results);
  if (!results.reflectances.empty()) out += reflectance_section(results.reflectances);
  if (!results.claims.empty()) out += ledger_section(results.claims, figures);
  const std::string sources = sources_section(results);
  const std::string news = results.claims.empty() ? "" : news_section(results.claims);
  out = fmt::format(
      "# shadefit report\n\nConstants of real-time shading, refitted and checked.\n\n{}## Contents\n\n{}{}",
      news, contents(out + sources), out);
  return with_short_lines(out) + sources;
}

std::string write_summary(const Results& results) {
  std::string out = "# shadefit summary\n\n";
  if (!results.claims.empty()) out += fmt::format("{}.\n\n", verdict_counts(results.claims));
  out += exact_fresnel_headline(results.fresnel_chain);
  const auto append = [&](Verdict verdict, std::string_view lead) {
    const auto claims = claims_with(results.claims, verdict);
    if (!claims.empty()) out += fmt::format("{}\n\n{}", lead, markdown_block(claims_overview(claims)));
  };
  append(Verdict::refuted, "**Refuted:**");
  append(Verdict::conditional, conditional_lead);
  const Table constants = summary_table(results);
  if (!constants.rows.empty()) out += "**Constants:**\n\n" + markdown_block(constants);
  return with_short_lines(out) + "More, and what the words mean: report.md.\n";
}

std::string write_latex_tables(const Results& results) {
  const Table summary = summary_table(results);
  std::string out = summary.rows.empty() ? "" : write_latex(summary, Precision::report);
  if (!results.normalisations.empty())
    out += "\n" + write_latex(normalisation_table(results.normalisations), Precision::report);
  if (!results.claims.empty()) out += "\n" + write_latex(claims_overview(results.claims), Precision::report);
  return out;
}

std::vector<File> table_files(const Results& results) {
  const auto csv = [](const Table& table) { return write_csv(table, Precision::report); };
  return {{"fits.csv", csv(fits_table(results.refits).table)},
          {"normalization.csv", csv(normalisation_table(results.normalisations))},
          {"reflectance.csv", csv(reflectance_table(results.reflectances))},
          {"fresnel.csv", csv(fresnel_table(results.fresnel_chain))},
          {"claims.csv", csv(claims_table(results.claims))},
          {"better.csv", csv(better_table(results.comparisons))}};
}

std::vector<File> report_files(const Results& results, const std::vector<Figure>& figures) {
  std::vector<File> files{{"report.md", write_report(results, figures)},
                          {"summary.md", write_summary(results)}};
  for (const File& table : table_files(results)) files.push_back(table);
  files.push_back({"tables.tex", write_latex_tables(results)});
  return files;
}

}  // namespace shadefit
