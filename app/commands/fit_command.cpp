#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "app/commands/commands.hpp"
#include "app/commands/study_commands.hpp"
#include "app/options/fit_arguments.hpp"
#include "app/output/draw_figures.hpp"
#include "app/studies/chosen_study.hpp"
#include "fit/better/fit_extras.hpp"
#include "fit/better/results.hpp"
#include "fit/support/user_error.hpp"
#include "reports/figures/figures.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/utf8.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/alternation.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/rows/rounded.hpp"
#include "reports/rows/sensitivities.hpp"
#include "reports/rows/tables.hpp"

namespace shadefit {
namespace {

std::string console_text(const Refit& refit, const Metric& metric, const Terminal& terminal) {
  const Family& info = *refit.family;
  std::string text = fmt::format("{}: {} ~ {}, {}\n", info.id, target_of(refit.fits.front().fit),
                                 to_text(refit.family->form), headline(metric)) +
                     write_console(fits_overview(refit), Precision::report, terminal);
  for (const FitReport& report : refit.fits) text += alternation_text(report.fit);
  return text;
}

/// Requested additional results of each fit; else empty.
struct FitExtras {
  std::vector<RoundedFit> rounded;
  std::vector<std::optional<Sensitivity>> sensitivities;  ///< empty for a fit that did not converge
};

FitExtras extras_of(const Refit& refit, const FitOptions& options, const Checkpoint& checkpoint,
                    const Progress& progress) {
  FitExtras extras;
  const auto steps = [&](const char* what) {
    return stepping(checkpoint, progress, what, refit.fits.size());
  };
  if (options.round)
    extras.rounded = round_fits(refit, *options.round, !options.exponents, steps("round"), checkpoint);
  if (!options.sensitivity) return extras;
  const Checkpoint next = steps("sensitivity");
  for (const FitReport& report : refit.fits) {
    next();
    extras.sensitivities.emplace_back();
    if (report.fit.status == Status::converged)
      extras.sensitivities.back() = sensitivity_of(report.fit, checkpoint);
  }
  return extras;
}

/// The rounded constants of each fit for their table and their JSON; none if nobody asked for them.
std::vector<RoundedSets> rounded_sets(const Refit& refit, const FitExtras& extras) {
  std::vector<RoundedSets> all;
  for (std::size_t i = 0; i < extras.rounded.size(); ++i) {
    const Fit& fit = refit.fits[i].fit;
    RoundedSets& sets = all.emplace_back(
        RoundedSets{.rounded = extras.rounded[i].rounded,
                    .reason = extras.rounded[i].reason,
                    .error = fit.metric.error == Error::relative ? "max rel error" : "max abs error",
                    .parameters = refit.family->parameters,
                    .variables = {"c"}});
    if (fit.exponent) sets.given.emplace_back("exponent", Number{*fit.exponent, all_digits});
  }
  return all;
}

std::string fits_text(const Refit& refit, const FitOptions& options, const Metric& metric,
                      const FitExtras& extras, const Checkpoint& checkpoint) {
  if (options.csv) return write_csv(fits_table({refit}).table, Precision::full);
  if (options.latex) return write_latex(fits_overview(refit), Precision::report);
  if (!options.json) {
    std::string text = console_text(refit, metric, options.terminal);
    if (options.round) text += roundings_text(rounded_sets(refit, extras), options.terminal);
    for (std::size_t i = 0; i < extras.sensitivities.size(); ++i) {
      if (extras.sensitivities[i])
        text += sensitivity_text(refit.fits[i].fit, *extras.sensitivities[i], options.terminal);
    }
    return text;
  }
  const std::vector<RoundedSets> rounded = rounded_sets(refit, extras);
  auto array = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < refit.fits.size(); ++i) {
    checkpoint();
    array.push_back(write_fit_json(*refit.family, refit.fits[i]));
    if (options.round) {
      array.back()["rounded"] = rounding_json(rounded[i]);
      if (!rounded[i].rounded) array.back()["rounded_reason"] = rounded[i].reason;
    }
    if (options.sensitivity)
      array.back()["sensitivity"] = extras.sensitivities[i]
                                        ? sensitivity_json(refit.fits[i].fit, *extras.sensitivities[i])
                                        : nlohmann::ordered_json();
  }
  return json_text_of_each(array);
}

/// Constraints that a form cannot satisfy are an error of the user.
void require_feasible(const Refit& refit) {
  for (const FitReport& report : refit.fits) {
    if (report.fit.status == Status::infeasible)
      throw UserError(fmt::format("{} cannot satisfy the constraints{}: {}", which_fit(report.fit),
                                  describe(report.fit.metric.constraints), report.fit.why));
  }
}

}  // namespace

Outcome with_picture(Outcome outcome, const FitOptions& options, const std::function<Figure()>& figure,
                     const Checkpoint& checkpoint) {
  if (!options.plot) return outcome;
  outcome.put = draw_picture(figure(), *options.plot, options.force, checkpoint);
  const std::string file = printable(*options.plot);
  if (options.json || options.csv || options.latex)
    outcome.err += fmt::format("shadefit: picture: {}\n", file);
  else
    outcome.out += fmt::format("Picture: {}\n", file);
  return outcome;
}

Outcome fit_command(const FitOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  if (const auto study = chosen_study(options, checkpoint))
    return study_command(*study, options, checkpoint, progress);
  if (options.id.empty())
    throw UserError(
        "fit needs a family, a published constant, a study or --form (see 'shadefit list' and 'shadefit help fit')");
  if (options.certify)
    throw UserError("--certify belongs to a study or --form: see 'shadefit certify " + options.id + "'");
  if (options.evaluate)
    throw UserError(fmt::format("--evaluate '{}' belongs to a study or --form: for a family take --round",
                                to_text(*options.evaluate)));
  if (options.plot) require_picture(*options.plot);
  const auto [family_found, published] = find_fit(options.id);
  const Family& family = *family_found;
  if (published != nullptr && published->statement != Statement::best_fit)
    throw UserError(
        fmt::format("'{0}' is a mean or a limit of fits, no fit: see 'shadefit explain {0}'", published->id));

  const auto settings = settings_for(family, published, options);
  if (options.plot && settings.size() > 1)
    throw UserError(fmt::format("--plot '{}' draws one fit, and these are {}: name one with --exponent",
                                *options.plot, settings.size()));
  const Metric metric = metric_for(options, family, settings);
  FitCache fits(family);
  const Refit refit{&family,
                    {},
                    fit_and_assess(fits, settings, std::array{metric},
                                   stepping(checkpoint, progress, "fit", settings.size())),
                    {}};
  require_feasible(refit);
  const FitExtras extras = extras_of(refit, options, checkpoint, progress);
  const std::string err = not_converged_lines(refit);
  return with_picture(
      {err.empty() ? 0 : 1, fits_text(refit, options, metric, extras, checkpoint), err}, options,
      [&] { return fit_figure(refit); }, checkpoint);
}

}  // namespace shadefit
