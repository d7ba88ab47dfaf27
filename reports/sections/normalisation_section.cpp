#include "reports/sections/sections.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "approx/normalisation.hpp"
#include "reports/io/mathematics.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/citation.hpp"
#include "reports/rows/tables.hpp"
#include "reports/sections/prose.hpp"

namespace shadefit {
namespace {

bool is_checked(const Results& results, const Normalisation& record) {
  return std::ranges::any_of(results.normalisations,
                             [&](const auto& check) { return check.record->id == record.id; });
}

/// The error of the cheap constant; empty if it was not checked.
std::string stand_in_words(const Results& results) {
  const Normalisation& record = BlinnPhongCheapLobe::record;
  if (!is_checked(results, record)) return "";
  const auto [exponent, ratio] = largest_cheap_ratio();
  Table ratios{{"a", "cheap over exact"}};
  for (const auto& check : results.normalisations) {
    if (check.record->id != record.id) continue;
    ratios.rows.push_back({Number{*check.exponent, 10}, converged(check.closed_form / check.integral)});
  }
  return fmt::format(
      "`{0}`, `{1}`, stands in for `{2}`, and is judged by its ratio to it. {3} quotes Naty Hoffman: \"close "
      "to 1\". We read that as within {4:g}, and call such a ratio *close* in this table. The ratio is 1 in the limits a = 0 and infinity. It is largest "
      "at a = {5:.6g}: {6:.10g}, which is {7:.3g} % too bright.\n\n{8}",
      record.id, record.printed, BlinnPhongBrdfLobe::record.printed, linked(record.source), record.closeness,
      exponent, ratio, 100 * (ratio - 1), markdown_block(ratios));
}

/// The assumptions of the microfacet BRDF's constant; empty if it was not checked.
std::string microfacet_words(const Results& results) {
  const Normalisation& record = MicrofacetLobe::record;
  if (!is_checked(results, record)) return "";
  return fmt::format(
      "`{}` is a quarter of `{}`. It has no integral of its own, so it is compared with the integral of four "
      "times the distribution. A game multiplies the light by pi; there the constant is `(a+2)/8`.\n\n",
      record.id, DistributionLobe::record.id);
}

}  // namespace

std::string normalisation_section(const Results& results) {
  std::string out = fmt::format(fmt::runtime(section_text("normalisation")), normalisation_tolerance);
  Table lobes{{"constant", "lobe", "printed", "typeset", "source"}};
  for (const Normalisation& record : normalisations) {
    if (!is_checked(results, record)) continue;
    lobes.rows.push_back({std::string(record.id), fmt::format("`{}`", record.lobe),
                          fmt::format("`{}`", record.printed), mathematics(std::string(record.printed)),
                          linked(record.source)});
  }
  return out + markdown_block(lobes) + stand_in_words(results) + microfacet_words(results) +
         markdown_block(normalisation_table(results.normalisations));
}

}  // namespace shadefit
