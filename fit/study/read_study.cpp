#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "fit/formula/parse_formula.hpp"
#include "fit/formula/shader_calls.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/study.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

ReadFormula read(const std::string& option, const std::string& text, const FormulaNames& names) {
  try {
    return read_formula(text, names);
  } catch (const std::invalid_argument& error) {
    throw UserError(option + ": " + error.what());
  }
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The value of a formula without variables.
double number_of(const std::string& option, const std::string& text) {
  const Symbolic formula = read(option, text, {}).formula;
  const auto value = static_cast<double>(in_50_digits(formula));
  if (!std::isfinite(value)) throw UserError(option + " '" + text + "' is not a finite number");
  return value;
}

void require_name(const std::string& option, const std::string& name) {
  const auto begins = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; };
  const bool is_name =
      !name.empty() && begins(name.front()) &&
      std::all_of(name.begin(), name.end(), [&](char c) { return begins(c) || ('0' <= c && c <= '9'); });
  if (!is_name)
    throw UserError(option + " '" + name + "' is not a name: a letter, then letters, digits and underscores");
  constexpr const char* constants[] = {"pi", "ln2", "PI", "M_PI", "integral"};
  const bool is_taken =
      !argument_counts(name).empty() || std::any_of(std::begin(constants), std::end(constants),
                                                    [&](const char* constant) { return name == constant; });
  if (is_taken) throw UserError(option + " '" + name + "' is already a function or a number");
}

/// A table defines the names `value` and `sigma`.
void require_free_of_rows(const std::string& option, const std::string& name, const Study& study) {
  if (!study.rows) return;
  const bool is_sigma = name == "sigma" && !study.rows->sigma.empty();
  if (name == "value" || is_sigma)
    throw UserError(option + " '" + name + "': a --table has this name for its " +
                    (is_sigma ? "standard deviations" : "measured values"));
}

StudyAxis axis_of_column(const StudyRange& range, const std::vector<double>& values) {
  if (!range.lower.empty())
    throw UserError("--over '" + range.variable + "=" + range.lower + ":" + range.upper +
                    "' has a range: with --table the rows give the values, so write --over " +
                    range.variable);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {range.variable, *least, *most, Symbolic::number("1")};
}

StudyAxis axis_of_range(const StudyRange& range) {
  if (range.lower.empty())
    throw UserError("--over '" + range.variable + "' needs a range: for example --over " + range.variable +
                    "=0:1");
  const std::string text = range.variable + "=" + range.lower + ":" + range.upper;
  const double lower = number_of("--over", range.lower), upper = number_of("--over", range.upper);
  if (!(lower < upper)) throw UserError("--over '" + text + "' is empty: it must rise");
  const Symbolic density =
      read("--over '" + text + "'", range.density, {.variables = {range.variable}}).formula;
  return {range.variable, lower, upper, density};
}

std::vector<StudyAxis> axes_of(const Study& study) {
  if (study.over.empty())
    throw UserError(study.rows ? "--form needs --over, a column of the table: for example --over x"
                               : "--form needs --over, a variable and its range: for example --over x=0:1");
  if (study.over.size() > most_axes)
    throw UserError("--over '" + study.over[most_axes].variable + "': a study has at most three variables");
  std::vector<StudyAxis> axes;
  std::set<std::string> seen;
  for (const StudyRange& range : study.over) {
    require_name("--over", range.variable);
    require_free_of_rows("--over", range.variable, study);
    if (!seen.insert(range.variable).second)
      throw UserError("--over '" + range.variable + "' is given a second time");
    axes.push_back(study.rows ? axis_of_column(range, study.rows->places.at(axes.size()))
                              : axis_of_range(range));
  }
  return axes;
}

