#include <fmt/format.h>

#include <string>

#include "reports/io/escape.hpp"
#include "reports/io/mathematics.hpp"
#include "reports/io/writers.hpp"
#include "reports/sections/prose.hpp"
#include "reports/sections/sections.hpp"
#include "reports/studies/study_comparison.hpp"

namespace shadefit {
namespace {

std::string off_by(const StudyContender& contender) {
  return fmt::format("off by {} in {}", in_digits(contender.max_error.magnitude, 4),
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
  std::string out = section_text("better");
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
