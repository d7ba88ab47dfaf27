#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fit/quadrature/metric.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/steps/sums.hpp"
#include "fit/study/measured_rows.hpp"
#include "fit/support/user_error.hpp"

/// A fit of one's own: a form to a target, over one to three variables. The form is a formula; the target is
/// a formula too, or the rows of a measurement.
namespace shadefit {

/// A variable, its range, and how its values are weighted.
struct StudyRange {
  std::string variable;
  std::string lower,
      upper;  ///< formulas of numbers and given constants; both empty where rows give the values
  std::string density = "1";  ///< a formula in the variable
};

/// A named formula; without arguments a name for an expression.
struct StudyDefinition {
  std::string name;
  std::vector<std::string> arguments;
  std::string formula;
};

/// The values that a parameter may have: lower < upper, infinite where there is no bound.
struct ParameterBounds {
  std::string parameter;
  double lower, upper;
  auto operator<=>(const ParameterBounds&) const = default;
};

/// "a=0:1", "a=0:", "a=:1", as the option has them.
std::string to_text(const ParameterBounds& bounds);

/// Formulas of y = 1 - c in place of those of c: the digits of a curve that is steep next to c = 1 survive in
/// y. Both are empty where there are none.
struct NearPeak {
  std::string target = {}, form = {};
};

/// What is asked for, as its user wrote it.
struct Study {
  std::string target, form;
  std::vector<StudyRange> over;
  std::vector<StudyDefinition> definitions = {};
  std::map<std::string, std::string> given = {};  ///< held constants: formulas of numbers
  std::vector<Held> held = {};                    ///< parameters with given values
  std::vector<Held> starts = {};                  ///< values from which a descent starts too
  std::vector<ParameterBounds> bounds = {};       ///< a name that the form lacks has no effect
  std::vector<std::string> parameters = {};  ///< those of the form; empty: every name that is nothing else
  /// Then no other descent starts, and a fit of rows has no statistics. This tells whether `starts` are near
  /// an optimum.
  bool has_only_starts = false;
  std::string weight = "1";  ///< the factor of the error, a formula in the variables
  /// form - target by a formula that does not cancel; empty: their difference.
  std::string residual = {};
  NearPeak near_peak = {};  ///< of a variable c and a given exponent k (fit/catalogue/near_peak.hpp)
  /// Points from which its form is fitted: a search starts only if they do not agree on an answer.
  std::vector<std::vector<Held>> known_starts = {};
  Error error = Error::absolute;
  std::shared_ptr<const MeasuredRows> rows = nullptr;  ///< the target, if it is not a formula
  /// The cuts of its only variable (`StudyAxis`), if somebody has looked for them.
  std::optional<std::vector<double>> cuts = std::nullopt;
};

/// The zeros of hinges that were looked for: a fit asks for those of one form again and again.
class KnownZeros;

/// A range whose ends are numbers: with rows the least and the largest value.
struct StudyAxis {
  std::string variable;
  double lower, upper;
  Symbolic density;
  std::vector<double> cuts = {};  ///< places that cut panels: more happens there than the nodes of a rule see
  std::shared_ptr<KnownZeros> known_zeros = nullptr;  ///< of all copies of a study that was read
};

/// A study whose formulas have been read. Given constants are inserted.
struct ReadStudy {
  std::vector<StudyAxis> axes;
  Symbolic target, form, weight;
  std::vector<std::string> parameters;  ///< of the form, in the order in which they first appear; free ones
  Error error;
  std::shared_ptr<const MeasuredRows> rows = nullptr;  ///< then the target is the variable `value`
  bool has_only_starts = false;
  std::vector<ParameterBounds> bounds = {};         ///< of free parameters, at most one each
  std::optional<Symbolic> residual = std::nullopt;  ///< form - target, if it is not their difference
};

/// form - target of a study.
Symbolic difference_of(const ReadStudy& study);

/// Refuses a residual that is not form - target, by 50 digits at places and parameters without a relation.
/// Throws UserError. Who writes one asks this once.
void require_residual(const ReadStudy& study);

/// The study with a parameter held at a value.
ReadStudy with_held(ReadStudy study, const std::string& parameter, double value);

/// The variables of axes.
std::vector<std::string> variables_of(const std::vector<StudyAxis>& axes);

/// "x = 0.5, y = 1": a place, to its shortest round trip.
std::string to_text(const std::vector<StudyAxis>& axes, const std::vector<double>& place);

/// The variables of the formulas of a study at a node: those of the axes, and with rows `value` and, where
/// the rows have it, `sigma`. Everything else is a parameter.
std::vector<std::string> node_variables(const ReadStudy& study);

/// The inputs of its formulas as tapes: those variables, then the parameters.
std::vector<std::string> formula_inputs(const ReadStudy& study);

/// The most variables and the most free parameters of a study.
inline constexpr std::size_t most_axes = 3;
inline constexpr std::size_t most_study_parameters = most_fitted;

/// The most definitions of a study, arguments of one, and forms.
inline constexpr std::size_t most_definitions = 1000, most_arguments = 16, most_forms = 100;

/// The value of a formula of numbers, such as an end of a range: "cos(pi/6)", "30deg". Empty for any other
/// text, and where the value is not finite.
std::optional<double> value_of_numbers(const std::string& text);

/// The density that a word names: `cosine`, `angle` and `cosine-weighted` for a cosine in [0, 1]. Any other
/// text is a formula already.
std::string density_of(const std::string& text, const std::string& variable);

/// A part of a study, by the option that gives it, such as --over. Several of one kind have names: the
/// variable, the constant or the definition.
struct StudyPart {
  std::string option, name = {};
};

/// What is wrong with a part of a study. `what()` is the option and the rule; who has read the study from a
/// file says where the part stands instead.
struct StudyFault : UserError {
  StudyFault(const StudyPart& of, const std::string& broken_rule)
      : UserError(of.option + broken_rule), part(of), rule(broken_rule) {}

  StudyPart part;
  std::string rule;  ///< what follows the option: " 'x=1:0' is empty: it must rise"
};

/// A formula of numbers and of the given constants of a study, such as an end of its range. Throws StudyFault
/// where it names something else.
Symbolic numbers_in(const Study& study, const StudyPart& part, const std::string& text);

/// Its value. Throws StudyFault where that is not finite.
double number_in(const Study& study, const StudyPart& part, const std::string& text);

/// Reads the formulas of a study. Throws UserError with one line that names the option, its value and the
/// rule.
ReadStudy read_study(const Study& study);

/// The same for a form that is not fitted: it need not have a free parameter.
ReadStudy read_formulas(const Study& study);

/// The formula from which the rows of a study were computed: in its variables, with its given constants and
/// definitions.
Symbolic read_recompute(const Study& study, const std::string& formula);

}  // namespace shadefit
