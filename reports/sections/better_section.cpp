#include <fmt/format.h>

#include <string>
#include <variant>

#include "reports/io/escape.hpp"
#include "reports/io/mathematics.hpp"
#include "reports/io/writers.hpp"
#include "reports/sections/sections.hpp"
#include "reports/studies/study_comparison.hpp"

namespace shadefit {
namespace {

std::string off_by(const StudyContender& contender) {
  return fmt::format("off by {} in {}", text(Number{contender.max_error.magnitude, 4}, Precision::report),
                     contender.operations.total());
}

/// "- Row 2, off by 0.03006 in 2 instructions: row 14, $2^{-A c}$ (minimax), off by 0.02628 in 2."
std::string sentence(const StudyComparison& comparison, const StudyContender& published) {
  const auto row = [&](const StudyContender& of) { return &of - comparison.contenders.data() + 1; };
  const std::string what = fmt::format("- Row {}, {} instructions: ", row(published), off_by(published));
  const StudyContender* best = better_at_the_same_cost(comparison, published);
  if (best == nullptr) return what + "nothing here is better at its cost.\n";
  return what + fmt::format("row {}, {} ({}), {}.\n", row(*best), mathematics(best->formula),
                            for_markdown(best->origin), off_by(*best));
}

/// The table of a comparison, with its forms as mathematics.
std::string comparison_block(const StudyComparison& comparison) {
  Table table = study_comparison_table(comparison);
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    table.rows[i].at(1) = mathematics(comparison.contenders[i].formula);
  return markdown_block(table);
}

}  // namespace

std::string better_section(const std::vector<TargetComparison>& comparisons) {
  std::string out =
      "## Published against best\n\n"
      "What would be better at the same cost? For each target, the table lists the published curves, and "
      "the best constants of each form under the cosine measure: by least squares, and *minimax*, which "
      "makes the largest error smallest. Some forms were never published. The largest error of each "
      "published curve, and of the best one at its cost, is proven to a relative width of 1e-4; the others are "
      "sampled and refined. On a surface, errors are of the reflectance F. Operations are counted in the code "
      "that `shadefit emit` writes for one exponent, where expressions of constants are computed beforehand. "
      "A curve *beats* a published one if its error is smaller and it needs no more instructions. The best one "
      "also keeps the properties of the published one. For other surfaces, exponents, domains and errors see "
      "`shadefit better ID`.\n\n";
  for (const TargetComparison& target : comparisons) {
    out += fmt::format("### {}\n\n", target.title) + comparison_block(target.comparison) +
           "For each published curve, the best curve that needs no more instructions:\n\n";
    for (const StudyContender& contender : target.comparison.contenders)
      if (contender.published != nullptr) out += sentence(target.comparison, contender);
    for (const std::string& fit : target.comparison.left_out)
      out += "- Left out: " + for_markdown(fit) + ".\n";
    out += "\n";
  }
  return out;
}

}  // namespace shadefit
