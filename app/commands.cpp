#include "app/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/fit_arguments.hpp"
#include "app/metric_options.hpp"
#include "app/slow_tables.hpp"
#include "approx/catalogue.hpp"
#include "approx/ledger.hpp"
#include "fit/ledger.hpp"
#include "fit/sweep.hpp"
#include "fit/user_error.hpp"
#include "reports/alternation.hpp"
#include "reports/baseline.hpp"
#include "reports/comparisons.hpp"
#include "reports/fit_json.hpp"
#include "reports/gnuplot.hpp"
#include "reports/ledger_section.hpp"
#include "reports/plots.hpp"
#include "reports/proofs.hpp"
#include "reports/report.hpp"
#include "reports/rounded.hpp"
#include "reports/sensitivities.hpp"
#include "reports/tables.hpp"
#include "reports/utf8.hpp"
#include "reports/writers.hpp"

namespace shadefit {
namespace {

const Published* find_published(const std::string& id) {
  const auto found = std::find_if(published_constants.begin(), published_constants.end(),
                                  [&](const Published& p) { return p.id == id; });
  return found == published_constants.end() ? nullptr : &*found;
}

/// Ids that `fit` takes; a normalisation is named for what it is.
std::vector<std::string> ids_with_a_fit() {
  std::vector<std::string> ids = known_ids();
  std::erase_if(
      ids, [](const std::string& id) { return find_family(id) == nullptr && find_published(id) == nullptr; });
  return ids;
}

std::vector<double> exponents_for(const FittableFamily& family, const Published* published,
                                  const std::optional<std::string>& text) {
  if (!family.has_exponent()) {
    if (!text) return {};
    throw UserError(fmt::format("--exponent '{}' does not apply: {} has no exponent", *text, family.info.id));
  }
  if (!text) return published != nullptr ? exponents_of(*published) : parse_sweep(family.info.sweep);
  try {
    return parse_sweep(*text);
  } catch (const UserError& error) {
    throw UserError(fmt::format("--exponent {}: give K or A:B:STEP, by commas", error.what()));
  }
}

/// A reflectance at normal incidence that leaves something to be fitted.
double parse_f0(const std::string& text) {
  const double f0 = parse_finite("--f0", text);
  if (!(0 <= f0 && f0 < 1))
    throw UserError(
        fmt::format("--f0 '{}' is no reflectance at normal incidence: it must be in [0, 1)", text));
  return f0;
}

/// The surface that a Fresnel form is fitted to.
Surface parse_surface(const FittableFamily& family, const FitOptions& options) {
  if (options.target != "schlick" && options.target != "exact") {
    throw UserError(
        fmt::format("--target '{}' is unknown: it must be one of schlick, exact", options.target));
  }
  const bool is_exact = options.target == "exact";
  if (!family.is_fresnel()) {
    const auto refuse = [&](const char* option, const std::string& value) {
      throw UserError(
          fmt::format("{} '{}' does not apply: {} is no Fresnel form", option, value, family.info.id));
    };
    if (is_exact) refuse("--target", options.target);
    if (options.ior) refuse("--ior", *options.ior);
    if (options.extinction) refuse("--extinction", *options.extinction);
    if (options.f0) refuse("--f0", *options.f0);
    return {};
  }
  if (!options.ior && !is_exact) {
    if (options.extinction)
      throw UserError(
          fmt::format("--extinction '{}' does not apply: it belongs to --ior", *options.extinction));
    Surface any;
    if (options.f0) any.f0 = parse_f0(*options.f0);
    return any;
  }
  if (options.f0)
    throw UserError(fmt::format("--f0 '{}' does not apply: a surface of --ior has its own", *options.f0));
  const std::string index = options.ior.value_or("1.5");
  const double ior = parse_finite("--ior", index);
  const double extinction = options.extinction ? parse_finite("--extinction", *options.extinction) : 0;
  if (!(extinction >= 0))
    throw UserError(fmt::format("--extinction '{}' is negative: it must be 0 or more", *options.extinction));
  if (!(ior > 0) || (ior == 1 && extinction == 0))
    throw UserError(fmt::format(
        "--ior '{}' is no index of an interface: it must be greater than 0, and without extinction not 1",
        index));
  return {is_exact ? Surface::Formula::exact : Surface::Formula::schlick, ior, extinction, std::nullopt};
}

}  // namespace

std::vector<Setting> settings_for(const FittableFamily& family, const Published* published,
                                  const FitOptions& options) {
  const Surface surface = parse_surface(family, options);
  const auto exponents = exponents_for(family, published, options.exponent);
  if (!family.has_exponent()) return {Setting{0, surface}};
  return {exponents.begin(), exponents.end()};
}

NamedFit find_fit(const std::string& id) {
  const bool is_normalisation = std::any_of(normalisations.begin(), normalisations.end(),
                                            [&](const Normalisation& n) { return n.id == id; });
  if (is_normalisation) {
    throw UserError(fmt::format("'{0}' is integrated, not fitted: see 'shadefit run --only {0}'", id));
  }
  if (find_claim(id) != nullptr && find_family(id) == nullptr && find_published(id) == nullptr) {
    throw UserError(fmt::format("'{0}' is a claim, not fitted: see 'shadefit explain {0}'", id));
  }
  require_known(id, ids_with_a_fit(), "constant to fit");
  const Published* published = find_family(id) == nullptr ? find_published(id) : nullptr;
  return {find_family(published != nullptr ? published->family : std::string_view(id)), published};
}

namespace {

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2) + "\n";
}

