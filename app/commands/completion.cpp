#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "app/commands/declare_commands.hpp"
#include "app/studies/find_study.hpp"
#include "bench/tradeoff/timed_forms.hpp"
#include "fit/better/results.hpp"
#include "fit/support/user_error.hpp"
#include "reports/rows/citation.hpp"

namespace shadefit {
namespace {

using Words = std::vector<std::string>;

/// The possible words of a value, by the name of its type; empty for a number, a file or free text.
Words words_for(const CLI::App& app, const std::string& type) {
  Words words;
  if (type == "COMMAND") {
    for (const CLI::App* command : app.get_subcommands({})) words.push_back(command->get_name());
  } else if (type == "TARGET") {
    for (const forms::Target& target : forms::catalogue()) {
      if (!bench::is_of_several_lights(target)) words.emplace_back(target.id);
    }
  } else if (type == "FORM|all") {
    words.emplace_back("all");
    for (const forms::Target& target : forms::catalogue()) {
      if (target.arguments != forms::Arguments::cosine) continue;
      for (const forms::FormEntry& form : target.forms) words.emplace_back(form.id);
    }
  } else if (type == "FORM" || type == "CLAIM" || type == "ID" || type == "CITED" || type == "STUDY") {
    if (type == "FORM") words = fitted_ids();
    if (type == "CLAIM") words = claim_ids();
    if (type == "ID") words = known_ids();
    if (type == "CITED") words = cited_ids();
    const Words studies = study_ids(study_folders({}));
    words.insert(words.end(), studies.begin(), studies.end());
  } else {
    std::istringstream choices(type);
    for (std::string choice; std::getline(choices, choice, '|');) {
      if (choice.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos)
        words.push_back(choice);
    }
  }
  return words;
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

/// The shell code that completes words, paths, or nothing.
struct Actions {
  const char *begin, *words, *paths, *nothing, *is_option, *end;
};

/// Bash and zsh have the same shape: after a first word, cases of command and word before the cursor.
std::string by_cases(const CLI::App& app, const Actions& actions) {
  // A branch of a case statement: a command, the word before the cursor, and how to complete what follows.
  constexpr const char* branch = "    {}:{}) {} ;;\n";
  const auto offer = [&](const std::string& type) -> std::string {
    const Words words = words_for(app, type);
    if (!words.empty()) return fmt::format(fmt::runtime(actions.words), fmt::join(words, " "));
    return type == "FILE" || type == "DIR" ? actions.paths : actions.nothing;
  };
  std::string out = fmt::format(fmt::runtime(actions.begin), fmt::join(words_for(app, "COMMAND"), " "));
  for (const CLI::App* command : app.get_subcommands({})) {
    const std::string& of = command->get_name();
    Words options;
    std::string positional = actions.nothing;
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_positional()) {
        if (positional == actions.nothing) positional = offer(option->get_type_name());
        continue;
      }
      options.push_back("--" + option->get_lnames().front());
      if (takes_value(*option))
        out += fmt::format(branch, of, options.back(), offer(option->get_type_name()));
    }
    out += fmt::format(
        branch, of, "*",
        fmt::format("if {}; then {}; else {}; fi", actions.is_option,
                    fmt::format(fmt::runtime(actions.words), fmt::join(options, " ")), positional));
  }
  return out + actions.end;
}

constexpr Actions bash{
    .begin =
        "# Completes shadefit in bash: made by 'shadefit --completion bash'.\n"
        "_shadefit() {{\n"
        "  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} words=\n"
        "  COMPREPLY=()\n"
        "  if [ \"$COMP_CWORD\" -eq 1 ]; then words='{}'\n"
        "  else case ${{COMP_WORDS[1]}}:$previous in\n",
    .words = "words='{}'",
    .paths = "return",  // then `-o default` completes a path
    .nothing = "compopt +o default 2>/dev/null; return",
    .is_option = "[[ $current == -* ]]",
    .end =
        "  esac; fi\n"
        "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
        "}\n"
        "complete -o default -F _shadefit shadefit\n"};

constexpr Actions zsh{.begin =
                          "#compdef shadefit\n"
                          "# Made by 'shadefit --completion zsh'.\n"
                          "if (( CURRENT == 2 )); then compadd -- {}\n"
                          "else case ${{words[2]}}:${{words[CURRENT-1]}} in\n",
                      .words = "compadd -- {}",
                      .paths = "_files",
                      .nothing = "return 1",
                      .is_option = "[[ $PREFIX == -* ]]",
                      .end = "  esac\nfi\n"};

/// A text for groff: '-' and '\' are escaped, and no line begins with a groff command.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (out.empty() || out.back() == '\n') out += "\\&";
    out += c == '-' ? "\\-" : c == '\\' ? "\\e" : std::string(1, c);
  }
  return out;
}

std::string manual_page(const CLI::App& app) {
  std::string out = fmt::format(
      ".TH SHADEFIT 1 \"\" \"{}\" \"User Commands\"\n.SH NAME\nshadefit \\- refit, check and report the "
      "approximation constants of real-time shading\n.SH SYNOPSIS\n.B shadefit\n.I COMMAND\n[options]\n"
      ".SH DESCRIPTION\n{}\nEach command is described below; 'shadefit help COMMAND' prints the same.\n.SH "
      "COMMANDS\n",
      roff(app.version()), roff(app.get_description()));
  for (const CLI::App* command : app.get_subcommands({})) {
    std::string usage = command->get_name(), options;
    for (const CLI::Option* option : command->get_options()) {
      const std::string& type = option->get_type_name();
      if (option->get_positional()) usage += option->get_required() ? " " + type : " [" + type + "]";
      std::string title = option->get_positional() ? "\\fI" + roff(type) + "\\fR"
                                                   : "\\fB" + roff(option->get_name()) + "\\fR";
      if (takes_value(*option) && !option->get_positional()) title += " \\fI" + roff(type) + "\\fR";
      const std::string& by_default = option->get_default_str();
      options += fmt::format(".TP\n{}\n{}{}\n", title, roff(option->get_description()),
                             by_default.empty() ? "" : roff(" (default: " + by_default + ")"));
    }
    out += fmt::format(".SS {} [options]\n{}\n{}.PP\n.nf\n{}.fi\n", roff(usage),
                       roff(command->get_description()), options, roff(command->get_footer()));
  }
  return out +
         ".SH EXIT STATUS\n.TP\n0\nsuccess\n.TP\n1\na check failed or a fit did not converge\n.TP\n2\nbad usage "
         "or bad input\n.TP\n128 + n\nsignal n interrupted the command\n"
         ".SH ENVIRONMENT\n.TP\nNO_COLOR\nwhere it is set, nothing is coloured; also with TERM=dumb\n";
}

}  // namespace

std::string completion(const CLI::App& app, const std::string& shell) {
  if (shell == "bash") return by_cases(app, bash);
  if (shell == "zsh") return by_cases(app, zsh);
  if (shell == "man") return manual_page(app);
  throw UserError(fmt::format("--completion '{}' is unknown: it must be one of bash, zsh, man", shell));
}

}  // namespace shadefit
