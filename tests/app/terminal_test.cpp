#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands/command_line.hpp"
#include "app/output/interrupt.hpp"
#include "reports/io/files.hpp"
#include "tests/app/refusal.hpp"
#include "tests/process.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_lacks;
using testing::TemporaryDirectory;

const std::vector<std::string> commands{"list",  "run",     "fit",  "better", "certify", "verify", "emit",
                                        "scene", "explain", "cite", "bench",  "stress",  "check",  "help"};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> words_of_line(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> std::quoted(word, '\'');) words.push_back(word);
  return words;
}

/// What the command prints on a terminal of that width, with LF for its line ends.
std::string on_terminal(std::vector<std::string> arguments, unsigned short width, const char* type = "xterm",
                        const char* no_colour = "") {
  winsize size{.ws_row = 50, .ws_col = width, .ws_xpixel = 0, .ws_ypixel = 0};
  std::vector<char*> argv;
  arguments.insert(arguments.begin(), SHADEFIT_COMMAND);
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, &size);
  if (child == 0) {
    ::setenv("TERM", type, 1);
    ::setenv("NO_COLOR", no_colour, 1);
    ::dup2(::open("/dev/null", O_WRONLY), STDERR_FILENO);
    ::execv(argv.front(), argv.data());
    ::_exit(127);
  }
  std::string text = testing::read_all(terminal);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  std::erase(text, '\r');
  return text;
}

std::string without_colours(std::string text) {
  for (std::size_t i = 0; (i = text.find('\x1b', i)) != std::string::npos;)
    text.erase(i, text.find('m', i) - i + 1);
  return text;
}

std::size_t widest(const std::string& text) {
  std::size_t most = 0;
  for (const std::string& line : lines_of(without_colours(text))) most = std::max(most, line.size());
  return most;
}

TEST(Terminal, TablesAndExplanationsFitTheWidthAndAPipeHasAll) {
  const std::vector<std::vector<std::string>> calls{
      {"fit", "fresnel-quadratic"}, {"list"}, {"list", "--verdict", "refuted"}, {"explain", "acos-cubic"}};
  for (const auto& call : calls) {
    const std::string piped = run_command_line(call).out;
    for (const unsigned short width : std::array<unsigned short, 2>{80, 200})
      EXPECT_LE(widest(on_terminal(call, width)), width) << call.front();
    EXPECT_EQ(without_colours(on_terminal(call, 1000)), piped) << "wide enough for all columns";
    EXPECT_EQ(without_colours(on_terminal(call, 0)), piped) << "a terminal of unknown width";
  }
  const std::string narrow = on_terminal({"fit", "fresnel-quadratic"}, 80);
  EXPECT_NE(narrow.find("-5.554727812648839"), std::string::npos) << "no value is cut";
  expect_has(narrow, "(left out for the width of the terminal: digits, status, at c");
}

TEST(Terminal, OfAComparisonFormConstantsErrorAndCostStay) {
  const std::string narrow = on_terminal({"better", "fresnel-one-term"}, 80);
  expect_has(narrow, "\nrow  form ");
  for (const char* shown : {"  constants  ", "max abs error", "instructions\n"}) expect_has(narrow, shown);
  expect_has(narrow, "(left out for the width of the terminal: ");
}

TEST(Terminal, TheBoundsOfAProofStayLongest) {
  const std::string narrow = on_terminal({"certify", "burley-albedo"}, 80);
  expect_has(narrow, "  from         max error at least             at most\n");
  expect_has(narrow, "(left out for the width of the terminal: boxes, at r, at x, k, h, g)");
}

TEST(Terminal, VerdictsAreColouredThereAlone) {
  const std::vector<std::string> call{"explain", "sg-offset-mean"};
  expect_has(on_terminal(call, 80), "verdict   \x1b[32mconfirmed\x1b[0m\n");
  expect_lacks(on_terminal(call, 80, "dumb"), "\x1b");
  EXPECT_EQ(on_terminal(call, 80, "xterm", "1").find('\x1b'), std::string::npos) << "NO_COLOR";
  EXPECT_EQ(testing::run_process(call, [] { ::setenv("TERM", "xterm", 1); }).out.find('\x1b'),
            std::string::npos);
  expect_has(on_terminal({"fit", "fresnel-quadratic"}, 80), "\x1b[32mconfirmed\x1b[0m");
}

