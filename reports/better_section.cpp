#include "reports/better_section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/comparisons.hpp"
#include "reports/writers.hpp"

namespace shadefit {
namespace {

using Kind = Contender::Kind;

/// The curve of least error among those that beat a published one, or null.
const Contender* best_against(const Comparison& comparison, std::string_view published) {
  const Contender* best = nullptr;
  for (const Contender& contender : comparison.contenders) {
    const auto& beats = contender.beats;
    if (std::find(beats.begin(), beats.end(), published) == beats.end()) continue;
    if (best == nullptr || contender.max_abs_error.upper < best->max_abs_error.upper) best = &contender;
  }
  return best;
}

/// "- `fresnel-offset-one` (2 instructions, 0.03998): `exp2(-(A c))`, 0.0263, in 2".
std::string sentence(const Contender& published, const Contender* best) {
  const auto error = [](const Contender& c) {
    return text(Number{c.max_abs_error.lower, 4}, Precision::report);
  };
  const std::string what = fmt::format("- `{}`, off by {} in {} instructions: ", published.published,
                                       error(published), published.operations.total());
  if (best == nullptr) return what + "nothing here is better at its cost.\n";
  const std::string whose = best->kind == Kind::target
                                ? std::string("the target itself")
                                : fmt::format("`{}` from {}{}", best->form,
                                              best->kind == Kind::published ? "" : "a fit of ", best->origin);
  return what + fmt::format("{}, off by {} in {}.\n", whose, error(*best), best->operations.total());
}

}  // namespace

std::string better_section(const std::vector<Comparison>& comparisons) {
  std::string out = fmt::format(
      "## Published against best\n\n"
      "What would be better at the same cost? For each target here the published curves, and each form with the "
      "constants that make its largest error least (minimax); forms that nobody published stand beside. The largest "
      "errors are proven, to {:g} of themselves: the digits shown are right to within one unit of the last. Those on "
      "a surface are of the reflectance F. The other errors are computed; the rms error is uniform in the cosine. "
      "Operations are those of the form as it is written. A curve beats a published one whose proven error is larger "
      "at no fewer instructions. Other surfaces, exponents, domains and objectives: `shadefit better ID`.\n\n",
      report_contest.width);
  for (const Comparison& comparison : comparisons) {
    out += fmt::format("### `{}`\n\n", target_of(comparison)) +
           markdown_block(short_comparison_table(comparison)) +
           "The best at the cost of each published curve:\n\n";
    for (const Contender& contender : comparison.contenders) {
      if (contender.kind == Kind::published)
        out += sentence(contender, best_against(comparison, contender.published));
    }
    out += "\n";
  }
  return out;
}

}  // namespace shadefit
