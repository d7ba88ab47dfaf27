#include "reports/code/study_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fit/scalars/integral.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/joined.hpp"

namespace shadefit {
namespace {

/// What is known of the largest error of a curve: a proven bound, or a sampled one.
struct KnownError {
  bool is_proven;
  double magnitude;
};

KnownError known_error(const StudySubject& subject, const Checkpoint& checkpoint) {
  const Study& study = subject.study;
  const ReadStudy read = read_formulas(study);
  std::vector<double> values;
  for (const auto& [name, text] : subject.parameters) values.push_back(constant<double>(decimal_of(text)));
  const auto sampled = [&] { return largest_error(read, values).magnitude; };
  if (study.rows || integral_depth(error_formula(read)) > 1) return {false, sampled()};
  try {
    // the fourth digit of a bound is rounded up
    const double width = std::max(1e-6, usual_study_width(study.over.size()));
    return {true, certify_study(subject, width, checkpoint).certificate.upper};
  } catch (const CheckFailed&) {
    // The formulas have no finite bound in intervals. Samples say what they can, unless the error is
    // infinite.
    const double magnitude = sampled();
    if (!std::isfinite(magnitude) || pole_of(read, values)) throw;
    return {false, magnitude};
  }
}

/// ", k = 5", ", k = 3 to 15 (13 values)": the given constants of all studies.
std::string given_of(const std::vector<Study>& studies) {
  return joined(studies.front().given, "", [&](const auto& given) {
    const auto& [name, first] = given;
    const std::string& last = studies.back().given.at(name);
    return ", " + name + " = " + first +
           (last == first ? "" : fmt::format(" to {} ({} values)", last, studies.size()));
  });
}

/// What is known of the largest error of the code, for all studies with these constants.
std::string error_line(const std::vector<Study>& studies, const Constants& constants,
                       const Checkpoint& checkpoint) {
  bool is_proven = true;
  double most = 0;
  for (const Study& study : studies) {
    const auto [is_bound, magnitude] = known_error({study, constants}, checkpoint);
    is_proven = is_proven && is_bound;
    most = std::max(most, magnitude);
  }
  const Study& study = studies.front();
  const std::string places =
      joined(read_formulas(study).axes, ", ",
             [](const StudyAxis& axis) {
               return fmt::format("{} in [{}, {}]", axis.variable, axis.lower, axis.upper);
             }) +
      given_of(studies);
  if (!is_proven)
    return fmt::format("Sampled: absolute error at most {:.4g} for {}, in exact arithmetic.", most, places);
  return fmt::format("Proven: {}{} error at most {} for {}, in exact arithmetic.",
                     study.weight == "1" ? "" : "weighted ", name(study.error), decimal_above(most, 4),
                     places);
}

/// A formula with the values of constants; other variables stay.
Symbolic with_constants(const Symbolic& formula, const Constants& constants) {
  return evaluate<Symbolic>(formula, [&](const std::string& variable) {
    for (const auto& [name, text] : constants) {
      if (name == variable) return Symbolic::number(decimal_of(text));
    }
    return Symbolic::variable(variable);
  });
}

/// The form with its constants. A given constant of several values is an argument.
ShaderFunction function_of(const std::string& name, Study study, const Constants& constants,
                           bool is_for_several) {
  if (is_for_several) {
    for (const auto& [given, value] : study.given) study.over.push_back({given, "0", "1"});
    study.given.clear();
  }
  const ReadStudy read = read_formulas(study);
  if (integral_depth(read.form) > 0)
    throw UserError(fmt::format("emit has no code for 'integral' in the form '{}'", study.form));
  return {name, variables_of(read.axes), with_constants(read.form, constants)};
}

}  // namespace

StudyFunction study_function(const std::vector<Study>& studies, const Constants& constants,
                             const std::string& name, const OthersText& origin,
                             const Checkpoint& checkpoint) {
  const Study& study = studies.front();
  return {function_of(name, study, constants, studies.size() > 1),
          {study.form + " for " + OthersText(study.rows ? "the rows of " + study.rows->file : study.target),
           constants_text(constants) + " (" + origin + ")", error_line(studies, constants, checkpoint)}};
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

std::string decimal_of(const std::string& text) {
  const auto exact = parse_hex(text);
  return exact ? fmt::format("{}", *exact) : text;
}

std::string constants_text(const Constants& constants) {
  return joined(constants, ", ", [](const auto& constant) {
    return fmt::format("{} = {}", constant.first, decimal_of(constant.second));
  });
}

}  // namespace shadefit
