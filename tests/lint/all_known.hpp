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

/// "ID GRADE" of the only site of a text.
inline std::string verdict_in(const std::string& text, SourceLanguage language) {
  static const KnownConstants known = all_known();
  const auto sites = lint_source("a", text, language, known, {});
  return sites.size() == 1 ? sites.front().id + " " + std::string(name(sites.front().grade)) : "none";
}

}  // namespace shadefit::lint