TEST(Terminal, TheConstantsAndTheLargestErrorStay) {
  // The formulas above a table are not folded.
  const auto table_of = [](const std::vector<std::string>& call) {
    const std::string text = on_terminal(call, 80);
    const auto begin = text.find('\n') + 1;
    return text.substr(begin, text.find("\n(left out for", begin) - begin);
  };
  const std::string fit = table_of({"fit", "agx-septic"});
  EXPECT_LE(widest(fit), 80U);
  for (const char* shown : {"constants", "a = ", "p = ", "max abs error", "verdict"}) expect_has(fit, shown);
  const std::string better = table_of({"better", "pq-patry"});
  EXPECT_LE(widest(better), 80U);
  const std::string titles =
      better.substr(better.find("\nrow ") + 1, better.find("\n  1 ") - better.find("\nrow "));
  for (const char* shown : {"form", "constants", "max abs error", "instructions"}) expect_has(titles, shown);
}

TEST(Console, DropsTheConstantsAndTheLargestErrorLast) {
  const Table table{{"row", "constants", "max abs error", "at x", "cost"},
                    {{1L, word("a = 1"), Number{0.125, 3}, Number{1, 3}, 7L}}};
  EXPECT_TRUE(write_console(table, Precision::report, {.width = 30})
                  .starts_with("row  constants  max abs error\n  1  a = 1              0.125\n"));
  EXPECT_TRUE(
      write_console(table, Precision::report, {.width = 20}).starts_with("row  constants\n  1  a = 1\n"));
}

TEST(Console, ColumnsAsOne) {
  const Table table{{"k", "a", "b", "error"}, {{1L, Number{2, 3}, Cell(), 4L}, {5L, Cell(), Cell(), 8L}}};
  EXPECT_EQ(write_csv(with_columns_as_one(table, 1, 2, "constants", Precision::report), Precision::report),
            "k,constants,error\n1,a = 2,4\n5,,8\n");
}

TEST(Console, FoldsTextsAndDropsColumnsInOrder) {
  const Table table{{"name", "words", "digits", "value", "verdict", "more"},
                    {{word("first"), word("one two three four five"), 14L, Number{0.125, 3}, word("refuted"),
                      word("a = 1, b = 2, c = 3")}}};
  const auto shown = [&](std::size_t width) {
    return write_console(table, Precision::report, {.width = width});
  };
  EXPECT_EQ(shown(0),
            "name   words                    digits  value  verdict  more\n"
            "first  one two three four five      14  0.125  refuted  a = 1, b = 2, c = 3\n");
  EXPECT_EQ(shown(75), shown(0));
  EXPECT_EQ(shown(68),
            "name   words              digits  value  verdict  more\n"
            "first  one two three          14  0.125  refuted  a = 1, b = 2,\n"
            "       four five                                  c = 3\n");
  EXPECT_EQ(shown(60),
            "name   words              value  verdict  more\n"
            "first  one two three      0.125  refuted  a = 1, b = 2,\n"
            "       four five                          c = 3\n"
            "(left out for the width of the terminal: digits)\n");
  EXPECT_EQ(shown(20),
            "name   verdict\nfirst  refuted\n"
            "(left out for the\nwidth of the\nterminal: digits,\nmore, value, words)\n");
  EXPECT_TRUE(shown(5).starts_with("name   verdict\nfirst  refuted\n")) << "the least that is shown";
  EXPECT_EQ(write_console(table, Precision::report, {.has_colour = true}).find("\x1b[31mrefuted\x1b[0m  a"),
            shown(0).find("refuted"));
}

TEST(Help, IsTheSameOnBothWaysAndFits80Columns) {
  for (const std::string& command : commands) {
    const Outcome help = run_command_line({"help", command});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.out, run_command_line({command, "--help"}).out);
    EXPECT_EQ(help.out, run_command_line({"--help", command}).out);
    EXPECT_LE(widest(help.out), 80U) << help.out;
  }
  const std::string all = run_command_line({"help"}).out;
  EXPECT_EQ(all, run_command_line({"--help"}).out);
  EXPECT_LE(widest(all), 80U);
  for (const std::string& command : commands) expect_has(all, "\n  " + command + " ");
}

// In the order of the commands: `verify` reads what `certify` wrote.
TEST(Help, EveryExampleRuns) {
  const TemporaryDirectory directory;
  directory.file("scene.mtl", "newmtl a\nKs 0.5 0.5 0.5\nNs 50\n");
  std::filesystem::create_directory_symlink(SHADEFIT_SOURCE_DIR "/reports", directory.path() / "reports");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(directory.path());
  for (const std::string& command : commands) {
    int examples = 0;
    for (const std::string& line : lines_of(run_command_line({"help", command}).out)) {
      if (!line.starts_with("  shadefit ")) continue;
      ++examples;
      std::vector<std::string> words = words_of_line(line);
      words.erase(words.begin());
      EXPECT_EQ(words.front(), command);
      // These take half a minute and more, so the test only starts them. .ci/run makes the whole gallery.
      const bool is_long = command == "stress" || line == "  shadefit run --html --out gallery";
      const Checkpoint checkpoint = is_long ? Checkpoint([] { throw Interrupted{SIGINT}; }) : keep_going;
      const Outcome outcome = run_command_line(words, checkpoint);
      EXPECT_EQ(outcome.exit_code, is_long ? 128 + SIGINT : 0) << line << "\n" << outcome.err;
    }
    EXPECT_GE(examples, 1) << command;
  }
  std::filesystem::current_path(before);
}

