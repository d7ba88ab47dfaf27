#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fit/study/study.hpp"

/// The options of `fit` that state a fit of one's own.
namespace shadefit {

struct StudyOptions {
  std::optional<std::string> form = {};  ///< empty: the command is about a built-in family
  std::string target = {};
  std::optional<std::string> word = {};  ///< the id of a form, beside that of its study
  std::string table = {};                ///< a file of rows, instead of a target
  std::string value = "value";           ///< the column of the measured values
  std::vector<StudyRange> over = {};
  bool has_domain = false;                                                   ///< by --range A:B
  std::vector<std::pair<std::string, std::vector<std::string>>> given = {};  ///< each with its values
  std::vector<StudyDefinition> definitions = {};
  std::vector<Held> starts = {};
  std::vector<ParameterBounds> bounds = {};
  std::vector<std::string> parameters = {};  ///< empty: every name that is nothing else
};

}  // namespace shadefit
