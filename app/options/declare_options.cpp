#include "app/options/declare_options.hpp"

#include <fmt/format.h>

#include <array>

#include "app/options/option_values.hpp"
#include "approx/records/optical_constants.hpp"
#include "fit/bounds/study_certificate.hpp"
#include "fit/catalogue/study_parts.hpp"

namespace shadefit {
namespace {

constexpr const char* form_help =
    "a family, a published constant or a study (see 'shadefit list'), or a file of a study, NAME.toml";

void add_json(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "print JSON, every number to its last bit");
}

/// The other format of a table; it excludes the `--json` before it.
CLI::Option* add_csv(CLI::App& command, bool& csv, const std::string& columns) {
  return command.add_flag("--csv", csv, "print CSV" + columns)->excludes("--json");
}

void add_plot(CLI::App& command, FitOptions& options, const std::string& what) {
  add_value(command, "--plot", options.plot, parse_text, "FILE", what + "; FILE ends with .svg");
  add_force(command, options.force);
}

void add_exponent(CLI::App& command, FitOptions& fit, const std::string& by_default) {
  add_value(command, "--exponent", fit.exponents, parse_exponents, "K|A:B:STEP",
            "the exponents of a lobe, separated by commas (default: " + by_default + ")");
}

void add_domain(CLI::App& command, FitOptions& fit) {
  add_value(command, "--domain", fit.metric.domain, parse_domain, "A:B",
            "the range of the variable, if it is a cosine, for example cos(60deg):1; 0deg:60deg is the same "
            "(default of a built-in family: 0:1)");
}

/// Adds the options for the error and its domain, for `fit`, `certify` and `emit`.
void add_metric(CLI::App& command, FitOptions& fit) {
  add_choice(command, "--measure", fit.metric.measure, by_name(measures),
             "how the range of a cosine is weighted: evenly in the cosine, in the angle, or by the cosine");
  add_choice(
      command, "--error", fit.metric.error, by_name(std::array{Error::absolute, Error::relative}),
      "absolute, or relative: divided by the target of a lobe or of a --form, or by F = f0 + (1-f0) target "
      "of a Fresnel form");
  // At 1 nothing would be left to fit.
  const auto parse_f0 = parse_finite_with([](double f0) { return 0 <= f0 && f0 < 1; },
                                          "is not a reflectance at normal incidence: it must be in [0, 1)");
  add_value(
      command, "--f0", fit.f0, parse_f0, "F0",
      fmt::format("reflectance at normal incidence, for the relative error of a Fresnel form (default: {})",
                  reference_f0));
  add_domain(command, fit);
}

/// Adds the options for the constraints of a fit.
void add_constraints(CLI::App& command, Metric& metric) {
  const auto parse_weight = [](const std::string& option, const std::string& text) {
    if (text.empty())
      throw UserError(fmt::format("{} '' is empty: give a formula in c, such as '1 + 4 c'", option));
    return text;
  };
  add_value(
      command, "--weight", metric.weight, parse_weight, "FORMULA",
      "multiplies the error: a formula in the cosine c, or in the variables of --over, that is nowhere negative, for "
      "example '1 + 4 c'; with --table also in value and sigma");
  Constraints& constraints = metric.constraints;
  add_values(command, "--fix", constraints.held, parse_held, "NAME=VALUE",
             "a parameter that is given, not fitted; may be repeated");
  add_values(command, "--exact-at", constraints.exact_at, parse_finite, "C",
             "an end of the range where the form equals its target; may be repeated");
  add_choice(command, "--one-sided", constraints.one_sided, by_name(std::array{Side::above, Side::below}),
             "the side of its target on which the form stays");
  add_value(command, "--at-most", constraints.at_most, parse_finite, "V",
            "the form stays at or below this value");
  add_value(command, "--at-least", constraints.at_least, parse_finite, "V",
            "the form stays at or above this value");
  add_choice(command, "--monotone", constraints.monotone, by_name(std::array{Course::falls, Course::rises}),
             "the course of the form: falls if it never rises, rises if it never falls");
}

/// The id of a form, and beside that of a study a word for one of its forms.
void add_subject(CLI::App& command, FitOptions& options) {
  command.add_option("id", options.id, form_help)->type_name("FORM");
  command
      .add_option("word", options.study.word, "of a study: the id of one of its forms (default: the first)")
      ->type_name("WORD");
}

CLI::Option* add_round(CLI::App& command, FitOptions& options) {
  return add_value(
      command, "--round", options.round, parse_number_format, "float|half|bfloat16|decimal:N",
      "the best constants in this number format; half and bfloat16: for a form of one variable that is evaluated "
      "in it");
}

/// Adds the options of a study. Named studies take them too, instead of what the file says.
void add_study(CLI::App& command, FitOptions& options) {
  add_studies(command, options.studies);
  StudyOptions& study = options.study;
  add_value(
      command, "--form", study.form, parse_text, "FORMULA",
      "a formula of your own to fit to --target, or the id of a form of the study: every name that is not a variable or a constant is a "
      "parameter");
  add_value(command, "--table", study.table, parse_text, "FILE",
            "measured rows to fit --form to, instead of a --target: values between commas or blanks, with a "
            "header; columns named as the variables of --over, value, and, if known, the standard deviation "
            "sigma; - is standard input");
  add_value(command, "--value", study.value, parse_text, "COLUMN",
            "the column of --table with the measured values (default: value)");
  add_values(
      command, "--over", study.over, parse_over, "NAME=A:B[:DENSITY]",
      "a variable of --form and its range, for example x=0:1 or t=0deg:30deg; DENSITY, a formula, says how much each "
      "place counts (default: 1); with --table only NAME; up to three times");
  const auto set_range = [&options](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      refuse_option("--range", text);
      if (text.find(':') != text.npos && text.find('=') == text.npos) {
        options.metric.domain = parse_domain("--domain", text);
        options.study.has_domain = true;
      } else {
        options.study.over.push_back(parse_over("--over", text));
      }
    }
  };
  command
      .add_option_function<std::vector<std::string>>("--range", set_range,
                                                     "another name of --over, and with A:B alone of --domain")
      ->type_name("NAME=A:B|A:B")
      ->allow_extra_args(false);
  add_values(
      command, "--given", study.given, parse_given, "NAME=LIST",
      "a constant of --form and --target: values separated by commas, or A:B:STEP above 0; one fit for each");
  add_values(command, "--let", study.definitions, parse_let, "NAME(X)=FORMULA",
             "a function or a value for the other formulas, for example 'f(x)=x^2' or 'k=3'");
  add_value(
      command, "--params", study.parameters, parse_names, "NAME,..",
      "the parameters of --form; then any other unknown name is an error (default: every name that is not a "
      "variable or a constant)");
  add_values(
      command, "--bounds", study.bounds, parse_bounds, "NAME=A:B",
      "the values that a parameter of --form may have, for example a=0:1, or to one side a=0: and a=:1; "
      "may be repeated");
  add_values(command, "--start", study.starts, parse_held, "NAME=VALUE",
             "one more start of the search: a value of a parameter of --form");
}