/// A mean or a limit of fits, asked for by its own id.
Outcome derived_command(const FittableFamily& family, const Published& published, const FitOptions& options) {
  if (options.exponent) {
    throw UserError(fmt::format("--exponent '{}' does not apply: {} names its own exponents",
                                *options.exponent, published.id));
  }
  if (options.certify) {
    throw UserError(
        fmt::format("--certify does not apply: {0} is a mean or a limit of fits; see 'shadefit certify {0}'",
                    published.id));
  }
  if (options.round) {
    throw UserError(fmt::format("--round '{}' does not apply: {} is a mean or a limit of fits",
                                *options.round, published.id));
  }
  if (options.sensitivity) {
    throw UserError(fmt::format(
        "--sensitivity does not apply: {} is a mean or a limit of fits, which has no curve of its own",
        published.id));
  }
  parse_surface(family, options);  // no such number is of a Fresnel form: refuses what would be ignored
  FitCache fits(family);
  const auto exponents = exponents_of(published);
  const std::vector<Setting> settings(exponents.begin(), exponents.end());
  const auto assessment = assess(fits, published, parse_metric(options, family, settings));
  if (!assessment)
    return {1, "",
            fmt::format("shadefit: {} rests on fits that did not converge, or has no limit on this domain\n",
                        published.id)};
  const Refit refit{&family, {&published}, {}, {*assessment}};
  if (options.json) return {0, json_text(write_derived_json(*assessment)), ""};
  const Table table = fits_table({refit}).table;
  const auto write = options.csv ? write_csv : options.latex ? write_latex : write_console;
  return {0, write(table, Precision::full), ""};
}

/// "cosine measure, least squares", or what else the metric says.
std::string headline(const Metric& metric) {
  if (metric.norm == Norm::minimax)
    return describe(metric) +
           fmt::format("; the {} measure counts for the rms error alone", name(metric.measure));
  const bool is_plain =
      metric.error == Error::absolute && metric.weight.empty() && metric.constraints == Constraints{};
  return is_plain ? describe(metric) + " measure, least squares"
                  : "least squares, measure: " + describe(metric);
}

std::string console_text(const Refit& refit, const Metric& metric) {
  const Family& info = refit.family->info;
  std::string text = fmt::format("{}: {} ~ {}, {}\n", info.id, target_of(refit.fits.front().fit),
                                 to_text(refit.family->form()), headline(metric)) +
                     write_console(fits_overview(refit), Precision::report);
  for (const FitReport& report : refit.fits) text += alternation_text(report.fit);
  return text;
}

/// The proofs of each fit, where they are asked for.
std::vector<FitProof> proofs_of(const Refit& refit, const FitOptions& options, const Checkpoint& checkpoint) {
  std::vector<FitProof> proofs;
  for (const FitReport& report : refit.fits) {
    if (!options.certify) break;
    checkpoint();
    proofs.push_back(prove_fit(report.fit));
  }
  return proofs;
}

