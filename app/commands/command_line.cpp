#include "app/commands/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/commands/commands.hpp"
#include "app/commands/declare_commands.hpp"
#include "app/options/option_values.hpp"
#include "app/output/interrupt.hpp"
#include "fit/input/known.hpp"
#include "fit/support/nearest.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// The help of `of`, a command or `app` itself, wrapped to 80 columns.
std::string help_text(CLI::App& app, CLI::App& of) {
  constexpr std::size_t column = 30, room = 50, all = column + room;
  const auto fold = [](const std::string& text, std::size_t width) {
    return fmt::format("{}", fmt::join(folded(text, width), "\n"));
  };
  of.description(fold(of.get_description(), all));
  of.get_formatter()->column_width(column);
  for (CLI::Option* option : of.get_options()) {
    const std::string &type = option->get_type_name(), by_default = option->get_default_str();
    const bool is_default_shown = !by_default.empty() && !type.empty();
    option->option_text(option->get_positional() || option->get_items_expected_max() == 0 ? " " : type);
    option->description(
        fold(option->get_description() + (is_default_shown ? " (default: " + by_default + ")" : ""), room));
  }
  for (CLI::App* command : of.get_subcommands({}))
    command->description(fold(command->get_description(), room));
  return &of == &app ? app.help() : of.help(app.get_name());
}

/// A usage error points to the help of the command.
Outcome usage_error(const std::string& message, const std::vector<std::string>& arguments) {
  const std::string of =
      arguments.empty() || arguments.front().starts_with('-') ? "" : " " + arguments.front();
  return {2, "", fmt::format("shadefit: {} (see 'shadefit help{}')\n", one_line(message), of)};
}

/// An error that begins with an option or says what the command needs points there too, unless it names
/// another command to see.
Outcome user_error(const UserError& error, const std::vector<std::string>& arguments) {
  const std::string_view message = error.what();
  const bool is_of_option = message.starts_with("--");
  const bool points_elsewhere = message.find("see 'shadefit ") != std::string_view::npos;
  const bool has_command = !arguments.empty() && !arguments.front().starts_with('-');
  const bool is_of_command = has_command && message.starts_with(arguments.front() + " needs ");
  if (has_command && (is_of_option || is_of_command) && !points_elsewhere)
    return usage_error(error.what(), arguments);
  return {2, "", fmt::format("shadefit: {}\n", one_line(error.what()))};
}

/// Refuses values of flags: CLI11 reads "--json=3" as "--json".
void refuse_values_of_flags(const CLI::App& command, const std::vector<std::string>& arguments) {
  for (const std::string& argument : arguments) {
    const std::string name = argument.substr(0, argument.find('='));
    if (name == argument || !name.starts_with("--")) continue;
    const CLI::Option* option = command.get_option_no_throw(name);
    if (option != nullptr && option->get_items_expected_max() == 0)
      throw UserError(fmt::format("{} takes no value: '{}'", name, argument));
  }
}

/// The first argument that the command does not take.
std::string unexpected_argument(const std::string& argument, const CLI::App& command) {
  if (!argument.starts_with("--")) return fmt::format("unexpected argument '{}'", argument);
  std::vector<std::string> options;
  for (const CLI::Option* option : command.get_options()) options.push_back(option->get_name());
  const auto nearest = nearest_name(argument, options);
  return fmt::format("unknown option '{}'{}", argument,
                     nearest ? fmt::format(": did you mean '{}'?", *nearest) : "");
}

/// The first required argument that is not there.
std::string missing_argument(const CLI::App& command) {
  const auto options = command.get_options();
  const auto found = std::ranges::find_if(
      options, [](const CLI::Option* option) { return option->get_required() && option->empty(); });
  return fmt::format("{} needs {}: {}", command.get_name(), (*found)->get_type_name(),
                     (*found)->get_description());
}

/// The command that the arguments name. CLI11 would call a mistyped one an unexpected argument.
CLI::App& named_command(CLI::App& app, const std::string& name) {
  if (name.starts_with('-')) throw UserError(fmt::format("unexpected argument '{}' before a command", name));
  require_known(name, command_names(app), "command");
  return *app.get_subcommand(name);
}

