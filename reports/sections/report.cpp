#include "reports/sections/report.hpp"

#include <fmt/format.h>

#include "reports/rows/comparisons.hpp"
#include "reports/rows/tables.hpp"
#include "reports/sections/better_section.hpp"
#include "reports/sections/exact_fresnel_section.hpp"
#include "reports/sections/family_section.hpp"
#include "reports/sections/ledger_section.hpp"
#include "reports/sections/normalisation_section.hpp"
#include "reports/sections/reflectance_section.hpp"
#include "reports/table/writers.hpp"

namespace shadefit {

std::string write_report(const Results& results, const std::vector<Figure>& figures) {
  std::string out =
      "# shadefit report\n\n"
      "Constants of real-time shading, refitted and checked. A verdict compares the printed digits with the "
      "computed "
      "number: *confirmed*, all printed digits; *rounding*, the last one off by one; *other-objective*, "
      "another named "
      "metric or convention gives them; *conditional*, for some exponents only; *refuted*, none does. `c` is a cosine in [0, 1]; the `cosine` "
      "measure dc weighs "
      "solid angle evenly, the `angle` measure dc/sqrt(1-c^2) the angle, the `cosine-weighted` measure c dc "
      "projected solid "
      "angle. Fits are continuous least squares "
      "of the "
      "absolute error; their digits are what the last Newton step in wider arithmetic leaves, at most 14.\n\n"
      "## Summary\n\n";
  out += exact_fresnel_lead(results.fresnel_chain);
  const Table summary = summary_table(results);
  if (!summary.rows.empty()) out += markdown_block(summary);
  for (const Refit& refit : results.refits) out += family_section(refit, figures);
  if (!results.fresnel_chain.empty()) out += exact_fresnel_section(results.fresnel_chain);
  if (!results.comparisons.empty()) out += better_section(results.comparisons);
  if (!results.normalisations.empty()) out += normalisation_section(results);
  if (!results.reflectances.empty()) out += reflectance_section(results.reflectances);
  if (!results.claims.empty()) out += ledger_section(results.claims, figures);
  out.pop_back();  // sections end in an empty line, the file does not
  return out;
}

std::string write_latex_tables(const Results& results) {
  const Table summary = summary_table(results);
  std::string out = summary.rows.empty() ? "" : write_latex(summary, Precision::report);
  if (!results.normalisations.empty())
    out += "\n" + write_latex(normalisation_table(results.normalisations), Precision::report);
  if (!results.claims.empty()) out += "\n" + write_latex(claims_overview(results.claims), Precision::report);
  return out;
}

std::vector<File> report_files(const Results& results, const std::vector<Figure>& figures) {
  return {
      {"report.md", write_report(results, figures)},
      {"better.csv", write_csv(comparisons_table(results.comparisons, Precision::report), Precision::report)},
      {"claims.csv", write_csv(claims_table(results.claims), Precision::report)},
      {"fits.csv", write_csv(fits_table(results.refits).table, Precision::report)},
      {"fresnel.csv", write_csv(fresnel_table(results.fresnel_chain), Precision::report)},
      {"normalization.csv", write_csv(normalisation_table(results.normalisations), Precision::report)},
      {"reflectance.csv", write_csv(reflectance_table(results.reflectances), Precision::report)},
      {"tables.tex", write_latex_tables(results)}};
}

}  // namespace shadefit
