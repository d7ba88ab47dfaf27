#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include "fit/formula/definition.hpp"
#include "fit/formula/formula_text.hpp"
#include "fit/formula/parse_formula.hpp"
#include "fit/formula/shader_calls.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/study.hpp"
#include "fit/study/study_edges.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The label is what stands between the option and the fault: the name of a definition.
ReadFormula read(const StudyPart& part, const std::string& text, const FormulaNames& names,
                 const std::string& label = "") {
  try {
    return read_formula(text, names);
  } catch (const std::invalid_argument& error) {
    throw StudyFault(part, label + ": " + error.what());
  }
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string quoted(const std::string& text) {
  return " '" + text + "'";
}

/// What a formula of numbers may name: degrees too.
FormulaNames names_of_numbers() {
  const Symbolic degree = Symbolic::constant("pi") / Symbolic::number("180");
  return {.variables = {}, .definitions = {{"deg", Definition{{}, degree}}}};
}

/// The value of a formula without variables.
double value_of(const StudyPart& part, const std::string& text, const Symbolic& formula) {
  const auto value = static_cast<double>(in_50_digits(formula));
  if (!std::isfinite(value)) throw StudyFault(part, quoted(text) + " is not a finite number");
  return value;
}

void require_name(const StudyPart& part, const std::string& name, const std::string& label = "") {
  const auto begins = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; };
  const bool is_name =
      !name.empty() && begins(name.front()) &&
      std::all_of(name.begin(), name.end(), [&](char c) { return begins(c) || ('0' <= c && c <= '9'); });
  if (!is_name)
    throw StudyFault(part,
                     label + quoted(name) + " is not a name: a letter, then letters, digits and underscores");
  if (!argument_counts(name).empty() || named_constant(name) || name == "integral")
    throw StudyFault(part, label + quoted(name) + " is already a function or a number");
}

/// A table defines the names `value` and `sigma`.
void require_free_of_rows(const StudyPart& part, const std::string& name, const Study& study,
                          const std::string& label = "") {
  if (!study.rows) return;
  const bool is_sigma = name == "sigma" && !study.rows->sigma.empty();
  if (name == "value" || is_sigma)
    throw StudyFault(part, label + quoted(name) + ": a table has this name for its " +
                               (is_sigma ? "standard deviations" : "measured values"));
}

StudyAxis axis_of_column(const StudyRange& range, const std::vector<double>& values) {
  if (!range.lower.empty())
    throw StudyFault({"--over", range.variable},
                     quoted(range.variable + "=" + range.lower + ":" + range.upper) +
                         " has a range, but the rows of the table give the values: leave it out");
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {range.variable, *least, *most, Symbolic::number("1")};
}

StudyAxis axis_of_range(const StudyRange& range, const Study& study) {
  const StudyPart part{"--over", range.variable};
  if (range.lower.empty()) throw StudyFault(part, quoted(range.variable) + " needs a range: for example 0:1");
  const std::string label = quoted(range.variable + "=" + range.lower + ":" + range.upper);
  const double lower = number_in(study, part, range.lower), upper = number_in(study, part, range.upper);
  if (!(lower < upper)) throw StudyFault(part, label + " is empty: its first end must be below its second");
  if (!std::isfinite(upper - lower)) throw StudyFault(part, label + " is wider than the largest number");
  const Symbolic density = read(part, range.density, {.variables = {range.variable}}, label).formula;
  return {range.variable, lower, upper, density};
}

std::vector<StudyAxis> axes_of(const Study& study) {
  if (study.over.empty())
    throw UserError(study.rows ? "--form needs --over, a column of the table: for example --over x"
                               : "--form needs --over, a variable and its range: for example --over x=0:1");
  if (study.over.size() > most_axes) {
    const std::string& last = study.over[most_axes].variable;
    throw StudyFault({"--over", last}, quoted(last) + ": a study has at most three variables");
  }
  std::vector<StudyAxis> axes;
  std::set<std::string> seen;
  for (const StudyRange& range : study.over) {
    const StudyPart part{"--over", range.variable};
    require_name(part, range.variable);
    require_free_of_rows(part, range.variable, study);
    if (!seen.insert(range.variable).second)
      throw StudyFault(part, quoted(range.variable) + " is given a second time");
    axes.push_back(study.rows ? axis_of_column(range, study.rows->places.at(axes.size()))
                              : axis_of_range(range, study));
    axes.back().known_zeros = std::make_shared<KnownZeros>();
  }
  return axes;
}

