#include "reports/studies/study_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "fit/verdicts/study_objectives.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/joined.hpp"
#include "reports/studies/study_comparison.hpp"
#include "reports/studies/study_rows.hpp"

namespace shadefit {
namespace {

/// The contender of a set in a comparison, or null.
const StudyContender* contender_of(const StudyComparison& comparison, const PublishedSet& set) {
  for (const StudyContender& contender : comparison.contenders) {
    if (contender.published == &set) return &contender;
  }
  return nullptr;
}

std::string_view words_of(StatedError error) {
  constexpr std::array<std::string_view, stated_errors.size()> words{
      "Largest error", "Largest relative error", "Mean error", "Mean relative error",
      "Rms error",     "Mean square error"};
  return words.at(static_cast<std::size_t>(error));
}

/// What came of the fits that were tried.
std::string trials_text(const StudyJudgement& judgement) {
  if (judgement.objective.empty()) return fmt::format("Fits tried: {}. None converged", judgement.tried);
  if (judgement.chance == 0)
    return fmt::format("Fits tried: {}. The fit has no error: its constants are those of the target",
                       judgement.tried);
  if (judgement.verdict == Verdict::refuted)
    return fmt::format(
        "Fits tried: {}. The nearest is {}: its worst constant is off by {} {} of the last digit",
        judgement.tried, judgement.objective, judgement.units_off,
        judgement.units_off == 1 ? "unit" : "units");
  // A power of ten: its exact value is an estimate.
  std::string text = fmt::format("Fits tried: {}. Expected to have these digits by chance: at most {:g}",
                                 judgement.tried, std::pow(10.0, std::ceil(std::log10(judgement.chance))));
  if (!judgement.also.empty())
    text += fmt::format(". Also with these digits: {}", fmt::join(judgement.also, "; "));
  return text;
}

/// "0.018 (as a linear grey 4.6 codes of 8-bit sRGB, 37 ulps of half)": the largest of each, sampled.
std::string effect_text(const StudyComparison& comparison, const StudyContender& contender) {
  const Effect& effect = contender.effect;
  std::string codes;
  if (contender.is_shown)
    codes = fmt::format("{}{} codes of 8{}, ", comparison.is_encoded ? "" : "as a linear grey ",
                        in_digits(codes_of(comparison, contender), 3),
                        comparison.is_encoded ? " bits" : "-bit sRGB");
  return fmt::format("{} ({}{} ulps of half)", in_digits(effect.absolute.magnitude, 3), codes,
                     in_digits(effect.half_ulps, 3));
}

/// "0.0090127 to 0.0090128, by 143 boxes".
std::string proof_text(const ProvenError& proof) {
  return fmt::format("{:.6g} to {:.6g}, by {} {}", proof.lower, proof.upper, proof.boxes,
                     proof.boxes == 1 ? "box" : "boxes");
}

void append_better(const StudyComparison& comparison, const StudyContender& published,
                   std::vector<OthersText>& lines) {
  const StudyContender* best = better_at_the_same_cost(comparison, published);
  const StudyContender* least = least_error_at_the_same_cost(comparison, published);
  const auto words = [&](const StudyContender& contender) {
    return contender.form + ", " + contender.origin + ": " + effect_text(comparison, contender);
  };
  const auto append = [&](const std::string& what, const StudyContender& contender) {
    lines.push_back(what + words(contender));
    if (contender.proof) lines.push_back("Its largest error, proven: " + proof_text(*contender.proof));
    if (!contender.unproven.empty()) lines.push_back("Its largest error, sampled: " + contender.unproven);
    lines.push_back("Its properties: " + text_with_proofs(contender.properties));
  };
  if (best != nullptr) append("Better at no more instructions, with these properties: ", *best);
  if (best == nullptr)
    lines.push_back(fmt::format("No fit here is better at no more instructions{}",
                                least == nullptr ? "" : " and keeps these properties"));
  const StudyContender* all = better_with_all_properties(comparison, published);
  if (all != nullptr && all != best) append("With all properties of the target: ", *all);
  if (least != nullptr && least != best)
    lines.push_back("The smallest error: " + words(*least) +
                    ". This fit loses: " + to_text(lost_properties(published.properties, least->properties)));
}

}  // namespace

OthersText study_title(const StudyFile& file) {
  return file.title.empty() ? OthersText(file.id) : file.id + ": " + file.title;
}

std::vector<OthersText> study_statement(const StudyFile& file) {
  std::vector<OthersText> lines;
  if (!file.about.empty()) lines.push_back(file.about);
  lines.push_back("Target: " +
                  (file.study.rows ? "the rows of " + file.study.rows->file : OthersText(file.study.target)));
  for (const StudyDefinition& definition : file.study.definitions)
    lines.push_back("where " + definition_text(definition));
  for (const StudyRange& range : file.study.over)
    if (!file.study.rows)
      lines.push_back(fmt::format("{} in [{}, {}]{}", range.variable, range.lower, range.upper,
                                  range.density == "1" ? "" : ", density " + range.density));
  lines.push_back("The study asks for: " + objective_of(file.study, file.norm, file.constraints).words);
  if (file.has_weight) lines.push_back("Weight of the error: " + file.study.weight);
  for (const StudyForm& form : file.forms) lines.push_back(fmt::format("Form {}: {}", form.id, form.formula));
  return lines;
}

std::vector<OthersText> published_lines(const PublishedSet& set,
                                        const std::vector<StudyComparison>& comparisons) {
  std::vector<OthersText> lines{set.form + ": " + equations(set.values) + " (" + set.source + ")"};
  for (const StudyComparison& comparison : comparisons) {
    const StudyContender* contender = contender_of(comparison, set);
    if (contender == nullptr) continue;
    if (contender->judgement) {
      lines.push_back(fmt::format("Verdict: {}", verdict_in_words(*contender->judgement)));
      lines.push_back(trials_text(*contender->judgement));
    } else {
      lines.emplace_back("No verdict: a parameter that only moves a jump has no fit");
    }
    lines.push_back("Properties of the target that it keeps: " + text_with_proofs(contender->properties));
    lines.push_back("Largest difference from the target: " + effect_text(comparison, *contender));
    if (contender->proof) lines.push_back("Largest error, proven: " + proof_text(*contender->proof));
    if (!contender->unproven.empty()) lines.push_back("Largest error, sampled: " + contender->unproven);
    append_better(comparison, *contender, lines);
    for (const JudgedError& judged : contender->claims)
      lines.push_back(fmt::format("{}{}: stated {}, computed {}: {}", words_of(judged.claim.error),
                                  ranges_text(judged.claim.over), judged.claim.printed,
                                  in_digits(judged.computed, 4), name(judged.verdict)));
  }
  OthersText places;
  for (const OthersText& place : set.where) places += (places.empty() ? "" : "; ") + place;
  if (!places.empty()) lines.push_back("Used in: " + places);
  for (const MistypedCopy& copy : set.variants)
    lines.push_back("Mistyped: " + equations(copy.values) + " in " + copy.seen);
  return lines;
}

std::string study_explanation(const StudyFile& file, const std::vector<StudyComparison>& comparisons,
                              const Terminal& terminal) {
  std::string out = for_terminal(study_title(file)) + "\n";
  const auto add = [&](const std::vector<OthersText>& lines) {
    constexpr std::size_t indent = 2;
    for (const OthersText& of_others : lines) {
      const std::string line = for_terminal(of_others);
      out += terminal.width == 0
                 ? line + "\n"
                 : fmt::format("{}\n", fmt::join(folded(line, terminal.width - indent), "\n  "));
    }
  };
  add(study_statement(file));
  for (const PublishedSet& set : file.published) {
    out += "\n";
    add(published_lines(set, comparisons));
  }
  return with_coloured_verdicts(out, terminal);
}

std::vector<File> study_files_of(const StudyFile& file, const std::vector<StudyComparison>& comparisons,
                                 const std::vector<Figure>& figures) {
  std::string page = fmt::format("# Study {}\n\n", for_markdown(study_title(file)));
  for (const OthersText& line : study_statement(file)) page += for_markdown(line) + "  \n";
  for (const PublishedSet& set : file.published) {
    page += "\n";
    for (const OthersText& line : published_lines(set, comparisons)) page += for_markdown(line) + "  \n";
  }
  for (const StudyComparison& comparison : comparisons) {
    page += fmt::format("\n## {}\n\n{}", for_markdown(target_of(comparison)),
                        markdown_block(study_comparison_table(comparison)));
    for (const std::string& fit : comparison.left_out) page += "Left out: " + for_markdown(fit) + "\n";
  }
  page += fmt::format(
      "\n{} The largest errors are sampled. `beats` names published rows with a larger error at no fewer instructions.\n",
      proven_in_words);
  for (const Figure& figure : figures)
    page += fmt::format("\n![{}](plots/{}.svg)\n", for_markdown(figure.caption), figure.name);
  return {{"report.md", page},
          {"better.csv", write_csv(study_comparisons_table(comparisons), Precision::report)}};
}

}  // namespace shadefit
