#pragma once

#include <filesystem>
#include <vector>

#include "app/studies/find_study.hpp"
#include "lint/lint_text.hpp"

namespace shadefit::lint {

/// The sets that the command looks for: of all studies, of the exact constants and of the built-in families.
inline KnownConstants all_known() {
  const std::filesystem::path studies = SHADEFIT_SOURCE_DIR "/studies";
  std::vector<StudyFile> files;
  for (const auto& path : study_files({studies, studies / "exact"})) files.push_back(load_study(path));
  return KnownConstants(known_sets(files));
}

}  // namespace shadefit::lint
