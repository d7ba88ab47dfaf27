#include "app/commands/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <filesystem>

#include "app/commands/study_commands.hpp"
#include "app/lint/lint_command.hpp"
#include "app/output/draw_figures.hpp"
#include "app/output/output_file.hpp"
#include "app/output/slow_tables.hpp"
#include "app/studies/find_study.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/input/known.hpp"
#include "fit/ledger/ledger.hpp"
#include "fit/support/user_error.hpp"
#include "reports/figures/figures.hpp"
#include "reports/findings/baseline.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/utf8.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/rows/tables.hpp"
#include "reports/sections/ledger_section.hpp"
#include "reports/sections/report.hpp"
#include "reports/studies/study_rows.hpp"

namespace shadefit {
namespace {

/// One line for each check that failed.
std::string failed_lines(const Results& results) {
  if (all_checks_passed(results)) return "";
  std::string err;
  const auto fail = [&](const std::string& what, const std::string& why) {
    err += fmt::format("shadefit: {}: {}\n", what, why);
  };
  for (const Refit& refit : results.refits) err += not_converged_lines(refit);
  for (const FresnelLink& link : results.fresnel_chain) {
    if (link.status != Status::converged)
      fail(fmt::format("{} on {}", link.family->id, link.surface->material), std::string(name(link.status)));
  }
  for (const auto& check : results.normalisations) {
    if (check.verdict != Verdict::confirmed)
      fail(fmt::format("{} at exponent {}", check.record->id, check.exponent.value_or(0)),
           fmt::format("closed form {}, integral {}, estimated error {}", check.closed_form, check.integral,
                       check.estimated_error));
  }
  for (const JudgedClaim& judged : results.claims)
    if (!judged.finding.verdict) fail(std::string(judged.claim->id), judged.finding.evidence);
  for (const TargetComparison& target : results.comparisons) {
    for (const StudyContender& contender : target.comparison.contenders) {
      if (contender.published != nullptr && !contender.proof)
        fail(target.title, contender.form + ": " + contender.unproven);
    }
  }
  for (const auto& curve : results.reflectances) {
    for (const auto& point : curve.points) {
      if (point.estimated_error > reflectance_tolerance)
        fail(fmt::format("{} at exponent {}, view angle {}", curve.record->id, curve.exponent,
                         point.view_angle),
             fmt::format("estimated error {}", point.estimated_error));
    }
  }
  return err;
}

/// Whether a claim is about a family: about one of its published numbers, or by its name.
bool is_on(std::string_view claim, std::string_view family) {
  return claim == family || claim.starts_with(std::string(family) + "-") ||
         std::ranges::any_of(published_constants(),
                             [&](const Published& p) { return p.id == claim && p.family == family; });
}

/// All claims, or those with a verdict, which are judged.
std::vector<JudgedClaim> wanted_claims(const std::optional<Verdict>& verdict, const Checkpoint& checkpoint) {
  std::vector<JudgedClaim> claims;
  if (verdict) {
    Fits fits;
    claims = judge_claims([](std::string_view) { return true; }, fits, checkpoint);
    std::erase_if(claims, [&](const JudgedClaim& judged) { return judged.finding.verdict != *verdict; });
    return claims;
  }
  for (const Topic& topic : ledger())
    for (const Claim& claim : topic.claims) claims.push_back({&topic, &claim, {}});
  return claims;
}

/// A row for a study.
void add_study(Table& list, const StudyFile& file) {
  const std::string printed = file.published.empty() ? "-" : equations(file.published.front().values);
  auto& row = list.rows.emplace_back(std::vector<Cell>{file.id, printed, "a study: " + file.title});
  if (list.columns.size() == 4)
    row.insert(row.begin() + 2, fmt::format("{} ~ {}", file.study.target, file.forms.front().formula));
}

/// The claim that states the published constant of that id; any other id is returned.
std::string claim_of(const std::string& id) {
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) {
      for (const Published& constant : claim.constants) {
        if (constant.id == id) return std::string(claim.id);
      }
    }
  }
  return id;
}

