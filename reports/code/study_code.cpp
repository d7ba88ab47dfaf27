#include "reports/code/study_code.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fit/scalars/integral.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/joined.hpp"
#include "reports/rows/statement.hpp"

namespace shadefit {
namespace {

/// What is known of the largest error of a study's code: proven where there is a proof, else sampled.
std::string error_line(const StudySubject& subject, const ReadStudy& read, const Checkpoint& checkpoint) {
  const Study& study = subject.study;
  const std::string ranges = joined(read.axes, ", ", [](const StudyAxis& axis) {
    return fmt::format("{} in [{}, {}]", axis.variable, axis.lower, axis.upper);
  });
  if (study.rows == nullptr && integral_depth(error_formula(read)) < 2) {
    try {
      // the fourth digit of a bound is rounded up
      const double width = std::max(1e-6, usual_study_width(study.over.size()));
      const StudyCertificate proof = certify_study(subject, width, checkpoint).certificate;
      return fmt::format("Proven: {}{} error at most {} for {}, in exact arithmetic.",
                         study.weight == "1" ? "" : "weighted ", name(study.error),
                         decimal_above(proof.upper, 4), ranges);
    } catch (const CheckFailed&) {
      // The formulas have no finite bound in intervals. Samples say what they can.
    }
  }
  std::vector<double> values;
  for (const auto& [name, text] : subject.parameters) values.push_back(constant<double>(decimal_of(text)));
  return fmt::format("Sampled: absolute error at most {:.4g} for {}, in exact arithmetic.",
                     largest_error(read, values).magnitude, ranges);
}

}  // namespace

StudyFunction study_function(const StudySubject& subject, const std::string& name, const OthersText& origin,
                             const Checkpoint& checkpoint) {
  const auto& [study, constants] = subject;
  const ReadStudy read = read_formulas(study);
  if (integral_depth(read.form) > 0)
    throw UserError(fmt::format("emit has no code for 'integral' in the form '{}'", study.form));
  StudyFunction code{{name, {}, with_constants(read.form, constants)}, {}};
  for (const StudyAxis& axis : read.axes) code.function.arguments.push_back(axis.variable);
  code.facts = {
      study.form + " for " + OthersText(study.rows ? "the rows of " + study.rows->file : study.target),
      constants_text(constants) + " (" + origin + ")", error_line(subject, read, checkpoint)};
  return code;
}

std::string code_below(const std::vector<OthersText>& head, const std::vector<OthersText>& facts,
                       const ShaderFunction& function, Language language, ShaderPrecision precision) {
  std::vector<OthersText> comment = head;
  comment.insert(comment.end(), facts.begin(), facts.end());
  if (precision == ShaderPrecision::float16)
    comment.emplace_back("The rounding of constants and operations to half comes on top.");
  return shader_code({&function, 1}, language, precision, comment);
}

std::string function_name(std::string_view id) {
  std::string text(id);
  std::ranges::replace(text, '-', '_');
  return text;
}

std::string constants_text(const Constants& constants) {
  return joined(constants, ", ", [](const auto& constant) {
    return fmt::format("{} = {}", constant.first, decimal_of(constant.second));
  });
}

}  // namespace shadefit