/// --target, that also takes a formula, and the options for the surface of a Fresnel form.
void add_target_or_formula(CLI::App& command, FitOptions& options) {
  const auto parse_target = [&options](const std::string&, const std::string& text) {
    if (text == "schlick") options.target = Surface::Formula::schlick;
    if (text == "exact") options.target = Surface::Formula::exact;
    return text;
  };
  add_value(command, "--target", options.study.target, parse_target, "schlick|exact|FORMULA",
            "the function to approximate. A Fresnel form: schlick is (1-c)^5, exact is the reflectance of a "
            "surface (default: schlick). With --form: your formula");
  add_value(command, "--ior", options.ior, parse_finite, "N",
            fmt::format(
                "index of refraction n of the surface, which also sets f0 (default with --target exact: {})",
                glass.ior));
  add_value(command, "--extinction", options.extinction, parse_finite, "K",
            "extinction k of a conductor with index n + i k (default: 0)");
}

/// What `fit`, `certify` and `emit` fit, and how. Generated files list the options in this order.
void add_fit(CLI::App& command, FitOptions& options) {
  add_subject(command, options);
  add_exponent(command, options, "of a published number its own, of a family the usual range");
  add_metric(command, options);
  add_target_or_formula(command, options);
  add_choice(
      command, "--norm", options.metric.norm, by_name(std::array{Norm::least_squares, Norm::minimax}),
      "what the fit minimises: the mean square of the error, or its maximum; a study has a norm of its own");
  add_study(command, options);
  add_constraints(command, options.metric);
}