TEST(ExplainCommand, Json) {
  const auto claim = nlohmann::json::parse(run_command_line({"explain", "sg-offset-mean", "--json"}).out);
  EXPECT_EQ(claim["schema"], 1);
  EXPECT_EQ(claim["claim"], "sg-offset-mean");
  EXPECT_EQ(claim["printed"][0], nlohmann::json::parse(R"({"name": "x", "value": "0.775"})"));
  EXPECT_EQ(claim["source"]["year"], 2012);
  EXPECT_EQ(claim["computed"], "x = 0.7753642585");
  EXPECT_EQ(claim["verdict"], "confirmed");
  EXPECT_EQ(claim["figure"], "plots/offset.svg");
}

/// The output and the errors of a shell command.
std::string shell_output(const std::string& line) {
  FILE* pipe = ::popen((line + " 2>&1").c_str(), "r");
  std::string text;
  for (int c; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  EXPECT_EQ(::pclose(pipe), 0) << line << "\n" << text;
  return text;
}

bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

/// A file with the command's output for that shell.
std::string completion_file(const TemporaryDirectory& directory, const std::string& shell) {
  const Outcome made = run_command_line({"--completion", shell});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  return directory.file(shell, made.out);
}

TEST(Completion, BashCompletesCommandsOptionsValuesAndIds) {
  const TemporaryDirectory directory;
  const std::string file = completion_file(directory, "bash");
  const auto completed = [&](const std::string& line) {
    const std::string script = "source '" + file + "'; COMP_WORDS=(" + line +
                               "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _shadefit; echo ${COMPREPLY[@]}";
    return shell_output("bash -c \"$(cat <<'END'\n" + script + "\nEND\n)\"");
  };
  EXPECT_EQ(completed("shadefit be"), "better bench\n");
  EXPECT_EQ(completed("shadefit fit --me"), "--measure\n");
  EXPECT_EQ(completed("shadefit fit sg-offset --measure cos"), "cosine cosine-weighted\n");
  EXPECT_EQ(completed("shadefit fit sg-offset-"), "sg-offset-mean sg-offset-limit sg-offset-k5\n");
  EXPECT_EQ(completed("shadefit explain half-"), "half-banding\n");
  for (const char* command : {"fit", "better", "explain", "cite", "run", "check", "bench", "list"})
    EXPECT_EQ(completed("shadefit " + std::string(command) + " acos-"),
              "acos-cubic acos-linear acos-quadratic\n")
        << command;
  EXPECT_EQ(completed("shadefit help em"), "emit\n");
  EXPECT_EQ(completed("shadefit bench --only phong-"), "phong-1\n") << "the others are not timed";
  EXPECT_EQ(completed("shadefit fit --round b"), "bfloat16\n");
  EXPECT_EQ(completed("shadefit fit sg-offset --exponent 5"), "\n") << "a number of the user";
}

TEST(Completion, ZshReadsIt) {
  if (!is_installed("zsh")) GTEST_SKIP() << "without zsh: package zsh";
  const TemporaryDirectory directory;
  EXPECT_EQ(shell_output("zsh -n '" + completion_file(directory, "zsh") + "'"), "");
}

TEST(Completion, TheManualPageHasEveryOption) {
  const std::string page = run_command_line({"--completion", "man"}).out;
  for (const std::string& command : commands) {
    expect_has(page, "\n.SS \\&" + command);
    for (const std::string& line : lines_of(run_command_line({"help", command}).out)) {
      if (!line.starts_with("  --")) continue;
      std::string name = words_of_line(line).front();
      for (std::size_t i = 0; (i = name.find('-', i)) != std::string::npos; i += 2) name.insert(i, 1, '\\');
      expect_has(page, "\\fB\\&" + name);
    }
  }
}

TEST(Completion, GroffTakesTheManualPageWithoutAWarning) {
  if (!is_installed("groff")) GTEST_SKIP() << "without groff: package groff-base";
  const TemporaryDirectory directory;
  EXPECT_EQ(shell_output("groff -man -Tutf8 -ww -z '" + completion_file(directory, "man") + "'"), "");
}

}  // namespace
}  // namespace shadefit
