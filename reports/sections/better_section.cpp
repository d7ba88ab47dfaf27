#include "reports/sections/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <variant>

#include "fit/better/results.hpp"
#include "reports/io/mathematics.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/comparisons.hpp"

namespace shadefit {
namespace {

using ContenderKind = Contender::Kind;

/// The curve with the least error that beats a published one, or null.
const Contender* best_against(const Comparison& comparison, std::string_view published) {
  const Contender* best = nullptr;
  for (const Contender& contender : comparison.contenders) {
    const auto& beats = contender.beats;
    if (std::ranges::find(beats, published) == beats.end()) continue;
    if (best == nullptr || contender.max_abs_error.upper < best->max_abs_error.upper) best = &contender;
  }
  return best;
}

std::string origin(const Contender& contender) {
  return contender.kind == ContenderKind::published ? std::string(contender.published) : contender.origin;
}

/// "- `fresnel-one-term`, off by 0.03006 in 2 instructions: $2^{-A c}$ (minimax absolute error), off by
/// 0.02628 in 2."
std::string sentence(const Contender& published, const Contender* best) {
  const auto error = [](const Contender& c) {
    return text(Number{c.max_abs_error.lower, 4}, Precision::report);
  };
  const std::string what = fmt::format("- `{}`, off by {} in {} instructions: ", published.published,
                                       error(published), published.operations.total());
  if (best == nullptr) return what + "nothing here is better at its cost.\n";
  const std::string whose =
      fmt::format("{} ({}{})", mathematics(best->form),
                  best->kind == ContenderKind::published ? "published as " : "", origin(*best));
  return what + fmt::format("{}, off by {} in {}.\n", whose, error(*best), best->operations.total());
}

/// "Schlick's formula", "A lobe at k = 5", "Exact dielectric n = 1.5".
std::string heading_of(const Comparison& comparison) {
  if (comparison.setting.surface.is_exact()) {
    std::string name = target_of(comparison);
    name.front() = 'E';
    return name;
  }
  return comparison.family->has_exponent() ? fmt::format("A lobe at k = {}", comparison.setting.exponent)
                                           : "Schlick's formula";
}

/// The target as mathematics. Fresnel's equations are not one line.
std::string target_line(const Comparison& comparison) {
  if (comparison.setting.surface.is_exact()) return "";
  return fmt::format("The target is ${}$.\n\n", to_latex(comparison.family->target));
}

/// The table of a comparison, with its forms as mathematics.
std::string comparison_block(const Comparison& comparison) {
  Table table = short_comparison_table(comparison);
  for (auto& row : table.rows) row.front() = mathematics(std::get<std::string>(row.front()));
  return markdown_block(table);
}

}  // namespace

std::string better_section(const std::vector<Comparison>& comparisons) {
  std::string out = fmt::format(
      "## Published against best\n\n"
      "What would be better at the same cost? For each target, the table lists the published curves, and "
      "each form with its *minimax* constants: those that make the largest error smallest. Some forms were "
      "never published. Each largest error is proven to lie in an interval of relative width {:g}: the last "
      "digit shown is right to one unit. The other errors are computed but not proven, the rms error under "
      "the cosine measure. On a surface, errors are of the reflectance F. Operations are counted in the code "
      "that `shadefit emit` writes for one exponent, where expressions of constants are computed beforehand. "
      "A curve *beats* a published one if its proven error is smaller and it needs no more instructions. For "
      "other surfaces, exponents, domains and objectives see `shadefit better ID`.\n\n",
      report_comparison.width);
  for (const Comparison& comparison : comparisons) {
    out += fmt::format("### {}\n\n", heading_of(comparison)) + target_line(comparison) +
           comparison_block(comparison) +
           "For each published curve, the best curve that needs no more instructions:\n\n";
    for (const Contender& contender : comparison.contenders) {
      if (contender.kind == ContenderKind::published)
        out += sentence(contender, best_against(comparison, contender.published));
    }
    out += "\n";
  }
  return out;
}

}  // namespace shadefit