/// Refuses definitions that use each other in a ring, by their names: "f, g, f". The name that a ring lacks
/// where it is read is known elsewhere.
class Rings {
 public:
  explicit Rings(const std::vector<StudyDefinition>& all) {
    for (const StudyDefinition& definition : all) definitions_.emplace(definition.name, &definition);
    for (const StudyDefinition& definition : all) follow(definition.name);
  }

 private:
  /// The recursion is as deep as the definitions are many, which are limited.
  void follow(const std::string& name) {
    const auto known = definitions_.find(name);
    if (known == definitions_.end()) return;
    std::string ring;
    for (auto step = std::ranges::find(way_, name); step != way_.end(); ++step) ring += *step + ", ";
    if (!ring.empty())
      throw StudyFault({"--let", name}, quoted(name) + " is defined by itself: " + ring + name);
    if (!seen_.insert(name).second) return;
    way_.push_back(name);
    for (const std::string& used : names_in(known->second->formula))
      if (!contains(known->second->arguments, used)) follow(used);
    way_.pop_back();
  }

  std::map<std::string, const StudyDefinition*> definitions_;
  std::set<std::string> seen_;
  std::vector<std::string> way_;
};

/// Reads a definition; `names` has those before it. Restores `names`.
Definition read_definition(const StudyDefinition& definition, const Study& study, FormulaNames& names) {
  const StudyPart part{"--let", definition.name};
  const std::size_t variables = names.variables.size();
  require_name(part, definition.name);
  require_free_of_rows(part, definition.name, study);
  if (contains(names.variables, definition.name) || names.definitions.contains(definition.name))
    throw StudyFault(part, quoted(definition.name) + " names something else already");
  if (definition.arguments.size() > most_arguments)
    throw StudyFault(part, quoted(definition.name) + " has " + std::to_string(definition.arguments.size()) +
                               " arguments: at most " + std::to_string(most_arguments));
  // In a formula a variable comes before a definition of its name.
  for (const std::string& argument : definition.arguments) {
    require_name(part, argument, quoted(definition.name) + ", argument");
    if (!contains(names.variables, argument)) names.variables.push_back(argument);
  }
  const Symbolic formula = read(part, definition.formula, names, quoted(definition.name)).formula;
  names.variables.resize(variables);
  return {definition.arguments, formula};
}

/// What the formulas of a study may name: the variables, the given constants and the definitions. Each
/// definition may use those before it.
FormulaNames names_of(const Study& study, const std::vector<std::string>& variables) {
  FormulaNames names{.variables = variables, .takes_integrals = true};
  for (const auto& [name, value] : study.given) {
    const StudyPart part{"--given", name};
    require_name(part, name);
    require_free_of_rows(part, name, study);
    if (contains(variables, name)) throw StudyFault(part, quoted(name) + " is a variable already");
    names.definitions.emplace(name,
                              Definition{{}, read(part, value, names_of_numbers(), quoted(name)).formula});
  }
  if (study.definitions.size() > most_definitions)
    throw StudyFault({"--let"}, " has " + std::to_string(study.definitions.size()) +
                                    " definitions: at most " + std::to_string(most_definitions));
  for (const StudyDefinition& definition : study.definitions) {
    try {
      names.definitions.emplace(definition.name, read_definition(definition, study, names));
    } catch (const StudyFault&) {
      const Rings refused(study.definitions);
      throw;
    }
  }
  return names;
}

/// A list of parameters is that of the form.
void require_parameters(const Study& study, const FormulaNames& names) {
  std::set<std::string> seen;
  for (const std::string& parameter : study.parameters) {
    const StudyPart part{"--params"};
    require_name(part, parameter);
    require_free_of_rows(part, parameter, study);
    if (contains(names.variables, parameter) || names.definitions.contains(parameter))
      throw StudyFault(part, quoted(parameter) + " names something else already");
    if (!seen.insert(parameter).second) throw StudyFault(part, quoted(parameter) + " is given a second time");
  }
}

