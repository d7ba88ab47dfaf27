#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <iterator>
#include <new>
#include <sstream>
#include <system_error>
#include <utility>

#include "app/bench_options.hpp"
#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/scene_options.hpp"
#include "fit/run/results.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

Outcome usage_error(const std::string& message) {
  return {2, "", fmt::format("shadefit: {} (see 'shadefit --help')\n", one_line(message))};
}

/// CLI11 takes whatever follows an option for its value, the next option too.
void require_values(const std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    const std::string option = arguments[i].substr(0, arguments[i].find('='));
    const bool is_open = option == arguments[i] || option.size() + 1 == arguments[i].size();
    constexpr std::array take_text{"--out",       "--baseline", "--measure",    "--target",     "--only",
                                   "--verdict",   "--norm",     "--error",      "--weight",     "--fix",
                                   "--one-sided", "--round",    "--width",      "--exhaustive", "--constants",
                                   "--shard",     "--state",    "--merge",      "--range",      "--lang",
                                   "--precision", "--name",     "--parameters", "--check",      "--tolerance",
                                   "--lights",    "--alpha",    "--gloss",      "--maps",       "--codes"};
    const bool takes_text = std::find(take_text.begin(), take_text.end(), option) != take_text.end();
    if (takes_text && is_open && arguments[i + 1].starts_with('-')) {
      throw UserError(fmt::format("{} '{}' looks like an option: name a value (a path may begin with './')",
                                  option, arguments[i + 1]));
    }
  }
}

/// CLI11 lists what it did not expect from the back; we name the first of it.
std::string first_unexpected(const std::string& message, const std::vector<std::string>& arguments) {
  std::istringstream words(message.substr(message.rfind(": ") + 1));
  const std::vector<std::string> unexpected{std::istream_iterator<std::string>(words), {}};
  const auto first =
      std::find_first_of(arguments.begin(), arguments.end(), unexpected.begin(), unexpected.end());
  return first == arguments.end() ? message : fmt::format("unexpected argument '{}'", *first);
}

/// CLI11 calls a mistyped command an unexpected argument; we name the nearest one.
void require_known_command(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front() == "--help" || arguments.front() == "-h" ||
      arguments.front() == "--version")
    return;
  if (arguments.front().starts_with('-'))
    throw UserError(fmt::format("unexpected argument '{}' before a command", arguments.front()));
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({})) known.push_back(command->get_name());
  require_known(arguments.front(), known, "command");
}

void add_force(CLI::App& command, bool& force) {
  command.add_flag("--force", force, "replace files that shadefit did not write, or that were changed since");
}

/// What the arguments set, and what came of it.
struct Call {
  const Checkpoint& checkpoint;
  const Progress& progress;
  ListOptions list = {};
  RunOptions run = {};
  bool no_plots = false;
  FitOptions fit = {};
  BetterOptions better = {};
  CertifyOptions certify = {};
  VerifyOptions verify = {};
  EmitOptions emit = {};
  SceneOptions scene = {};
  ExplainOptions explain = {};
  StressOptions stress = {};
  CheckOptions check = {};
  BenchOptions bench = {};
  Outcome outcome = {};
};

void add_list(CLI::App& app, Call& call) {
  auto* list = app.add_subcommand("list", "every constant and claim: id, printed value, source");
  auto* list_json = list->add_flag("--json", call.list.json, "print JSON");
  list->add_flag("--latex", call.list.latex, "print a LaTeX tabular")->excludes(list_json);
  list->add_option("--verdict", call.list.verdict,
                   "only what is confirmed, rounding, other-objective, conditional or refuted; computes it")
      ->type_name("NAME");
  list->callback([&call] { call.outcome = list_command(call.list, call.checkpoint); });
}

void add_run(CLI::App& app, Call& call) {
  auto* run = app.add_subcommand("run", "fit and check everything, write report.md and the tables");
  run->add_option("--out", call.run.out, "directory to write")->capture_default_str()->type_name("DIR");
  run->add_option("--only", call.run.only,
                  "only the families, normalisations and claims of these ids, one or more")
      ->type_name("ID");
  add_force(*run, call.run.force);
  run->add_flag("--no-plots", call.no_plots, "neither plots nor their data and scripts");
  run->callback([&call] {
    call.run.plots = !call.no_plots;
    call.outcome = run_command(call.run, call.checkpoint);
  });
}

