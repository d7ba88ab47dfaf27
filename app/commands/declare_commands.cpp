#include "app/commands/declare_commands.hpp"

#include <memory>

#include "app/commands/commands.hpp"
#include "app/lint/lint_command.hpp"
#include "app/options/declare_options.hpp"
#include "app/options/option_values.hpp"
#include "app/output/interrupt.hpp"

namespace shadefit {
namespace {

/// Declares a command. Its options live as long as the command; `declare` adds them, `run` runs it.
template <class Options, class Run>
void add_command(CLI::App& app, Call& call, const std::string& name, const std::string& help,
                 const std::string& examples, void (*declare)(CLI::App&, Options&), Run run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(name, help)->group("Commands");
  command->footer("Examples:\n" + examples);
  declare(*command, *options);
  command->allow_extras();  // the command line names the first of them
  command->callback([=, &call] {
    const auto tell = [&](auto& of) {
      if constexpr (requires { of.terminal; }) of.terminal = call.terminal;
      if constexpr (requires { of.present; }) {
        for (const CLI::Option* option : command->get_options())
          if (option->count() > 0) of.present.insert(option->get_name());
      }
      if constexpr (requires { of.words; })
        of.words = words_of(
            *command, {"file", "--lang", "--out", "--force", "--check", "--json", "--time-limit", "--plot"});
    };
    tell(*options);
    if constexpr (requires { options->fit.words; }) tell(options->fit);
    call.run = [=, &call] { return run(*options, call.work); };
  });
}

/// For all but `cite`, which searches nothing.
void add_time_limit(CLI::App& app, Call& call) {
  for (CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == "cite") continue;
    const auto limit = [&call](const std::string& text) {
      const auto parse_seconds =
          parse_finite_with([](double seconds) { return seconds > 0; }, "must be greater than 0");
      call.work.checkpoint = limited(call.work.checkpoint, parse_seconds("--time-limit", text));
    };
    command
        ->add_option_function<std::string>("--time-limit", limit, "stop, with exit code 1, after this time")
        ->type_name("SECONDS");
  }
}

}  // namespace

void declare_commands(CLI::App& app, Call& call) {
  app.get_formatter()->label("OPTIONS", "options");
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.get_formatter()->label("Positionals", "Arguments");
  app.require_subcommand(1);
  app.get_help_ptr()->description("print this help");
  app.set_version_flag("--version", "shadefit " SHADEFIT_VERSION, "print the version");
  app.add_option("--completion", "the completions of bash or zsh, or the manual page")->group("");
  const auto add = [&](const auto&... what) { add_command(app, call, what...); };
  add("list", "every constant and claim: id, printed value, source",
      "  shadefit list fresnel\n  shadefit list --verdict refuted\n", declare_list, list_command);
  add("run", "fit and check everything; write report.md, the tables and the plots",
      "  shadefit run --no-plots\n  shadefit run --only norm-phong --out phong\n"
      "  shadefit run --html --out gallery\n",
      declare_run, run_command);
  add("fit", "fit a form, at one exponent or a sweep of them, and print its constants and errors",
      "  shadefit fit fresnel-quadratic\n"
      "  shadefit fit sg-offset --exponent 5,10:50:10 --csv\n"
      "  shadefit fit fresnel-quadratic --target exact --ior 1.5 --norm minimax\n"
      "  shadefit fit fresnel-one-term --round half\n"
      "  shadefit fit sg-offset --exponent 5 --plot lobe.svg\n"
      "  shadefit fit --target 'acos(x)' --form 'sqrt(1-x) (a + b x)' --over x=0:1\n",
      declare_fit, fit_command);
  add("better", "what is published for a target and what else there is: proven errors, costs",
      "  shadefit better fresnel-one-term --target exact --ior 1.5\n  shadefit better sg-offset --exponent 5\n",
      declare_better, better_command);
  add("certify", "bounds of a form's largest error, proven by interval arithmetic",
      "  shadefit certify fresnel-quadratic\n"
      "  shadefit certify acos-linear\n"
      "  shadefit certify fresnel-quadratic --parameters a=-5.5,b=-7 --out pair.json\n"
      "  shadefit certify --target 'acos(x)' --form 'a sqrt(1-x)' --over x=0:1\n",
      declare_certify, certify_command);
  add("verify", "check a certificate again, on the intervals that it names", "  shadefit verify pair.json\n",
      declare_verify, verify_command);
  add("emit", "a form as shader code, generated from its formula",
      "  shadefit emit fresnel-quadratic --lang glsl\n"
      "  shadefit emit sg-offset-mean --lang hlsl --name lobe --out lobe.hlsl\n"
      "  shadefit emit acos-linear --better --lang wgsl\n"
      "  shadefit emit --check lobe.hlsl\n",
      declare_emit, emit_command);
  add("scene", "what the materials of a scene need, and what can be skipped",
      "  shadefit scene scene.mtl\n  shadefit scene scene.mtl --codes 0.5 --lang glsl\n", declare_scene,
      scene_command);
  add("explain", "one claim: what it says, who says it, what is computed, and why",
      "  shadefit explain sg-offset-mean\n  shadefit explain half-banding --json\n", declare_explain,
      explain_command);
  add("cite", "BibTeX of shadefit, and of the sources of a constant or a study",
      "  shadefit cite\n  shadefit cite fresnel-quadratic\n  shadefit cite agx-septic\n", declare_cite,
      cite_command);
  add("bench", "run time against error of every form, on this machine",
      "  shadefit bench --quick --only schlick --no-plots\n"
      "  shadefit bench --quick acos-linear --no-plots\n"
      "  shadefit bench --exhaustive schlick --range 0x3f000000:0x3f001000\n",
      declare_bench, bench_command);
  add("stress", "forms and fits where they are hardest: naive against robust in half, float and double",
      "  shadefit stress --out stress\n", declare_stress, stress_command);
  add("check", "recompute everything and compare it with the tables of an earlier run; writes nothing",
      "  shadefit check\n  shadefit check --baseline out\n  shadefit check --fail-above 1% --format sarif\n",
      declare_check, check_command);
  add("lint", "find published constants in source code, and what is wrong with them",
      "  shadefit lint shaders\n  shadefit lint src --format sarif --fail-on typo\n", declare_lint,
      lint_command);
  add_time_limit(app, call);
  auto* help = app.add_subcommand("help", "the help of a command")->group("Commands");
  help->allow_extras();
  help->add_option("command", "one of the commands")->type_name("COMMAND");
  help->footer("Examples:\n  shadefit help fit\n");
}

}  // namespace shadefit