/// The form with its parameters; those of a list, if there is one.
ReadFormula read_form(const Study& study, FormulaNames names) {
  require_parameters(study, names);
  names.takes_parameters = true;
  names.parameters = study.parameters;
  const ReadFormula form = read({"--form"}, study.form, names);
  for (const std::string& parameter : form.parameters)
    require_free_of_rows({"--form"}, parameter, study, ": its parameter");
  for (const std::string& parameter : study.parameters) {
    if (!contains(form.parameters, parameter))
      throw StudyFault({"--params"}, quoted(parameter) + ": the form has no such parameter");
  }
  return form;
}

void require_enough_rows(const ReadStudy& study) {
  const std::size_t rows = study.rows->value.size(), parameters = study.parameters.size();
  if (rows < parameters)
    throw UserError("'" + study.rows->file.unescaped() + "' has fewer rows than the form has parameters: " +
                    std::to_string(rows) + " and " + std::to_string(parameters));
}

}  // namespace

void require_residual(const ReadStudy& study) {
  constexpr int places = 16;
  int compared = 0;
  for (int i = 0; i < places; ++i) {
    // Multiples of irrational numbers, without their whole parts, are far from each other.
    const auto share = [i](std::size_t j) {
      const double x = (i + 0.5) * std::sqrt(static_cast<double>(j) + 2);
      return x - std::floor(x);
    };
    const auto at = [&](const std::string& name) -> Decimal50 {
      std::size_t j = 0;
      for (const StudyAxis& axis : study.axes) {
        if (axis.variable == name)
          return Decimal50(axis.lower) + Decimal50(share(j)) * (Decimal50(axis.upper) - axis.lower);
        ++j;
      }
      for (const std::string& parameter : study.parameters) {
        if (parameter == name) return Decimal50(share(j) - 0.5);
        ++j;
      }
      return Decimal50(1);
    };
    const Decimal50 form = in_50_digits(study.form, at), target = in_50_digits(study.target, at),
                    given = in_50_digits(difference_of(study), at);
    // The difference of two numbers of 50 digits has this much of their rounding.
    const Decimal50 rounding = Decimal50("1e-40") * (abs(form) + abs(target));
    if (!isfinite(form) || !isfinite(target)) continue;
    ++compared;
    if (!(abs(given - (form - target)) <= rounding))
      throw StudyFault({"error"}, quoted(study.axes.front().variable + " = " +
                                         to_text(static_cast<double>(at(study.axes.front().variable)))) +
                                      ": it is " + to_text(static_cast<double>(given)) +
                                      ", but form - target is " +
                                      to_text(static_cast<double>(Decimal50(form - target))));
  }
  if (compared == 0)
    throw StudyFault({"error"}, ": form and target have no finite value with which it could be compared");
}

Symbolic numbers_in(const Study& study, const StudyPart& part, const std::string& text) {
  FormulaNames names = names_of_numbers();
  for (const std::string& name : names_in(text)) {
    const auto given = study.given.find(name);
    if (given == study.given.end()) continue;
    const Symbolic value = read({"--given", name}, given->second, names_of_numbers()).formula;
    names.definitions.emplace(name, Definition{{}, value});
  }
  return read(part, text, names).formula;
}

double number_in(const Study& study, const StudyPart& part, const std::string& text) {
  return value_of(part, text, numbers_in(study, part, text));
}

std::optional<double> value_of_numbers(const std::string& text) {
  try {
    return number_in({}, {}, text);
  } catch (const UserError&) {
    return std::nullopt;
  }
}

std::string density_of(const std::string& text, const std::string& variable) {
  if (text == "cosine") return "1";
  if (text == "angle") return "1/sqrt((1 - " + variable + ") (1 + " + variable + "))";
  return text == "cosine-weighted" ? variable : text;
}

std::string to_text(const ParameterBounds& bounds) {
  const auto end = [](double value) { return std::isfinite(value) ? to_text(value) : ""; };
  return bounds.parameter + "=" + end(bounds.lower) + ":" + end(bounds.upper);
}

Symbolic difference_of(const ReadStudy& study) {
  return study.residual ? *study.residual : study.form - study.target;
}

