#pragma once

#include <string>
#include <vector>

#include "fit/catalogue/study_file.hpp"
#include "fit/catalogue/toml_reader.hpp"

namespace shadefit {

/// Reads a study in TOML (docs/studies.md has its keys). Numbers are texts or formulas, so that no digit is
/// lost. Throws UserError with one line that names the file, the line and the rule: for a text that is not
/// TOML, an unknown key, a missing one, a value of another type, another schema, and a published set of a
/// form that is not there. The name is that of messages, and may be shown.
StudyFile read_study_file(const std::string& text, const std::string& name);

/// Keys that a file has besides those of a study.
struct MoreKeys {
  std::vector<std::string> of_file = {}, of_target = {}, of_form = {}, of_published = {};
};

/// A whole file of TOML, its texts in one line each.
toml::table parse_in_lines(const TomlReader& reader, const std::string& text);

/// The study of such a file.
StudyFile study_of_toml(const TomlReader& reader, const toml::table& whole, const MoreKeys& more = {});

}  // namespace shadefit
