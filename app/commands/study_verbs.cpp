#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "app/commands/commands.hpp"
#include "app/options/option_values.hpp"
#include "app/output/draw_figures.hpp"
#include "app/output/output_file.hpp"
#include "app/output/progress.hpp"
#include "app/studies/chosen_study.hpp"
#include "app/studies/find_study.hpp"
#include "fit/better/prove_contenders.hpp"
#include "fit/better/results.hpp"
#include "fit/better/round_contenders.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/support/parallel.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/recomputed_rows.hpp"
#include "reports/findings/baseline.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/utf8.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/studies/gallery.hpp"
#include "reports/studies/study_comparison.hpp"
#include "reports/studies/study_figure.hpp"
#include "reports/studies/study_report.hpp"

/// The command `better`, and `explain`, `run` and `check` of a study.
namespace shadefit {
namespace {

std::string console_text(const StudyComparison& comparison, const Terminal& terminal) {
  return for_terminal(target_of(comparison)) + "\n" +
         write_console(study_comparison_table(comparison), Precision::report, terminal) +
         joined(comparison.left_out, "",
                [](const std::string& fit) { return "Left out: " + for_terminal(fit) + "\n"; });
}

/// What to use, and the command that emits it: that of the call, with `emit` in place of `better`.
std::string advice_of(const StudyComparison& comparison, bool is_one_of_several, const FitOptions& options) {
  std::vector<std::string> words = options.words;
  words.front() = "emit";
  for (const auto& [constant, value] : comparison.study.given)
    if (is_one_of_several) words.insert(words.end(), {"--given", constant + "=" + value});
  words.insert(words.end(), {"--better", "--lang", "glsl"});
  const std::string advice = advice_text(comparison, shell_text(words));
  if (options.terminal.width == 0) return advice;
  std::string lines;
  std::istringstream stream(advice);
  for (std::string line; std::getline(stream, line);)
    lines += fmt::format("{}\n", fmt::join(folded(line, options.terminal.width), "\n"));
  return lines;
}

/// One line for each fit that did not converge.
std::string failed_lines(const std::vector<StudyComparison>& comparisons) {
  std::string lines;
  for (const StudyComparison& comparison : comparisons) {
    for (const std::string& line : comparison.left_out)
      lines += fmt::format("shadefit: {}: {}\n", for_terminal(target_of(comparison)), for_terminal(line));
  }
  return lines;
}

}  // namespace

std::string recomputed_text(const StudyFile& file, const Checkpoint& checkpoint) {
  if (!file.recompute) return "";
  const MeasuredRows& rows = *file.study.rows;
  const RecomputedRows result =
      recompute_rows(combinations(file.study, file.given).front(), *file.recompute, checkpoint);
  if (result.wrong.empty())
    return fmt::format("{} of {} rows of {} recomputed: {}\n", result.drawn, rows.value.size(),
                       for_terminal(rows.file), *file.recompute);
  const WrongRow& first = result.wrong.front();
  throw CheckFailed(fmt::format("line {} of '{}' has {}, where {} is {}: {} of {} recomputed rows {}",
                                line_of_row(rows, first.row), rows.file.unescaped(), to_text(first.value),
                                *file.recompute, to_text(first.recomputed), result.wrong.size(), result.drawn,
                                result.wrong.size() == 1 ? "differs" : "differ"));
}

std::vector<StudyComparison> comparisons_of(const StudyFile& file, const Watched& work, Judged judged) {
  const std::vector<Study> studies = combinations(file.study, file.given);
  std::size_t steps = 0;
  for (const Study& study : studies) steps += steps_to_compare(file, study);
  // `stepping` counts its calls: one copy counts those of all studies.
  const Checkpoint next = stepping(work, "compare", steps);
  std::vector<StudyComparison> comparisons;
  for (const Study& study : studies)
    comparisons.push_back(compare_study(file, study, work.checkpoint, next, judged));
  return comparisons;
}

Outcome better_command(const FitOptions& options, const Watched& work) {
  const StudyFile file = compared_study(options, work.checkpoint);
  if (options.plot) require_picture(*options.plot);
  // The report and `explain` judge the numbers of the catalogue.
  const Judged judged = is_known_id(options.id) ? Judged::no : Judged::yes;
  const auto comparisons = comparisons_of(file, work, judged);
  if (options.plot && comparisons.size() > 1)
    throw UserError(fmt::format("--plot '{}' draws one target, and these are {}: give one value by --given",
                                *options.plot, comparisons.size()));
  std::string out;
  if (options.csv) {
    out = write_csv(study_comparisons_table(comparisons), Precision::full);
  } else if (options.json) {
    out = json_text_of_each(json_array(comparisons, study_comparison_json));
  } else {
    out = joined(comparisons, "\n", [&](const StudyComparison& comparison) {
      return advice_of(comparison, comparisons.size() > 1, options) +
             console_text(comparison, options.terminal);
    });
  }
  return with_picture(
      {0, out, ""}, options, [&] { return better_study_figure(comparisons.front()); }, work.checkpoint);
}

Outcome explain_study_command(const StudyFile& file, const ExplainOptions& options, const Watched& work) {
  const auto comparisons = comparisons_of(file, work);
  if (!options.json) return {0, study_explanation(file, comparisons, options.terminal), ""};
  return {0,
          json_text({{"schema", 1},
                     {"id", file.id},
                     {"title", file.title},
                     {"targets", json_array(comparisons, study_comparison_json)}}),
          ""};
}

Outcome run_study_command(const StudyFile& file, const RunOptions& options, const Checkpoint& checkpoint) {
  if (!options.only.empty())
    throw UserError(fmt::format("--only '{}' does not go with a study", options.only.front()));
  require_writable(options.out);
  const auto comparisons = comparisons_of(file, {checkpoint, unwatched});
  std::vector<Figure> figures;
  if (!options.no_plots && comparisons.size() == 1 && file.study.over.size() == 1)
    figures.push_back(better_study_figure(comparisons.front()));
  auto [files, missing, said, failed] = draw_figures(figures, options.out, checkpoint);
  const auto pages = study_files_of(file, comparisons, figures);
  files.insert(files.end(), pages.begin(), pages.end());
  std::string out;
  for (const StudyComparison& comparison : comparisons) out += console_text(comparison, options.terminal);
  out += said + fmt::format("\nReport: {}\n",
                            printable((std::filesystem::path(options.out) / "report.md").string()));
  const std::string err = failed + failed_lines(comparisons);
  return {err.empty() ? 0 : 1, out, err,
          prepare_output(options.out, files, missing, options.force, checkpoint)};
}

Outcome gallery_command(const RunOptions& options, const Watched& work) {
  require_writable(options.out);
  const auto folders = study_folders(options.studies);
  std::vector<StudyFile> files;
  if (options.study) {
    files.push_back(named_study(*options.study, folders));
  } else {
    for (const auto& path : study_files(folders)) files.push_back(load_study(path));
  }
  std::vector<JudgedStudy> judged(files.size());
  const auto judge = [&](std::size_t place, const Checkpoint& go_on) {
    GalleryEntry entry{files[place], {}};
    entry.comparisons = comparisons_of(entry.file, {go_on, unwatched});
    for (StudyComparison& comparison : entry.comparisons) {
      prove_contenders(comparison, go_on);
      round_contenders(comparison, go_on);
    }
    judged[place] = judged_study(entry);
  };
  for_each_in_parallel(
      files.size(), judge,
      {.before_each = stepping(work, "studies", files.size()), .checkpoint = work.checkpoint});
  work.progress("");
  const std::vector<File> written = gallery_files(judged);
  const auto put = prepare_output(options.out, written, {}, options.force, work.checkpoint);
  const auto first = std::filesystem::path(options.out) / written.front().name;
  return {0, fmt::format("Pages: {}\n", printable(first.string())), "", put};
}

Outcome check_study_command(const StudyFile& file, const CheckOptions& options,
                            const Checkpoint& checkpoint) {
  const Baseline baseline = read_tables(options.baseline, {"better.csv"});
  const std::string recomputed = recomputed_text(file, checkpoint);
  std::vector<File> files = study_files_of(file, comparisons_of(file, {checkpoint, unwatched}), {});
  std::erase_if(files, [](const File& made) { return made.name != "better.csv"; });
  return check_outcome(compare_files(baseline, files), options, recomputed);
}

}  // namespace shadefit