/// Definitions in the order given; each may use those before it, the variables and the given constants.
std::map<std::string, Definition, std::less<>> definitions_of(const Study& study,
                                                              const std::vector<std::string>& variables) {
  std::map<std::string, Definition, std::less<>> result;
  for (const auto& [name, value] : study.given) {
    require_name("--given", name);
    require_free_of_rows("--given", name, study);
    if (contains(variables, name)) throw UserError("--given '" + name + "' is a variable of --over");
    result.emplace(name, Definition{{}, read("--given '" + name + "'", value, {}).formula});
  }
  for (const StudyDefinition& definition : study.definitions) {
    require_name("--let", definition.name);
    require_free_of_rows("--let", definition.name, study);
    if (contains(variables, definition.name) || result.contains(definition.name))
      throw UserError("--let '" + definition.name + "' names something else already");
    FormulaNames names{.variables = variables, .definitions = result, .takes_integrals = true};
    for (const std::string& argument : definition.arguments) {
      require_name("--let '" + definition.name + "', argument", argument);
      names.definitions.erase(argument);
      if (!contains(names.variables, argument)) names.variables.push_back(argument);
    }
    const Symbolic formula = read("--let '" + definition.name + "'", definition.formula, names).formula;
    result.emplace(definition.name, Definition{definition.arguments, formula});
  }
  return result;
}

std::vector<std::string> variables_of(const std::vector<StudyAxis>& axes) {
  std::vector<std::string> variables;
  for (const StudyAxis& axis : axes) variables.push_back(axis.variable);
  return variables;
}

/// What the formulas of a study may name.
FormulaNames names_of(const Study& study, const std::vector<std::string>& variables) {
  return {.variables = variables, .definitions = definitions_of(study, variables), .takes_integrals = true};
}

void require_enough_rows(const ReadStudy& study) {
  const std::size_t rows = study.rows->value.size(), parameters = study.parameters.size();
  if (rows < parameters)
    throw UserError("'" + study.rows->file + "' has fewer rows than --form has parameters: " +
                    std::to_string(rows) + " and " + std::to_string(parameters));
}

}  // namespace

std::string density_of(const std::string& text, const std::string& variable) {
  if (text == "cosine") return "1";
  if (text == "angle") return "1/sqrt((1 - " + variable + ") (1 + " + variable + "))";
  return text == "cosine-weighted" ? variable : text;
}

std::vector<std::string> node_variables(const ReadStudy& study) {
  std::vector<std::string> names;
  for (const StudyAxis& axis : study.axes) names.push_back(axis.variable);
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
  const std::vector<StudyAxis> axes = axes_of(study);
  const std::vector<std::string> variables = variables_of(axes);
  const FormulaNames names = names_of(study, variables);
  const Symbolic target =
      study.rows ? Symbolic::variable("value") : read("--target", study.target, names).formula;
  FormulaNames of_form = names;
  of_form.takes_parameters = true;
  const ReadFormula form = read("--form", study.form, of_form);
  for (const std::string& parameter : form.parameters)
    require_free_of_rows("--form: its parameter", parameter, study);
  const Symbolic one = Symbolic::number("1");
  ReadStudy result{axes,        target,     form.formula,         one, form.parameters,
                   study.error, study.rows, study.has_only_starts};
  FormulaNames of_weight = names;
  of_weight.variables = node_variables(result);
  result.weight = read("--weight", study.weight, of_weight).formula;

  for (const Held& held : study.held) {
    if (!contains(result.parameters, held.parameter))
      throw UserError("--fix '" + held.parameter + "': the form has no such parameter");
    std::erase(result.parameters, held.parameter);
    result.form = evaluate<Symbolic>(result.form, [&](const std::string& name) {
      return name == held.parameter ? Symbolic::number(to_text(held.value)) : Symbolic::variable(name);
    });
  }
  for (const Held& start : study.starts) {
    if (!contains(result.parameters, start.parameter))
      throw UserError("--start '" + start.parameter + "': the form has no such free parameter");
  }
  if (result.parameters.size() > most_study_parameters)
    throw UserError("--form has " + std::to_string(result.parameters.size()) + " parameters: at most 16");
  const bool has_variable = std::any_of(variables.begin(), variables.end(), [&](const std::string& name) {
    return free_variables(target).contains(name) || free_variables(result.form).contains(name);
  });
  if (study.rows) {
    require_enough_rows(result);
  } else if (!has_variable) {
    throw UserError("--over: neither target nor form contains a variable");
  }
  return result;
}

Symbolic read_recompute(const Study& study, const std::string& formula) {
  return read("recompute", formula, names_of(study, variables_of(axes_of(study)))).formula;
}

ReadStudy read_study(const Study& study) {
  ReadStudy result = read_formulas(study);
  if (result.parameters.empty()) throw UserError("--form '" + study.form + "' has no parameter to fit");
  return result;
}

}  // namespace shadefit