ReadStudy with_held(ReadStudy study, const std::string& parameter, double value) {
  const auto value_of = [&](const std::string& name) {
    return name == parameter ? Symbolic::number(to_text(value)) : Symbolic::variable(name);
  };
  study.form = evaluate<Symbolic>(study.form, value_of);
  if (study.residual) study.residual = evaluate<Symbolic>(*study.residual, value_of);
  std::erase(study.parameters, parameter);
  std::erase_if(study.bounds, [&](const ParameterBounds& of) { return of.parameter == parameter; });
  return study;
}

std::vector<std::string> variables_of(const std::vector<StudyAxis>& axes) {
  std::vector<std::string> variables;
  for (const StudyAxis& axis : axes) variables.push_back(axis.variable);
  return variables;
}

std::string to_text(const std::vector<StudyAxis>& axes, const std::vector<double>& place) {
  std::string text;
  for (std::size_t i = 0; i < axes.size(); ++i)
    text += (i == 0 ? "" : ", ") + axes[i].variable + " = " + to_text(place[i]);
  return text;
}

std::vector<std::string> node_variables(const ReadStudy& study) {
  std::vector<std::string> names = variables_of(study.axes);
  if (study.rows) names.emplace_back("value");
  if (study.rows && !study.rows->sigma.empty()) names.emplace_back("sigma");
  return names;
}

std::vector<std::string> formula_inputs(const ReadStudy& study) {
  std::vector<std::string> names = node_variables(study);
  names.insert(names.end(), study.parameters.begin(), study.parameters.end());
  return names;
}

ReadStudy read_formulas(const Study& study) {
  std::vector<StudyAxis> axes = axes_of(study);
  if (study.cuts) {
    axes.front().cuts = *study.cuts;
    std::erase_if(axes.front().cuts,
                  [&](double cut) { return cut <= axes.front().lower || axes.front().upper <= cut; });
  }
  const std::vector<std::string> variables = variables_of(axes);
  const FormulaNames names = names_of(study, variables);
  const Symbolic target =
      study.rows ? Symbolic::variable("value") : read({"--target"}, study.target, names).formula;
  const ReadFormula form = read_form(study, names);
  const Symbolic one = Symbolic::number("1");
  ReadStudy result{axes,        target,     form.formula,         one, form.parameters,
                   study.error, study.rows, study.has_only_starts};
  FormulaNames of_weight = names;
  of_weight.variables = node_variables(result);
  result.weight = read({"--weight"}, study.weight, of_weight).formula;
  if (!study.residual.empty()) {
    FormulaNames of_residual = names;
    of_residual.takes_parameters = true;
    of_residual.parameters = form.parameters;
    result.residual = read({"error"}, study.residual, of_residual).formula;
  }

  for (const Held& held : study.held) {
    if (!contains(result.parameters, held.parameter))
      throw UserError("--fix '" + held.parameter + "': " +
                      (contains(form.parameters, held.parameter) ? "it is given a second time"
                                                                 : "the form has no such parameter"));
    result = with_held(std::move(result), held.parameter, held.value);
  }
  for (const ParameterBounds& bounds : study.bounds) {
    if (contains(result.parameters, bounds.parameter)) result.bounds.push_back(bounds);
  }
  for (const Held& start : study.starts) {
    if (!contains(result.parameters, start.parameter))
      throw UserError("--start '" + start.parameter + "': the form has no such free parameter");
  }
  if (result.parameters.size() > most_study_parameters)
    throw StudyFault({"--form"},
                     " has " + std::to_string(result.parameters.size()) + " parameters: at most 16");
  const bool has_variable = std::any_of(variables.begin(), variables.end(), [&](const std::string& name) {
    return free_variables(target).contains(name) || free_variables(result.form).contains(name);
  });
  if (study.rows) {
    require_enough_rows(result);
  } else if (!has_variable) {
    throw StudyFault({"--over"}, ": neither target nor form contains a variable");
  }
  return result;
}

Symbolic read_recompute(const Study& study, const std::string& formula) {
  return read({"recompute"}, formula, names_of(study, variables_of(axes_of(study)))).formula;
}

ReadStudy read_study(const Study& study) {
  ReadStudy result = read_formulas(study);
  if (result.parameters.empty())
    throw StudyFault({"--form"}, quoted(study.form) + " has no parameter to fit");
  return result;
}

}  // namespace shadefit