/// How sensitive each fit is, where it is asked for; empty for one that did not converge.
std::vector<std::optional<Sensitivity>> sensitivities_of(const Refit& refit, const FitOptions& options,
                                                         const Checkpoint& checkpoint) {
  std::vector<std::optional<Sensitivity>> sensitivities;
  for (const FitReport& report : refit.fits) {
    if (!options.sensitivity) break;
    checkpoint();
    const bool is_answer = report.fit.status == Status::converged;
    sensitivities.push_back(is_answer ? std::optional(sensitivity_of(report.fit, checkpoint)) : std::nullopt);
  }
  return sensitivities;
}

/// Constants that are rounded keep no constraint but given values.
void require_free_rounding(const FitOptions& options) {
  if (!options.sensitivity) return;
  const auto refuse = [](const char* option, const std::string& value) {
    throw UserError(
        fmt::format("{} '{}' does not go with --sensitivity: constants that are rounded do not keep to it",
                    option, value));
  };
  if (!options.exact_at.empty()) refuse("--exact-at", options.exact_at.front());
  if (options.one_sided) refuse("--one-sided", *options.one_sided);
  if (options.at_most) refuse("--at-most", *options.at_most);
  if (options.at_least) refuse("--at-least", *options.at_least);
}

/// What is told of each fit where it is asked for; else empty.
struct FitExtras {
  std::vector<FitProof> proofs;
  std::vector<RoundedFit> rounded;
  std::vector<std::optional<Sensitivity>> sensitivities;
};

std::string fits_text(const Refit& refit, const FitOptions& options, const Metric& metric,
                      const FitExtras& extras) {
  if (options.csv) return write_csv(fits_table({refit}).table, Precision::full);
  if (options.latex) return write_latex(fits_overview(refit), Precision::report);
  if (!options.json) {
    std::string text = console_text(refit, metric);
    if (options.certify) text += "\n" + write_console(proofs_table(refit, extras.proofs), Precision::full);
    if (options.round)
      text += "\n" + write_console(rounded_table(refit, extras.rounded), Precision::report) +
              rounded_text(extras.rounded);
    for (std::size_t i = 0; i < extras.sensitivities.size(); ++i) {
      if (extras.sensitivities[i]) text += sensitivity_text(refit.fits[i].fit, *extras.sensitivities[i]);
    }
    return text;
  }
  auto array = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < refit.fits.size(); ++i) {
    array.push_back(write_fit_json(*refit.family, refit.fits[i]));
    if (options.certify) add_proof_json(array.back(), *refit.family, extras.proofs[i]);
    if (options.round) add_rounded_json(array.back(), *refit.family, extras.rounded[i]);
    if (options.sensitivity)
      array.back()["sensitivity"] = extras.sensitivities[i]
                                        ? sensitivity_json(refit.fits[i].fit, *extras.sensitivities[i])
                                        : nlohmann::ordered_json();
  }
  return json_text(array.size() == 1 ? array.front() : array);
}

/// "sg-offset at exponent 5".
std::string which_fit(const Fit& fit) {
  return std::string(fit.family->id) + (fit.exponent ? fmt::format(" at exponent {}", *fit.exponent) : "");
}

std::string not_converged_lines(const Refit& refit) {
  std::string lines;
  for (const FitReport& report : refit.fits) {
    if (report.fit.status == Status::converged) continue;
    lines += fmt::format("shadefit: {} did not converge: {}{}\n", which_fit(report.fit),
                         name(report.fit.status), report.fit.why.empty() ? "" : ": " + report.fit.why);
  }
  return lines;
}

/// Constraints that a form cannot satisfy are the user's to mend.
void require_feasible(const Refit& refit) {
  for (const FitReport& report : refit.fits) {
    if (report.fit.status == Status::infeasible)
      throw UserError(fmt::format("{} cannot satisfy the constraints{}: {}", which_fit(report.fit),
                                  describe(report.fit.metric.constraints), report.fit.why));
  }
}

/// What a run says of its plots, on standard output and standard error.
struct PlotsNews {
  std::string out, err;
};