/// What a family is, and every claim on it.
Outcome explain_family(const Family& family, const ExplainOptions& options, const Checkpoint& checkpoint) {
  const std::string id(family.id), form = to_text(family.form), target = to_text(family.target);
  Fits fits;
  const auto claims =
      judge_claims([&](std::string_view claim) { return is_on(claim, id); }, fits, checkpoint);
  if (options.json)
    return {0,
            json_text({{"schema", 1},
                       {"family", id},
                       {"title", family.title},
                       {"form", form},
                       {"target", target},
                       {"claims", json_array(claims, explanation_json)}}),
            ""};
  std::string out = fmt::format("{}: {}\nForm: {}; {}\nTarget: {}\nNext: shadefit better {}\n", id,
                                family.title, form, family.variables, target, id);
  for (const JudgedClaim& judged : claims) out += "\n" + explanation(judged, options.terminal);
  return {0, out, ""};
}

/// Keeps the rows whose id contains the text. Throws UserError if none does.
void keep_only(Table& list, const std::string& text, const ListOptions& options) {
  std::erase_if(list.rows,
                [&](const auto& row) { return !boost::icontains(std::get<std::string>(row.front()), text); });
  if (!list.rows.empty()) return;
  if (!options.verdict)
    throw UserError(fmt::format("no id contains '{}': 'shadefit list' prints all ids", text));
  const std::vector<std::string> studies = study_ids(study_folders(options.studies));
  const auto study =
      std::ranges::find_if(studies, [&](const std::string& id) { return boost::icontains(id, text); });
  throw UserError(fmt::format(
      "no claim with '{}' in its id passes --verdict '{}'{}", text, name(*options.verdict),
      study == studies.end() ? "" : fmt::format("; '{0}' is a study: see 'shadefit explain {0}'", *study)));
}

/// Studies have no place among the results of what is built in.
void refuse_studies(const RunOptions& options) {
  const std::vector<std::string> known = known_ids();
  for (const std::string& id : options.only) {
    if (std::ranges::find(known, id) == known.end() && find_study(id, study_folders(options.studies)))
      throw UserError(fmt::format("--only '{0}' is a study: see 'shadefit run {0}'", id));
  }
}

}  // namespace

Outcome list_command(const ListOptions& options, const Checkpoint& checkpoint) {
  const bool with_verdicts = options.verdict.has_value();
  Table list =
      claims_list(wanted_claims(options.verdict, checkpoint), with_verdicts, options.json || options.csv);
  const bool is_file = options.id && options.id->ends_with(".toml");
  std::string err;
  if (is_file) {
    list.rows.clear();
    add_study(list, load_study(*options.id));
  } else if (!with_verdicts) {
    add_forms_of_comparison(list);
    const LoadedStudies studies = load_studies(known_study_files(study_folders(options.studies)));
    for (const StudyFile& study : studies.files) add_study(list, study);
    for (const std::string& line : studies.refused) err += fmt::format("shadefit: {}\n", line);
  }
  if (options.id && !is_file) keep_only(list, *options.id, options);
  if (options.json) return {0, json_text({{"schema", 1}, {"constants", write_json(list)}}), err};
  if (options.csv) return {0, write_csv(list, Precision::full), err};
  return {0, write_console(list, Precision::report, options.terminal), err};
}

Outcome explain_command(const ExplainOptions& options, const Checkpoint& checkpoint,
                        const Progress& progress) {
  std::vector<std::string> known = claim_ids();
  const std::string claim = claim_of(options.id);
  if (std::ranges::find(known, claim) == known.end()) {
    const auto folders = study_folders(options.studies);
    if (const auto study = find_study(options.id, folders))
      return explain_study_command(*study, options, checkpoint, progress);
    if (const Family* family = find_family(claim)) return explain_family(*family, options, checkpoint);
    if (auto number = explain_number(options)) return *std::move(number);
    for (const Family& family : families()) known.emplace_back(family.id);
    for (const auto& path : known_study_files(folders)) known.push_back(path.stem().string());
    require_known(claim, known, "claim, family or study");
  }
  Fits fits;
  const JudgedClaim judged = judge_claims([&](std::string_view id) { return id == claim; }, fits).front();
  return {judged.finding.verdict ? 0 : 1,
          options.json ? json_text(explanation_json(judged)) : explanation(judged, options.terminal), ""};
}