void add_parameters(CLI::App& command, std::optional<Constants>& parameters) {
  add_value(command, "--parameters", parameters, parse_parameters, "NAME=VALUE,..",
            "the constants (default: the published ones, else fitted ones)");
}

}  // namespace

void add_force(CLI::App& command, bool& force) {
  command.add_flag("--force", force, "replace a file that shadefit did not write");
}

void add_out(CLI::App& command, std::string& out) {
  add_value(command, "--out", out, parse_text, "DIR", "the directory to write")->default_str(out);
}

void add_studies(CLI::App& command, StudyFolders& folders) {
  add_values(command, "--studies", folders, parse_text, "DIR",
             "also find studies in this folder; may be repeated");
}

void add_finding_format(CLI::App& command, findings::FindingFormat& format) {
  add_choice(command, "--format", format, by_name(findings::finding_formats),
             "the format of the output: text is for people, sarif, github and markdown for code hosts");
}

void declare_list(CLI::App& list, ListOptions& options) {
  list.add_option("id", options.id, "only what has this text in its id; or a study's file, NAME.toml")
      ->type_name("ID");
  add_choice(
      list, "--verdict", options.verdict, by_name(all_verdicts),
      "only the claims with this verdict (computes them all). confirmed: all digits are right; rounding: the last "
      "one is off by one; other-objective: another fit has the digits; conditional: true in a part of the "
      "range; refuted: none of these");
  add_studies(list, options.studies);
  add_json(list, options.json);
  add_csv(list, options.csv, "");
}

void declare_run(CLI::App& run, RunOptions& options) {
  add_out(run, options.out);
  run.add_option("study", options.study, "a study or its file, NAME.toml (default: all that is built in)")
      ->type_name("STUDY");
  add_studies(run, options.studies);
  add_values(run, "--only", options.only, parse_text, "ID", "only these families, normalisations and claims")
      ->allow_extra_args();
  add_force(run, options.force);
  run.add_flag("--no-plots", options.no_plots, "write no plots, and no data or scripts for them");
  run.add_flag("--html", options.html, "write pages of the study, or of all studies, for a browser")
      ->excludes("--only");
}

void declare_fit(CLI::App& fit, FitOptions& options) {
  add_fit(fit, options);
  add_json(fit, options.json);
  auto* csv = add_csv(fit, options.csv, "");
  auto* latex =
      fit.add_flag("--latex", options.latex, "print a LaTeX tabular")->excludes("--json")->excludes(csv);
  const std::array extras{
      fit.add_flag("--certify", options.certify, "also prove bounds of the largest error"),
      add_round(fit, options),
      add_value(
          fit, "--evaluate", options.evaluate, parse_evaluated_format, "half|float",
          "constants for a form that is evaluated in this format, in the order that emit prints; the best that "
          "steps from the fit find"),
      fit.add_flag(
          "--sensitivity", options.sensitivity,
          "also how many digits of each constant matter, and the fit under other measures and domains")};
  for (CLI::Option* extra : extras) extra->excludes(csv)->excludes(latex);
  extras[2]->excludes(extras[1]);  // both name the arithmetic
  add_plot(fit, options, "also draw the fit and its error");
}

