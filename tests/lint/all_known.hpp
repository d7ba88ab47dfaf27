#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/studies/find_study.hpp"
#include "lint/lint_text.hpp"
#include "lint/lint_tree.hpp"

namespace shadefit::lint {

/// The sets that the command looks for: of all studies, of the exact constants and of the built-in families.
inline KnownConstants all_known() {
  const std::filesystem::path studies = SHADEFIT_SOURCE_DIR "/studies";
  std::vector<StudyFile> files;
  for (const auto& path : study_files({studies, studies / "exact"})) files.push_back(load_study(path));
  return KnownConstants(known_sets(files));
}

inline const KnownConstants& known_here() {
  static const KnownConstants known = all_known();
  return known;
}

inline std::vector<LintedSite> lint_text(const std::string& text,
                                         SourceLanguage language = SourceLanguage::glsl,
                                         const EffectLimits& limits = {}) {
  return lint_source("a", text, language, known_here(), limits);
}

using Words = std::vector<std::string>;

/// "ID GRADE" of each site of a text.
inline Words graded(const std::string& text, SourceLanguage language = SourceLanguage::glsl) {
  Words words;
  for (const LintedSite& site : lint_text(text, language))
    words.push_back(site.id + " " + std::string(name(site.grade)));
  return words;
}

/// "ID GRADE" of the only site of a text.
inline std::string verdict_in(const std::string& text, SourceLanguage language = SourceLanguage::glsl) {
  const Words all = graded(text, language);
  return all.size() == 1 ? all.front() : "none";
}

/// The grade of the only site of a text.
inline std::string grade_in(const std::string& text) {
  const std::string verdict = verdict_in(text);
  return verdict.substr(verdict.find(' ') + 1);  // npos + 1 is 0
}

}  // namespace shadefit::lint
