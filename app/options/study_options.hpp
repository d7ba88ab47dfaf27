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

/// "NAME=A:B" or "NAME=A:B:DENSITY", or "NAME" for a column of a table. A and B are formulas of numbers;
/// DENSITY is a formula in the variable, or cosine, angle or cosine-weighted for a variable in [0, 1].
StudyRange parse_over(const std::string& option, const std::string& text);

/// "NAME=LIST": numbers, formulas of numbers and sweeps "3:15:1", by commas.
std::pair<std::string, std::vector<std::string>> parse_given(const std::string& option,
                                                             const std::string& text);

/// "NAME = FORMULA" or "NAME(A, B) = FORMULA".
StudyDefinition parse_let(const std::string& option, const std::string& text);

/// "NAME=A:B", "NAME=A:" or "NAME=:B": A and B are formulas of numbers, A < B.
ParameterBounds parse_bounds(const std::string& option, const std::string& text);

/// "a,b": names by commas.
std::vector<std::string> parse_names(const std::string& option, const std::string& text);

}  // namespace shadefit