void declare_better(CLI::App& better, FitOptions& options) {
  add_subject(better, options);
  add_exponent(
      better, options,
      "the lowest and the highest for which the number was published, or of the family's usual range");
  add_target_or_formula(better, options);
  add_study(better, options);
  add_domain(better, options);
  add_json(better, options.json);
  add_csv(better, options.csv, ": the columns of better.csv");
  add_plot(better, options, "also draw the errors of the published curves and of the best one");
}

void declare_certify(CLI::App& certify, CertifyOptions& options) {
  add_fit(certify, options.fit);
  add_parameters(certify, options.parameters);
  add_value(certify, "--width", options.width, parse_relative_width, "W",
            fmt::format(
                "the greatest distance of the two bounds, as a share of the largest error (default: {}; "
                "for a --form in two variables {}, in three {})",
                to_text(usual_study_width(1)), to_text(usual_study_width(2)), to_text(usual_study_width(3))));
  add_value(certify, "--out", options.out, parse_text, "FILE",
            "write the certificate, for 'shadefit verify'");
  add_force(certify, options.fit.force);
  add_json(certify, options.fit.json);
}

void declare_verify(CLI::App& verify, VerifyOptions& options) {
  verify.add_option("file", options.file, "a file of 'shadefit certify --out'")
      ->required()
      ->type_name("FILE");
}

void declare_emit(CLI::App& emit, EmitOptions& options) {
  add_choice(emit, "--lang", options.language, by_name(languages), "the language of the code");
  add_fit(emit, options.fit);
  add_parameters(emit, options.parameters);
  add_round(emit, options.fit);
  emit.add_flag(
      "--better", options.better,
      "the set of a study that 'shadefit better' names: the smallest error at no more cost that keeps "
      "the properties of the published set");
  add_choice(emit, "--precision", options.precision, by_name(shader_precisions), "the type of the numbers");
  add_value(emit, "--name", options.name, parse_text, "NAME", "of the function (default: the family's)");
  add_value(emit, "--out", options.out, parse_text, "FILE", "write a file instead of printing the code");
  add_force(emit, options.fit.force);
  add_values(emit, "--check", options.check, parse_text, "FILE",
             "exit 1 unless shadefit would generate these files again as they are")
      ->allow_extra_args();
}

void declare_explain(CLI::App& explain, ExplainOptions& options) {
  explain
      .add_option("id", options.id,
                  "a claim (see 'shadefit list'), a constant of one, a family, a study, or a number")
      ->required()
      ->type_name("CLAIM");
  add_studies(explain, options.studies);
  add_json(explain, options.json);
}

void declare_cite(CLI::App& cite, CiteOptions& options) {
  cite.add_option("id", options.id,
                  "also the sources of this claim, constant, family or study (see 'shadefit list')")
      ->type_name("CITED");
  add_studies(cite, options.studies);
}

void declare_stress(CLI::App& stress, StressOptions& options) {
  add_out(stress, options.out);
  add_force(stress, options.force);
}

void declare_check(CLI::App& check, CheckOptions& options) {
  check.add_option("study", options.study, "a study or its file, NAME.toml (default: all that is built in)")
      ->type_name("STUDY");
  add_studies(check, options.studies);
  add_value(check, "--baseline", options.baseline, parse_text, "DIR", "the directory of those tables")
      ->default_str(options.baseline);
  check.add_flag(
      "--all", options.all,
      "also compare the slow tables, those of stress and bench, and the rows of the tables of studies");
  add_value(check, "--fail-above", options.fail_above, parse_percentage, "P%",
            "allow a number to change by this share of its old value (default: each change fails)");
  add_finding_format(check, options.format);
}

}  // namespace shadefit
