#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fit/study/study.hpp"

/// The parts of a study as a line: of the options of the command and of the keys of a file, which `option`
/// names in messages.
namespace shadefit {

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
