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
#include "reports/rows/alternation.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/rows/proofs.hpp"
#include "reports/rows/rounded.hpp"
#include "reports/rows/sensitivities.hpp"
#include "reports/rows/tables.hpp"
#include "reports/table/writers.hpp"

namespace shadefit {
namespace {

/// A mean or a limit of fits, requested by its own id.
Outcome derived_command(const FittableFamily& family, const Published& published, const FitOptions& options) {
  const std::string what = " is a mean or a limit of fits";
  const auto refuse = [&](const std::string& option, const std::string& why) {
    throw UserError(fmt::format("{} does not apply: {}{}", option, published.id, why));
  };
  if (options.exponents)
    refuse(fmt::format("--exponent '{}'", fmt::join(*options.exponents, ",")), " names its own exponents");
  if (options.certify) refuse("--certify", fmt::format("{}; see 'shadefit certify {}'", what, published.id));
  if (options.round) refuse(fmt::format("--round '{}'", to_text(*options.round)), what);
  if (options.plot) refuse(fmt::format("--plot '{}'", *options.plot), what);
  if (options.sensitivity) refuse("--sensitivity", what + ", which has no curve of its own");
  surface_for(family, options);  // refuses surface options: no such number belongs to a Fresnel form
  FitCache fits(family);
  const auto exponents = exponents_of(published);
  const std::vector<Setting> settings(exponents.begin(), exponents.end());
  const auto assessment = assess(fits, published, metric_for(options, family, settings));
  if (!assessment)
    return {1, "",
            fmt::format("shadefit: {} rests on fits that did not converge, or has no limit on this domain\n",
                        published.id)};
  const Refit refit{&family, {&published}, {}, {*assessment}};
  if (options.json) return {0, json_text(write_derived_json(*assessment)), ""};
  const Table table = fits_table({refit}).table;
  return {0,
          options.csv     ? write_csv(table, Precision::full)
          : options.latex ? write_latex(with_digits(table, options.digits), Precision::report)
                          : write_console(table, Precision::full, options.terminal),
          ""};
}

std::string console_text(const Refit& refit, const Metric& metric, const Terminal& terminal) {
  const Family& info = refit.family->info;
  std::string text = fmt::format("{}: {} ~ {}, {}\n", info.id, target_of(refit.fits.front().fit),
                                 to_text(refit.family->form()), headline(metric)) +
                     write_console(fits_overview(refit), Precision::report, terminal);
  for (const FitReport& report : refit.fits) text += alternation_text(report.fit);
  return text;
}

/// Requested additional results of each fit; else empty.
struct FitExtras {
  std::vector<FitProof> proofs;
  std::vector<RoundedFit> rounded;
  std::vector<std::optional<Sensitivity>> sensitivities;  ///< empty for a fit that did not converge
};

FitExtras extras_of(const Refit& refit, const FitOptions& options, const Checkpoint& checkpoint,
                    const Progress& progress) {
  FitExtras extras;
  const auto for_each_fit = [&](const char* what, const auto& use) {
    const Checkpoint next = stepping(checkpoint, progress, what, refit.fits.size());
    for (const FitReport& report : refit.fits) {
      next();
      use(report.fit);
    }
  };
  if (options.certify)
    for_each_fit("certify", [&](const Fit& fit) { extras.proofs.push_back(prove_fit(fit, checkpoint)); });
  if (options.round)
    extras.rounded = round_fits(refit, *options.round, !options.exponents,
                                stepping(checkpoint, progress, "round", refit.fits.size()), checkpoint);
  if (options.sensitivity)
    for_each_fit("sensitivity", [&](const Fit& fit) {
      extras.sensitivities.emplace_back();
      if (fit.status == Status::converged) extras.sensitivities.back() = sensitivity_of(fit, checkpoint);
    });
  return extras;
}

std::string fits_text(const Refit& refit, const FitOptions& options, const Metric& metric,
                      const FitExtras& extras, const Checkpoint& checkpoint) {
  if (options.csv) return write_csv(fits_table({refit}).table, Precision::full);
  if (options.latex) return write_latex(with_digits(fits_overview(refit), options.digits), Precision::report);
  if (!options.json) {
    std::string text = console_text(refit, metric, options.terminal);
    if (options.certify)
      text += "\n" + write_console(proofs_table(refit, extras.proofs), Precision::full, options.terminal);
    if (options.round)
      text += "\n" +
              write_console(rounded_table(refit, extras.rounded), Precision::report, options.terminal) +
              rounded_text(extras.rounded);
    for (std::size_t i = 0; i < extras.sensitivities.size(); ++i) {
      if (extras.sensitivities[i])
        text += sensitivity_text(refit.fits[i].fit, *extras.sensitivities[i], options.terminal);
    }
    return text;
  }
  auto array = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < refit.fits.size(); ++i) {
    checkpoint();
    array.push_back(write_fit_json(*refit.family, refit.fits[i]));
    if (options.certify) add_proof_json(array.back(), *refit.family, extras.proofs[i]);
    if (options.round) add_rounded_json(array.back(), *refit.family, extras.rounded[i]);
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

Outcome with_picture(Outcome outcome, const FitOptions& options) {
  if (!options.plot) return outcome;
  const std::string file = printable(*options.plot);
  if (options.json || options.csv || options.latex)
    outcome.err += fmt::format("shadefit: picture: {}\n", file);
  else
    outcome.out += fmt::format("Picture: {}\n", file);
  return outcome;
}

Outcome fit_command(const FitOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  if (const auto study = chosen_study(options, checkpoint))
    return with_picture(study_command(*study, options, checkpoint, progress), options);
  if (options.id.empty())
    throw UserError(
        "fit needs a family, a published constant, a study or --form (see 'shadefit list' and 'shadefit help fit')");
  if (options.plot) require_picture(*options.plot);
  const auto [family_found, published] = find_fit(options.id);
  const FittableFamily& family = *family_found;
  if (published != nullptr && published->statement != Statement::best_fit)
    return derived_command(family, *published, options);

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
  const std::string err = not_converged_lines(refit) + not_reached_lines(refit, extras.proofs);
  const auto put = options.plot ? draw_picture(fit_figure(refit), *options.plot, options.force, checkpoint)
                                : std::function<void()>();
  return with_picture({err.empty() ? 0 : 1, fits_text(refit, options, metric, extras, checkpoint), err, put},
                      options);
}

}  // namespace shadefit
