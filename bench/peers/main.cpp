// Runs the tasks of bench/peers/run with every available tool: see bench/README.md, "Beside others".
//
//   side_by_side --out FILE --references DIR --rounds N --seconds S TOOL=PROGRAM..
//
// A PROGRAM may have arguments, separated by spaces. The tool named shadefit is ours; the word after `:` is
// the command whose process is timed. Exit code 0; 1 if a verdict does not hold; 2 for bad usage.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "approx/fresnel.hpp"
#include "bench/peers/run.hpp"
#include "bench/peers/tables.hpp"
#include "bench/peers/truth.hpp"
#include "bench/peers/verdict.hpp"

namespace shadefit::side_by_side {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

struct Tool {
  std::string name;
  std::vector<std::string> program;
  std::string command;  ///< of our tool
  std::string version = {};
};

/// NAME=PROGRAM[:COMMAND].
Tool tool_of(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw std::runtime_error("'" + text + "' is not TOOL=PROGRAM");
  const auto parts = split(text.substr(equals + 1), ':');
  return {text.substr(0, equals), split(parts.at(0), ' '), parts.size() > 1 ? parts[1] : ""};
}

/// A row without times so far, and its two programs.
struct TaskRun {
  Row row;
  std::vector<std::string> task_program, process;
};

std::vector<TaskRun> task_runs(Tool& tool) {
  std::vector<std::string> listing = tool.program;
  listing.push_back("--list");
  const Finished finished = run(listing);
  if (!finished.is_well) throw std::runtime_error(tool.name + " does not run: " + tool.program.back());
  std::vector<TaskRun> result;
  for (const std::string& line : split(finished.output, '\n')) {
    if (line.rfind("version ", 0) == 0) {
      tool.version = line.substr(8);
      continue;
    }
    const auto cells = split(line, '\t');
    const std::string task = cells.at(0), variant = cells.at(1);
    TaskRun task_run{{.task = task, .tool = tool.name, .variant = variant}, tool.program, {}};
    task_run.row.is_ours = !tool.command.empty();
    task_run.row.is_judged = cells.at(2) != "listed";
    task_run.row.is_expert = cells.at(2) == "expert";
    task_run.task_program.insert(task_run.task_program.end(), {task, variant});
    if (cells.size() > 3) {
      task_run.process = split(cells[3], ' ');
      task_run.process.insert(task_run.process.begin(), tool.command);
    } else {
      task_run.process = task_run.task_program;
      task_run.process.push_back("0");
    }
    task_run.task_program.push_back("");  // the seconds
    result.push_back(std::move(task_run));
  }
  return result;
}

void keep_least(std::optional<double>& least, double seconds) {
  if (!least || seconds < *least) least = seconds;
}

/// Reads the output of a task program: its time, the digits of its worst number, its notes. A missing number
/// counts as wrong. A program without any number, such as a proof, has no digits.
void take(Row& row, const std::string& output, const Task& task) {
  std::map<std::string, double> found;
  row.notes.clear();
  for (const std::string& line : split(output, '\n')) {
    const auto words = split(line, ' ');
    if (words.size() == 2 && words[0] == "seconds") keep_least(row.seconds, std::atof(words[1].c_str()));
    if (line.rfind("note ", 0) == 0) row.notes.push_back(line.substr(5));
    if (words.size() != 4 || words[0] != "value") continue;
    const std::string name = answer_name(words[1], words[2]);
    const auto truth = task.truth.find(name);
    if (truth == task.truth.end()) continue;
    const double digits = correct_digits(words[3], truth->second);
    const auto [at, is_new] = found.emplace(name, digits);
    if (!is_new) at->second = std::min(at->second, digits);
  }
  if (found.empty() && !task.is_fit && !row.notes.empty()) return;
  double worst = 40;
  std::vector<std::string> wrong;
  for (const auto& [name, value] : task.truth) {
    const auto at = found.find(name);
    const double digits = at == found.end() ? 0 : at->second;
    worst = std::min(worst, digits);
    if (digits < 1) wrong.push_back(name);
  }
  row.digits = worst;
  if (!wrong.empty() && task.truth.size() > 2)
    row.notes.push_back("wrong or no answer in " + std::to_string(wrong.size()) + " of " +
                        std::to_string(task.truth.size()));
}

struct Options {
  std::string out, references;
  int rounds = 5;
  std::string seconds = "0.1";
  std::vector<Tool> tools;
};

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto value = [&] {
      if (i + 1 == arguments.size()) throw std::runtime_error(arguments[i] + " needs a value");
      return arguments[++i];
    };
    if (arguments[i] == "--out")
      options.out = value();
    else if (arguments[i] == "--references")
      options.references = value();
    else if (arguments[i] == "--rounds")
      options.rounds = std::atoi(value().c_str());
    else if (arguments[i] == "--seconds")
      options.seconds = value();
    else
      options.tools.push_back(tool_of(arguments[i]));
  }
  if (options.out.empty() || options.references.empty() || options.tools.empty() || options.rounds < 1)
    throw std::runtime_error(
        "usage: side_by_side --out FILE --references DIR [--rounds N] [--seconds S] TOOL=PROGRAM..");
  return options;
}

