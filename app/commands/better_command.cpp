#include <fmt/format.h>

#include <algorithm>

#include "app/commands/commands.hpp"
#include "app/commands/study_commands.hpp"
#include "app/options/fit_arguments.hpp"
#include "app/output/draw_figures.hpp"
#include "app/studies/chosen_study.hpp"
#include "approx/records/optical_constants.hpp"
#include "fit/better/better.hpp"
#include "fit/better/results.hpp"
#include "fit/proof/bound_width.hpp"
#include "fit/support/user_error.hpp"
#include "reports/figures/figures.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/comparisons.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/rows/tables.hpp"

/// The subcommand `better`.
namespace shadefit {
namespace {

Surface surface_of(const OpticalConstants& constants) {
  return exact_surface(constant<double>(constants.ior), constant<double>(constants.extinction));
}

/// Schlick's weight, and the exact reflectance of glass and of a metal.
std::vector<Setting> usual_surfaces() {
  return {Setting{}, Setting{0, surface_of(glass)}, Setting{0, surface_of(gold)}};
}

/// The settings of the comparison: those of the options, else the usual surfaces, or the first and last
/// exponent.
std::vector<Setting> settings_to_compare(const NamedFit& named, const FitOptions& options) {
  const Family& family = *named.family;
  if (options.target && !family.is_fresnel)
    throw UserError(fmt::format("--target does not apply: {} is not a Fresnel form", family.id));
  const std::vector<Setting> all = settings_for(family, named.published, options);
  if (family.is_fresnel && !options.target && !options.ior) return usual_surfaces();
  if (!family.has_exponent() || options.exponents) return all;
  const auto [lowest, highest] = std::ranges::minmax_element(all);
  return lowest == highest ? std::vector{*lowest} : std::vector{*lowest, *highest};
}

std::string console_text(const Comparison& comparison, const Terminal& terminal) {
  return fmt::format(
             "{}: max abs error proven to a relative {:g}; the last printed digit may be off by one\n",
             target_of(comparison), usual_width) +
         write_console(comparison_table(comparison), Precision::report, terminal) +
         left_out_lines(comparison.left_out);
}

std::string comparisons_text(const std::vector<Comparison>& comparisons, const FitOptions& options) {
  if (options.csv) return write_csv(comparisons_table(comparisons, Precision::full), Precision::full);
  if (options.json) return json_text_of_each(json_array(comparisons, write_comparison_json));
  return joined(comparisons, "\n",
                [&](const Comparison& comparison) { return console_text(comparison, options.terminal); });
}

}  // namespace

Outcome better_command(const FitOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  const StudyFile study = chosen_study(options, checkpoint);
  if (!is_known_id(options.id)) return better_study_command(study, options, checkpoint, progress);
  for (const char* option : {"--over", "--given", "--start", "--bounds"}) {
    if (options.present.contains(option))
      throw UserError(fmt::format("{} belongs to --form, a formula of your own, or to a study", option));
  }
  if (options.plot) require_picture(*options.plot);
  const NamedFit named = find_fit(options.id);
  const std::vector<Setting> settings = settings_to_compare(named, options);
  if (options.plot && settings.size() > 1)
    throw UserError(fmt::format("--plot '{}' draws one target, and these are {}: name one with {}",
                                *options.plot, settings.size(),
                                named.family->is_fresnel ? "--target" : "--exponent"));
  std::vector<Comparison> comparisons;
  std::string err;
  const Checkpoint next = stepping(checkpoint, progress, "better", settings.size());
  for (const Setting& setting : settings) {
    next();
    comparisons.push_back(compare_forms(*named.family, setting,
                                        {.domain = options.metric.domain, .width = usual_width}, checkpoint));
    err += not_reached_lines(comparisons.back());
  }
  return with_picture(
      {err.empty() ? 0 : 1, comparisons_text(comparisons, options), err}, options,
      [&] { return better_figure(comparisons.front()); }, checkpoint);
}

}  // namespace shadefit