/// What the options of `fit` ask of the error and of the answer.
void add_objective(CLI::App& fit, FitOptions& options) {
  fit.add_option("--norm", options.norm, "least-squares, or minimax: the largest error is least")
      ->capture_default_str()
      ->type_name("NAME");
  fit.add_option("--weight", options.weight,
                 "multiplies the error: a formula in c, not negative, as '1 + 4 c'")
      ->type_name("FORMULA");
  fit.add_option("--fix", options.fix, "a parameter that is given, not fitted; may be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  fit.add_option("--exact-at", options.exact_at,
                 "an end of the domain where the form has to be its target; minimax only, may be repeated")
      ->type_name("C")
      ->allow_extra_args(false);
  fit.add_option("--one-sided", options.one_sided,
                 "above or below: the side of its target that the form has to keep to; minimax only")
      ->type_name("NAME");
  fit.add_option("--at-most", options.at_most, "what the form may not exceed; minimax only")->type_name("V");
  fit.add_option("--at-least", options.at_least, "what the form may not fall below; minimax only")
      ->type_name("V");
}

/// A surface that a Fresnel form is held against.
void add_surface(CLI::App& command, FitOptions& fit) {
  command
      .add_option(
          "--ior", fit.ior,
          "index of refraction of a surface, whose F the errors are then of; with exact by default 1.5")
      ->type_name("N");
  command.add_option("--extinction", fit.extinction, "extinction k of a conductor n + i k; default: 0")
      ->type_name("K");
}

/// What `fit`, `certify` and `emit` are told: which form, and what it is fitted to. The option of the form.
CLI::Option* add_fit_options(CLI::App& command, FitOptions& fit) {
  auto* id =
      command.add_option("id", fit.id, "a family or a published constant, see 'shadefit list'")->required();
  command.add_option("--exponent", fit.exponent, "K or A:B:STEP, by commas; default: the record's own")
      ->type_name("K");
  command.add_option("--measure", fit.measure, "cosine, angle or cosine-weighted")
      ->capture_default_str()
      ->type_name("NAME");
  command.add_option("--domain", fit.domain, "A:B, the cosines to fit over; default: 0:1")->type_name("A:B");
  command
      .add_option("--target", fit.target,
                  "of a Fresnel family: schlick, or exact for the reflectance of a surface")
      ->capture_default_str()
      ->type_name("NAME");
  add_surface(command, fit);
  command
      .add_option("--error", fit.error,
                  "absolute, or relative to a lobe's target or to F = f0 + (1-f0) f of a Fresnel form")
      ->capture_default_str()
      ->type_name("NAME");
  command.add_option("--f0", fit.f0, "of a Fresnel form's relative error; default: 0.04")->type_name("F0");
  return id;
}

/// The options that print tables for others than a terminal.
struct TableFormats {
  CLI::Option *csv, *latex;
};

TableFormats add_formats(CLI::App& command, FitOptions& options, const std::string& file) {
  auto* json = command.add_flag("--json", options.json, "print JSON, every number to its last bit");
  auto* csv =
      command
          .add_flag("--csv", options.csv, "print the columns of " + file + ", every number to its last bit")
          ->excludes(json);
  auto* latex = command.add_flag("--latex", options.latex, "print the table as a LaTeX tabular")
                    ->excludes(json)
                    ->excludes(csv);
  return {csv, latex};
}

void add_fit(CLI::App& app, Call& call) {
  auto* fit = app.add_subcommand("fit", "one fit, or a sweep of exponents, printed");
  add_fit_options(*fit, call.fit);
  add_objective(*fit, call.fit);
  const auto [csv, latex] = add_formats(*fit, call.fit, "fits.csv");
  fit->add_flag("--certify", call.fit.certify,
                "prove bounds of the largest error, the stationary point and the curve")
      ->excludes(csv)
      ->excludes(latex);
  fit->add_option("--round", call.fit.round,
                  "the best constants of a format, evaluated in it: float, half, bfloat16 or decimal:N")
      ->type_name("FORMAT")
      ->excludes(csv)
      ->excludes(latex);
  fit->add_flag("--sensitivity", call.fit.sensitivity,
                "how many digits of each constant matter, and the same fit under other measures and domains")
      ->excludes(csv)
      ->excludes(latex);
  fit->callback([&call] { call.outcome = fit_command(call.fit, call.checkpoint, call.progress); });
}

