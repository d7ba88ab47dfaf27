#pragma once

#include <string>
#include <vector>

#include "fit/catalogue/study_file.hpp"
#include "fit/catalogue/toml_reader.hpp"

namespace shadefit {

/// Keys that a file has besides those of a study.
struct MoreKeys {
  std::vector<std::string> of_file = {}, of_target = {}, of_form = {}, of_published = {};
};

/// A whole file of TOML, its texts in one line each.
toml::table parse_in_lines(const TomlReader& reader, const std::string& text);

/// The study of such a file.
StudyFile study_of_toml(const TomlReader& reader, const toml::table& whole, const MoreKeys& more = {});

}  // namespace shadefit
