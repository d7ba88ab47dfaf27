#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fit/bounds/study_certificate.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/support/others_text.hpp"
#include "reports/code/shader_code.hpp"

/// The code of a study: its form with constants, below what is known of them.
namespace shadefit {

/// A function, and lines about its numbers before they are rounded.
struct StudyFunction {
  ShaderFunction function;
  std::vector<OthersText> facts;
};

/// The form with these constants as a function of its variables. Of several studies, which differ in their
/// given constants alone, those are arguments too. The facts are the form, its target, the constants with
/// their origin, and the largest error: proven where there is a proof, else sampled. Throws UserError for a
/// form with an integral, and CheckFailed for an error that is infinite.
StudyFunction study_function(const std::vector<Study>& studies, const Constants& constants,
                             const std::string& name, const OthersText& origin,
                             const Checkpoint& checkpoint = keep_going);

/// The code of a function below a comment: these lines, the facts, and for half that rounding comes on top of
/// them. Throws UserError like `shader_code`.
std::string code_below(const std::vector<OthersText>& head, const std::vector<OthersText>& facts,
                       const ShaderFunction& function, Language language, ShaderPrecision precision);

/// The name of the function of an id: "acos_linear".
std::string function_name(std::string_view id);

/// A constant's text in decimals: of a hexadecimal double its shortest decimal, any other text as it is.
std::string decimal_of(const std::string& text);

/// "a = -5.5, b = -7"
std::string constants_text(const Constants& constants);

}  // namespace shadefit