bool asks_for_help(const std::string& argument) {
  return argument == "--help" || argument == "-h";
}

Outcome parse_and_run(const std::vector<std::string>& given, const Watched& work, const Terminal& terminal) {
  CLI::App app{"shadefit refits, checks and reports the approximation constants of real-time shading.",
               "shadefit"};
  app.footer("See 'shadefit help COMMAND' for the options and examples of a command.\n");
  Call call{work, terminal};
  declare_commands(app, call);
  if (given.empty())
    return usage_error(fmt::format("name a command: {}", fmt::join(command_names(app), ", ")), given);
  const std::string& first = given.front();
  if (first == "--version") return {0, app.version() + "\n" + libraries_inside() + "\n", ""};
  if (first == "--completion" && given.size() == 2) return {0, completion(app, given[1]), ""};
  const bool is_help = first == "help" || asks_for_help(first);
  if (is_help && given.size() == 1) return {0, help_text(app, app), ""};
  if (is_help && given.size() == 2 && !asks_for_help(given[1]))
    return {0, help_text(app, named_command(app, given[1])), ""};
  CLI::App& command = named_command(app, first);
  if (std::ranges::any_of(given, asks_for_help)) return {0, help_text(app, command), ""};
  refuse_values_of_flags(command, given);
  try {
    app.parse(std::vector<std::string>(given.rbegin(), given.rend()));  // in reverse, for CLI11
  } catch (const CLI::RequiredError&) {
    return usage_error(missing_argument(command), given);
  } catch (const CLI::ParseError& error) {
    return usage_error(error.what(), given);
  }
  if (const auto more = command.remaining(); !more.empty())
    return usage_error(unexpected_argument(more.front(), command), given);
  return call.run();
}

std::string time_is_over(const TimeIsOver& over) {
  return fmt::format("shadefit: the --time-limit of {} seconds is over", over.seconds);
}

/// An unexpected error. The user can fix an error of the file system: a name that is too long, a cycle of
/// links, a folder without permission. Missing memory or threads are the machine's fault.
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
                      one_line(error.what()), one_line(shell_text(arguments)))};
}

/// What failed, in one line: its parts after each other, the first of them if there are many.
std::string as_one_line(const std::string& lines) {
  constexpr std::size_t most = 3;
  constexpr std::string_view start = "shadefit: ";
  std::istringstream rest(lines);
  std::string line;
  std::size_t parts = 0;
  for (std::string part; std::getline(rest, part); ++parts) {
    if (parts < most)
      line += parts == 0 ? part : "; " + part.substr(part.starts_with(start) ? start.size() : 0);
  }
  if (parts > most) line += fmt::format("; and {} more", parts - most);
  return line + "\n";
}

}  // namespace

Outcome prepare_command_line(const std::vector<std::string>& arguments, const Checkpoint& checkpoint,
                             const Progress& progress, const Terminal& terminal) {
  try {
    return parse_and_run(arguments, watch(checkpoint, progress, arguments.empty() ? "" : arguments.front()),
                         terminal);
  } catch (const UserError& error) {
    return user_error(error, arguments);
  } catch (const CheckFailed& error) {
    return {1, "", fmt::format("shadefit: {}\n", one_line(error.what()))};
  } catch (const Interrupted& interrupted) {
    return {128 + interrupted.signal, "", "shadefit: interrupted, nothing was written\n"};
  } catch (const TimeIsOver& over) {
    return {1, "", time_is_over(over) + ", nothing was written\n"};
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
  } catch (const TimeIsOver& over) {
    outcome.exit_code = 1;
    outcome.err += time_is_over(over) + " before all was written\n";
  } catch (const Interrupted& interrupted) {
    outcome.exit_code = 128 + interrupted.signal;
    outcome.err += "shadefit: interrupted before all was written\n";
  }
  if (outcome.exit_code != 0 && !outcome.err.empty()) outcome.err = as_one_line(outcome.err);
  return outcome;
}

Outcome run_command_line(const std::vector<std::string>& arguments, const Checkpoint& checkpoint,
                         const Progress& progress) {
  return put_files(prepare_command_line(arguments, checkpoint, progress, {}));
}

}  // namespace shadefit
