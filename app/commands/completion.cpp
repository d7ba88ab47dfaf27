#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <sstream>
#include <vector>

#include "app/commands/declare_commands.hpp"
#include "app/options/fit_arguments.hpp"
#include "app/studies/find_study.hpp"
#include "bench/tradeoff/timed_forms.hpp"
#include "fit/better/results.hpp"
#include "reports/rows/citation.hpp"

namespace shadefit {
namespace {

using Words = std::vector<std::string>;

/// The possible words of a value, by the name of its type; empty for a number, a file or free text.
Words words_for(const CLI::App& app, const std::string& type) {
  const auto with_studies = [](Words words) {
    const Words studies = study_ids(study_folders({}));
    words.insert(words.end(), studies.begin(), studies.end());
    return words;
  };
  Words words;
  if (type == "FORM") return with_studies(ids_with_a_fit());
  if (type == "CLAIM") return with_studies(claim_ids());
  if (type == "ID") return with_studies(known_ids());
  if (type == "CITED") return with_studies(cited_ids());
  if (type == "STUDY") return with_studies({});
  if (type == "TARGET") {
    for (const forms::Target& target : forms::catalogue().targets) {
      if (!bench::is_of_several_lights(target)) words.emplace_back(target.id);
    }
  } else if (type == "FORM|all") {
    words.emplace_back("all");
    for (const forms::FormEntry& form : forms::catalogue().forms) {
      if (form.arguments == forms::Arguments::cosine) words.emplace_back(form.id);
    }
  } else if (type == "COMMAND") {
    for (const CLI::App* command : app.get_subcommands({})) words.push_back(command->get_name());
  } else if (type.find('|') != std::string::npos) {
    std::istringstream choices(type);
    for (std::string choice; std::getline(choices, choice, '|');) {
      const bool is_word =
          choice.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
      if (is_word) words.push_back(choice);
    }
  }
  return words;
}

/// The code that completes a value of this type.
std::string offer(const CLI::App& app, const std::string& type) {
  if (const Words words = words_for(app, type); !words.empty())
    return fmt::format("words='{}'", fmt::join(words, " "));
  // `-o default` completes a path; a number or a free text is the user's.
  return type == "FILE" || type == "DIR" ? "return" : "compopt +o default 2>/dev/null; return";
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  // A branch of a case statement: a command, the word before the cursor, and how to complete what follows.
  constexpr const char* branch = "    {}:{}) {} ;;\n";
  std::string out = fmt::format(
      "# Completes shadefit in bash: made by 'shadefit --completion bash'.\n"
      "_shadefit() {{\n"
      "  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} words=\n"
      "  COMPREPLY=()\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then words='{}'\n"
      "  else case ${{COMP_WORDS[1]}}:$previous in\n",
      fmt::join(words_for(app, "COMMAND"), " "));
  for (const CLI::App* command : app.get_subcommands({})) {
    const std::string& of = command->get_name();
    Words options, positionals;
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_positional()) {
        positionals.push_back(option->get_type_name());
        continue;
      }
      options.push_back("--" + option->get_lnames().front());
      if (option->get_items_expected_max() > 0)
        out += fmt::format(branch, of, options.back(), offer(app, option->get_type_name()));
    }
    out += fmt::format(
        branch, of, "*",
        fmt::format("if [[ $current == -* ]]; then words='{}'; else {}; fi", fmt::join(options, " "),
                    offer(app, positionals.empty() ? "" : positionals.front())));
  }
  return out +
         "  esac; fi\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "}\n"
         "complete -o default -F _shadefit shadefit\n";
}

}  // namespace shadefit