/// Draws the pictures that can be drawn, then writes everything at once: the report shows the figures that
/// there is a picture of.
PlotsNews write_results(const RunOptions& options, const Results& results, const Checkpoint& checkpoint) {
  auto figures = options.plots ? make_figures(results) : std::vector<Figure>{};
  auto files = plot_files(figures);
  const std::size_t all = figures.size();
  const auto directory = printable((without_detours(options.out) / "plots").string());
  // Of the pictures that this run does not draw, none of an older run may stand beside the new data.
  std::vector<std::string> missing;
  for (const Figure& figure : figures) missing.push_back("plots/" + figure.name + ".svg");
  PlotsNews news;
  if (const auto gnuplot = all > 0 ? find_gnuplot() : std::nullopt) {
    std::vector<std::string> names;
    for (const Figure& figure : figures) names.push_back(figure.name);
    const Pictures pictures = draw_pictures(*gnuplot, files, names, checkpoint);
    files.insert(files.end(), pictures.files.begin(), pictures.files.end());
    for (const File& drawn : pictures.files) std::erase(missing, drawn.name);
    for (const FailedPlot& failed : pictures.failed) {
      news.err +=
          fmt::format("shadefit: plot {} was not drawn: {}\n", failed.name, one_line(failed.complaint));
      std::erase_if(figures, [&](const Figure& figure) { return figure.name == failed.name; });
    }
    news.out = fmt::format("\nPlots: {} of {} drawn in {}\n", figures.size(), all, directory);
  } else if (all > 0) {
    figures.clear();
    news.out =
        fmt::format("\nPlots skipped: gnuplot was not found; their data and scripts are in {}\n", directory);
  }
  const auto report = report_files(results, figures);
  files.insert(files.end(), report.begin(), report.end());
  write_files(options.out, files, checkpoint, missing);
  return news;
}

/// One line for each check that failed.
std::string failed_lines(const Results& results) {
  if (all_checks_passed(results)) return "";
  std::string err;
  for (const Refit& refit : results.refits) err += not_converged_lines(refit);
  for (const FresnelLink& link : results.fresnel_chain) {
    if (link.status == Status::converged) continue;
    err +=
        fmt::format("shadefit: {} on {} (n = {}, k = {}) did not converge: {}\n", link.family->info.id,
                    link.surface->material, link.surface->ior, link.surface->extinction, name(link.status));
  }
  for (const auto& check : results.normalisations) {
    if (check.verdict == Verdict::confirmed) continue;
    err +=
        fmt::format("shadefit: {} at exponent {} failed: closed form {}, integral {}, estimated error {}\n",
                    check.record->id, check.exponent.value_or(0), check.closed_form, check.integral,
                    check.estimated_error);
  }
  for (const JudgedClaim& judged : results.claims) {
    if (judged.finding.verdict) continue;
    err += fmt::format("shadefit: {} could not be judged: {}\n", judged.claim->id, judged.finding.evidence);
  }
  for (const Comparison& comparison : results.comparisons) {
    err += not_reached_lines(comparison);
    for (const std::string& fit : comparison.left_out)
      err += fmt::format("shadefit: {}: {}\n", target_of(comparison), fit);
  }
  for (const auto& curve : results.reflectances) {
    for (const auto& point : curve.points) {
      if (point.estimated_error <= reflectance_tolerance) continue;
      err += fmt::format(
          "shadefit: the reflectance of {} at exponent {}, view angle {} failed: estimated error {}\n",
          curve.record->id, curve.exponent, point.view_angle, point.estimated_error);
    }
  }
  return err;
}

Verdict parse_verdict(const std::string& text) {
  std::vector<std::string> known;
  for (const Verdict verdict : all_verdicts) {
    if (text == name(verdict)) return verdict;
    known.emplace_back(name(verdict));
  }
  throw UserError(
      fmt::format("--verdict '{}' is unknown: it must be one of {}", text, fmt::join(known, ", ")));
}

std::vector<JudgedClaim> claims_with(Verdict verdict, const Checkpoint& checkpoint) {
  auto claims = judge_claims([](std::string_view) { return true; }, checkpoint);
  std::erase_if(claims, [&](const JudgedClaim& judged) { return judged.finding.verdict != verdict; });
  return claims;
}

std::vector<JudgedClaim> unjudged_claims() {
  std::vector<JudgedClaim> claims;
  for (const Topic& topic : ledger) {
    for (const Claim& claim : topic.claims) claims.push_back({&topic, &claim, {}});
  }
  return claims;
}

}  // namespace