void add_better(CLI::App& app, Call& call) {
  auto* better = app.add_subcommand(
      "better", "what is published for a target and what else there is, with proven errors and costs");
  FitOptions& options = call.better.fit;
  better->add_option("id", options.id, "a family or a published constant, see 'shadefit list'")->required();
  better
      ->add_option("--exponent", options.exponent,
                   "K or A:B:STEP, by commas; default: the lowest and the highest exponent that the number "
                   "was published for, of a family those of its usual range")
      ->type_name("K");
  better
      ->add_option("--target", call.better.target,
                   "of a Fresnel family: schlick, or exact for the reflectance of a surface; default: "
                   "Schlick's weight, exact glass (1.5) and exact gold (0.43, 2.455) in turn")
      ->type_name("NAME");
  add_surface(*better, options);
  better->add_option("--domain", options.domain, "A:B, the cosines that count; default: 0:1")
      ->type_name("A:B");
  add_formats(*better, options, "better.csv");
  better->callback([&call] { call.outcome = better_command(call.better, call.checkpoint); });
}

void add_certify(CLI::App& app, Call& call) {
  auto* certify = app.add_subcommand("certify", "bounds of a form's largest error, proven by intervals");
  add_fit_options(*certify, call.certify.fit);
  certify
      ->add_option("--parameters", call.certify.parameters,
                   "NAME=VALUE, by commas; default: the published values, else the fitted")
      ->type_name("LIST");
  certify->add_option("--width", call.certify.width, "of the bounds, relative to the error")
      ->capture_default_str()
      ->type_name("W");
  certify->add_option("--out", call.certify.out, "write the certificate, for 'shadefit verify'")
      ->type_name("FILE");
  add_force(*certify, call.certify.force);
  certify->add_flag("--json", call.certify.fit.json, "print JSON");
  certify->callback(
      [&call] { call.outcome = certify_command(call.certify, call.checkpoint, call.progress); });
}

void add_verify(CLI::App& app, Call& call) {
  auto* verify = app.add_subcommand("verify", "check a certificate again, on its own boxes");
  verify->add_option("file", call.verify.file, "what 'shadefit certify --out' wrote")->required();
  verify->callback([&call] { call.outcome = verify_command(call.verify, call.checkpoint, call.progress); });
}

void add_emit(CLI::App& app, Call& call) {
  EmitOptions& options = call.emit;
  auto* emit = app.add_subcommand("emit", "a form as code, generated from its formula");
  // With --check the file says all of it.
  add_fit_options(*emit, options.fit)->required(false);
  emit->add_option("--norm", options.fit.norm, "of fitted constants: least-squares or minimax")
      ->capture_default_str()
      ->type_name("NAME");
  emit->add_option("--parameters", options.parameters,
                   "NAME=VALUE, by commas; default: the published values, else the fitted")
      ->type_name("LIST");
  emit->add_option("--lang", options.language, "glsl, hlsl, c, cpp, wgsl or msl")->type_name("NAME");
  emit->add_option("--precision", options.precision, "float or half")
      ->capture_default_str()
      ->type_name("NAME");
  emit->add_option("--name", options.name, "of the function; default: the family's")->type_name("NAME");
  emit->add_option("--out", options.out, "write the file instead of printing it")->type_name("FILE");
  add_force(*emit, options.force);
  emit->add_option("--check", options.check, "exit 1 unless FILE, once generated, would be the same now")
      ->type_name("FILE");
  emit->callback([&call] { call.outcome = emit_command(call.emit, call.checkpoint, call.progress); });
}

void add_scene(CLI::App& app, Call& call) {
  CLI::App* scene = add_scene_options(app, call.scene);
  add_force(*scene, call.scene.force);
  scene->callback([&call] { call.outcome = scene_command(call.scene, call.checkpoint, call.progress); });
}

void add_explain(CLI::App& app, Call& call) {
  auto* explain =
      app.add_subcommand("explain", "one claim: what is said, by whom, what is computed, and why");
  explain->add_option("id", call.explain.id, "a claim, see 'shadefit list'")->required();
  explain->callback([&call] { call.outcome = explain_command(call.explain); });
}

void add_stress(CLI::App& app, Call& call) {
  auto* stress = app.add_subcommand(
      "stress", "forms and fits where they are hardest: naive against robust in half, float and double");
  stress->add_option("--out", call.stress.out, "directory to write stress.csv and stress-fits.csv to")
      ->capture_default_str()
      ->type_name("DIR");
  add_force(*stress, call.stress.force);
  stress->callback([&call] { call.outcome = stress_command(call.stress, call.checkpoint, call.progress); });
}

void add_check(CLI::App& app, Call& call) {
  auto* check =
      app.add_subcommand("check", "recompute and compare with the committed tables; writes nothing");
  check->add_option("--baseline", call.check.baseline, "directory of the tables")
      ->capture_default_str()
      ->type_name("DIR");
  check->add_flag("--all", call.check.all, "the slow tables too, those of stress and bench");
  check->callback([&call] { call.outcome = check_command(call.check, call.checkpoint, call.progress); });
}