/// The text after the colon of a line in a system file, or the first words of a file without a colon.
std::string said_in(const std::string& path, const std::string& label) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (label.empty()) return line;
    if (line.rfind(label, 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string load() {
  const auto words = split(said_in("/proc/loadavg", ""), ' ');
  return words.at(0);
}

/// Gives the published Fresnel pair to the programs that are not C++: task_program.hpp.
void export_published_pair() {
  ::setenv("PUBLISHED_A", std::string(fresnel_published[2].printed).c_str(), 1);
  ::setenv("PUBLISHED_B", std::string(fresnel_published[3].printed).c_str(), 1);
}

int compare(Options options) {
  export_published_pair();
  const std::vector<Task> all = tasks(options.references);
  std::vector<TaskRun> by_tool;
  for (Tool& tool : options.tools) {
    for (TaskRun& task_run : task_runs(tool)) by_tool.push_back(std::move(task_run));
  }
  const std::string load_before = load();
  // Results that are compared are measured close together: all tools at one task, then the next task, round
  // after round.
  for (int round = 1; round <= options.rounds; ++round) {
    for (const Task& task : all) {
      std::fprintf(stderr, "\rround %d of %d, %s   ", round, options.rounds, task.id.c_str());
      for (TaskRun& task_run : by_tool) {
        if (task_run.row.task != task.id) continue;
        task_run.task_program.back() = options.seconds;
        const Finished timed = run(task_run.task_program);
        if (timed.is_well)
          take(task_run.row, timed.output, task);
        else
          task_run.row.notes = {"FAILED"};
        const Finished process = run(task_run.process);
        if (process.is_well) keep_least(task_run.row.process_seconds, process.seconds);
      }
    }
  }
  std::fputs("\n", stderr);

  std::vector<Row> rows;
  for (const TaskRun& task_run : by_tool) rows.push_back(task_run.row);
  std::string text = "# shadefit beside others\n\n" + said_in("/proc/cpuinfo", "model name") +
                     ", one core, one thread; load " + load_before + " before and " + load() +
                     " after. Times are the least of " + std::to_string(options.rounds) +
                     " interleaved rounds; digits those of the worst number against 50 digits.\n";
  for (const Tool& tool : options.tools) text += "\n- " + tool.version;
  text += "\n\n## Verdict\n\n" + verdict_table(all, rows) + task_tables(all, rows);
  std::ofstream out(options.out, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + options.out);
  std::cout << verdict_table(all, rows);
  const bool all_hold = std::all_of(
      all.begin(), all.end(), [&](const Task& task) { return !task.is_fit || judge(rows, task.id).holds; });
  return all_hold ? 0 : 1;
}

}  // namespace
}  // namespace shadefit::side_by_side

int main(int argc, char** argv) {
  try {
    return shadefit::side_by_side::compare(shadefit::side_by_side::parse({argv + 1, argv + argc}));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench/peers/run: %s\n", error.what());
    return 2;
  }
}
