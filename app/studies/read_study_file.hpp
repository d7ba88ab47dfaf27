#pragma once

#include <cstdint>
#include <string>

#include "fit/study/study_file.hpp"

namespace shadefit {

/// The most bytes of a study: pages of text.
inline constexpr std::uintmax_t most_study_bytes = 1U << 20;

/// Reads a study in TOML (docs/studies.md has its keys). Numbers are texts or formulas, so that no digit is
/// lost. Throws UserError with one line that names the file, the line and the rule: for a text that is not
/// TOML, an unknown key, a missing one, a value of another type, another schema, and a published set of a
/// form that is not there.
StudyFile read_study_file(const std::string& text, const std::string& name);

}  // namespace shadefit