void add_bench(CLI::App& app, Call& call) {
  CLI::App* bench = add_bench_options(app, call.bench);
  add_force(*bench, call.bench.force);
  bench->callback([&call] {
    call.outcome = bench_command(call.bench, SHADEFIT_VERSION, call.checkpoint, call.progress);
  });
}

Outcome parse_and_run(const std::vector<std::string>& arguments, const Checkpoint& checkpoint,
                      const Progress& progress) {
  CLI::App app{"shadefit refits, checks and reports the approximation constants of real-time shading.",
               "shadefit"};
  app.set_version_flag("--version", "shadefit " SHADEFIT_VERSION);
  app.require_subcommand(1);
  Call call{.checkpoint = checkpoint, .progress = progress};
  add_list(app, call);
  add_run(app, call);
  add_fit(app, call);
  add_better(app, call);
  add_certify(app, call);
  add_verify(app, call);
  add_emit(app, call);
  add_scene(app, call);
  add_explain(app, call);
  add_bench(app, call);
  add_stress(app, call);
  add_check(app, call);

  try {
    require_known_command(app, arguments);
    require_values(arguments);
    std::vector<std::string> reversed(arguments.rbegin(),
                                      arguments.rend());  // CLI11 takes them from the back
    app.parse(reversed);
  } catch (const CLI::CallForHelp&) {
    const auto chosen = app.get_subcommands();
    return {0, chosen.empty() ? app.help() : chosen.front()->help("shadefit"), ""};
  } catch (const CLI::CallForVersion& version) {
    return {0, std::string(version.what()) + "\n", ""};
  } catch (const CLI::ExtrasError& error) {
    return usage_error(first_unexpected(error.what(), arguments));
  } catch (const CLI::ParseError& error) {
    return usage_error(error.what());
  }
  return call.outcome;
}

/// A call as a shell takes it, for a report.
std::string call_text(const std::vector<std::string>& arguments) {
  std::string text = "shadefit";
  for (const std::string& argument : arguments) {
    text += " '";
    for (const char c : argument) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += "'";
  }
  return one_line(text);
}

/// What no rule foresaw. An error of the file system is the user's to mend: a name that is too long, links
/// that lead in a circle, a folder that may not be entered. Memory and threads are the machine's.
Outcome unforeseen(const std::exception& error, const std::vector<std::string>& arguments) {
  const auto failed = [](int exit_code, const std::string& line) {
    return Outcome{exit_code, "", fmt::format("shadefit: {}\n", one_line(line))};
  };
  if (const auto* of_files = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
    return failed(2,
                  fmt::format("cannot use '{}': {}", of_files->path1().string(), of_files->code().message()));
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return failed(1, "out of memory");
  if (const auto* of_threads = dynamic_cast<const std::system_error*>(&error))
    return failed(1, fmt::format("cannot start a thread: {}", of_threads->code().message()));
  return {1, "",
          fmt::format("shadefit: internal error: {}; please report it with the call: {}\n",
                      one_line(error.what()), call_text(arguments))};
}

}  // namespace

Outcome prepare_command_line(const std::vector<std::string>& arguments, const Checkpoint& checkpoint,
                             const Progress& progress) {
  try {
    const Watched work = watch(checkpoint, progress, arguments.empty() ? "" : arguments.front());
    return parse_and_run(arguments, work.checkpoint, work.progress);
  } catch (const UserError& error) {
    return {2, "", fmt::format("shadefit: {}\n", one_line(error.what()))};
  } catch (const CheckFailed& error) {
    return {1, "", fmt::format("shadefit: {}\n", one_line(error.what()))};
  } catch (const Interrupted& interrupted) {
    return {128 + interrupted.signal, "", "shadefit: interrupted, nothing was written\n"};
  } catch (const std::exception& error) {
    return unforeseen(error, arguments);
  }
}

Outcome put_files(Outcome outcome) {
  const auto put = std::exchange(outcome.put, {});
  try {
    if (put) put();
  } catch (const UserError& error) {
    outcome.exit_code = 2;
    outcome.err += fmt::format("shadefit: {}\n", one_line(error.what()));
  } catch (const Interrupted& interrupted) {
    outcome.exit_code = 128 + interrupted.signal;
    outcome.err += "shadefit: interrupted before all was written\n";
  }
  return outcome;
}

Outcome run_command_line(const std::vector<std::string>& arguments, const Checkpoint& checkpoint,
                         const Progress& progress) {
  return put_files(prepare_command_line(arguments, checkpoint, progress));
}

}  // namespace shadefit