Outcome run_command(const RunOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  if (options.html) return gallery_command(options, checkpoint, progress);
  if (options.study)
    return run_study_command(named_study(*options.study, study_folders(options.studies)), options,
                             checkpoint);
  refuse_studies(options);
  const OutputFolder folder(options.out);
  const Results results = compute_results(options.only, checkpoint);
  // The report shows only figures with a picture, so these are drawn first.
  auto figures = options.no_plots ? std::vector<Figure>{} : make_figures(results);
  auto [files, missing, said, failed] = draw_figures(figures, options.out, checkpoint);
  const auto report = report_files(results, figures);
  files.insert(files.end(), report.begin(), report.end());
  const auto put = folder.prepare(files, missing, options.force, checkpoint);
  std::vector<std::string> parts;
  const Table summary = summary_table(results);
  if (!summary.rows.empty()) parts.push_back(write_console(summary, Precision::report, options.terminal));
  // Claims are shown only if requested by name; all of them would be too many.
  if (!options.only.empty() && !results.claims.empty())
    parts.push_back(
        write_console(claims_list(results.claims, true, false), Precision::report, options.terminal));
  if (!results.claims.empty()) parts.push_back(fmt::format("Ledger: {}\n", verdict_counts(results.claims)));
  std::string out = fmt::format("{}", fmt::join(parts, "\n"));
  out += said;
  out +=
      fmt::format("\nReport: {}\n", printable((std::filesystem::path(options.out) / "report.md").string()));
  const std::string err = failed + failed_lines(results);
  return {err.empty() ? 0 : 1, out, err, put};
}

Outcome check_outcome(const CheckedTables& checked, const CheckOptions& options) {
  if (options.format != findings::FindingFormat::text) {
    const auto report = drift_findings(checked, options.fail_above);
    return {findings::passes(report) ? 0 : 1, findings::write_findings(report, options.format), ""};
  }
  const auto& [drifts, cells] = checked;
  const std::string baseline = printable(options.baseline);
  if (drifts.empty()) return {0, fmt::format("check passed: {} cells agree with {}\n", cells, baseline), ""};
  Table table{{"file", "row", "column", "baseline", "now", "effect"}};
  // These texts come from the baseline's files and may hold anything, so each becomes one short line.
  for (const Drift& d : drifts) {
    table.rows.push_back({d.file, one_line(d.row), d.column, one_line(d.before), d.after, d.effect});
  }
  const auto failing = std::ranges::count_if(
      drifts, [&](const Drift& drift) { return is_failing(drift, options.fail_above); });
  const std::string above =
      options.fail_above ? fmt::format(", {} above {:g} %", failing, 100 * *options.fail_above) : "";
  return {failing == 0 ? 0 : 1,
          write_console(table, Precision::report, options.terminal) +
              fmt::format("\ncheck {}: {} {} from {}{}\n", failing == 0 ? "passed" : "failed", drifts.size(),
                          drifts.size() == 1 ? "difference" : "differences", baseline, above),
          ""};
}

Outcome check_command(const CheckOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  if (options.study) {
    const StudyFile study = named_study(*options.study, study_folders(options.studies));
    if (!options.present.contains("--baseline"))
      throw UserError(
          fmt::format("check needs --baseline for a study: DIR of an earlier 'shadefit run {} --out DIR'",
                      *options.study));
    return check_study_command(study, options, checkpoint);
  }
  const Baseline baseline = read_baseline(options.baseline);
  // Reads the baselines of the slow tables too, before anything is computed.
  std::vector<Baseline> slow_baselines;
  for (const SlowTables& slow : options.all ? slow_tables : std::vector<SlowTables>{}) {
    slow_baselines.push_back(
        read_tables(std::filesystem::path(options.baseline) / slow_tables_folder, slow.names));
  }
  std::string recomputed;
  if (options.all) {
    for (const auto& path : study_files(study_folders(options.studies)))
      recomputed += recomputed_text(load_study(path), checkpoint);
  }
  const Results results = compute_results({}, checkpoint);
  CheckedTables checked = compare(baseline, results);
  for (std::size_t i = 0; i < slow_baselines.size(); ++i) {
    const auto files = slow_tables[i].make(checkpoint, progress);
    const auto more = compare_files(slow_baselines[i], files);
    checked.drifts.insert(checked.drifts.end(), more.drifts.begin(), more.drifts.end());
    checked.cells += more.cells;
  }
  Outcome outcome = check_outcome(checked, options);
  if (options.format == findings::FindingFormat::text) outcome.out = recomputed + outcome.out;
  return outcome;
}

}  // namespace shadefit