Outcome list_command(const ListOptions& options, const Checkpoint& checkpoint) {
  const bool with_verdicts = options.verdict.has_value();
  const auto claims =
      with_verdicts ? claims_with(parse_verdict(*options.verdict), checkpoint) : unjudged_claims();
  const bool is_narrow = !options.json && !options.latex;
  Table list = is_narrow ? claims_for_a_terminal(claims, with_verdicts) : claims_list(claims, with_verdicts);
  if (!with_verdicts) add_forms_of_comparison(list);
  if (options.json) return {0, json_text({{"schema", 1}, {"constants", write_json(list)}}), ""};
  const auto write = options.latex ? write_latex : write_console;
  return {0, write(list, Precision::report), ""};
}

Outcome explain_command(const ExplainOptions& options) {
  require_known(options.id, claim_ids(), "claim");
  const auto judged = judge_claims([&](std::string_view id) { return id == options.id; });
  return {judged.front().finding.verdict ? 0 : 1, explanation(judged.front()), ""};
}

Outcome run_command(const RunOptions& options, const Checkpoint& checkpoint) {
  require_directory(options.out);
  const Results results = compute_results(options.only, checkpoint);
  const PlotsNews news = write_results(options, results, checkpoint);
  std::vector<std::string> parts;
  const Table summary = summary_table(results);
  if (!summary.rows.empty()) parts.push_back(write_console(summary, Precision::report));
  // Asked for by name, claims are shown; of all of them there are too many.
  if (!options.only.empty() && !results.claims.empty())
    parts.push_back(write_console(claims_for_a_terminal(results.claims, true), Precision::report));
  if (!results.claims.empty()) parts.push_back(fmt::format("Ledger: {}\n", verdict_counts(results.claims)));
  std::string out = fmt::format("{}", fmt::join(parts, "\n"));
  out += news.out;
  out += fmt::format("\nReport: {}\n", printable((without_detours(options.out) / "report.md").string()));
  const std::string err = news.err + failed_lines(results);
  return {err.empty() ? 0 : 1, out, err};
}

Outcome fit_command(const FitOptions& options, const Checkpoint& checkpoint) {
  const auto [family_found, published] = find_fit(options.id);
  const FittableFamily& family = *family_found;
  if (published != nullptr && published->statement != Statement::best_fit)
    return derived_command(family, *published, options);

  const auto settings = settings_for(family, published, options);
  const Metric metric = parse_metric(options, family, settings);
  const auto format = options.round ? std::optional(parse_number_format(*options.round)) : std::nullopt;
  require_free_rounding(options);
  FitCache fits(family);
  const Refit refit{&family, {}, fit_and_assess(fits, settings, std::array{metric}, checkpoint), {}};
  require_feasible(refit);
  const FitExtras extras{
      proofs_of(refit, options, checkpoint),
      format ? round_reports(refit, *format, !options.exponent, checkpoint) : std::vector<RoundedFit>{},
      sensitivities_of(refit, options, checkpoint)};
  const std::string err = not_converged_lines(refit) + not_reached_lines(refit, extras.proofs);
  return {err.empty() ? 0 : 1, fits_text(refit, options, metric, extras), err};
}

Outcome check_command(const CheckOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  const Baseline baseline = read_baseline(options.baseline);
  const Results results = compute_results({}, checkpoint);
  auto drifts = compare(baseline, results);
  std::size_t cells = count_cells(results);
  for (const SlowTableMaker make : options.all ? slow_table_makers : std::vector<SlowTableMaker>{}) {
    const auto files = make(checkpoint, progress);
    const auto more = compare_files(std::filesystem::path(options.baseline) / slow_tables_folder, files);
    drifts.insert(drifts.end(), more.begin(), more.end());
    cells += count_cells(files);
  }
  if (drifts.empty())
    return {0, fmt::format("check passed: {} cells agree with {}\n", cells, options.baseline), ""};
  Table table{{"file", "row", "column", "baseline", "now", "effect"}, {}};
  for (const Drift& d : drifts) table.rows.push_back({d.file, d.row, d.column, d.before, d.after, d.effect});
  return {1,
          write_console(table, Precision::report) +
              fmt::format("\ncheck failed: {} {} from {}\n", drifts.size(),
                          drifts.size() == 1 ? "difference" : "differences", options.baseline),
          ""};
}

}  // namespace shadefit
