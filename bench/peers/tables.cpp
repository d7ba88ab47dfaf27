#include "bench/peers/tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace shadefit::side_by_side {
namespace {

/// Three digits with a suitable unit.
std::string time(const std::optional<double>& seconds) {
  if (!seconds) return "";
  struct Unit {
    double size;
    const char* name;
  };
  for (const Unit unit : {Unit{1, "s"}, Unit{1e-3, "ms"}, Unit{1e-6, "us"}}) {
    if (*seconds < unit.size && unit.size > 1e-6) continue;
    const double value = *seconds / unit.size;
    char text[32];
    std::snprintf(text, sizeof text, "%.*f %s", value < 10 ? 2 : (value < 100 ? 1 : 0), value, unit.name);
    return text;
  }
  return "";
}

/// Rounded down to a tenth: 13.96 is not 14.
std::string digits(const std::optional<double>& value) {
  if (!value) return "";
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", std::floor(*value * 10) / 10);
  return text;
}

std::string notes(const Row& row) {
  std::string text;
  for (const std::string& note : row.notes) text += (text.empty() ? "" : "; ") + note;
  return text;
}

/// A peer in a sentence: name, time, digits, and the ratio to our time.
std::string beside(const Row* peer, const Row* ours) {
  if (peer == nullptr) return "|||";
  const double ratio = ours == nullptr ? 0 : *peer->seconds / *ours->seconds;
  char times[32];
  std::snprintf(times, sizeof times, ratio < 100 ? "%.1f" : "%.0f", ratio);
  return "| " + peer->tool + " " + peer->variant + " | " + time(peer->seconds) + " (" + digits(peer->digits) +
         ") | " + times + " ";
}

}  // namespace

std::string verdict_table(const std::vector<Task>& tasks, const std::vector<Row>& rows) {
  std::string text =
      "| task | ours, from nothing (digits) | the fastest peer with as many digits | its time (digits) | times "
      "ours | the fastest as its manual has it, at any digits | its time (digits) | times ours | verdict |\n"
      "|---|---|---|---|---|---|---|---|---|\n";
  std::string why;
  for (const Task& task : tasks) {
    if (!task.is_fit) continue;
    const TaskVerdict verdict = judge(rows, task.id);
    const Row* ours = verdict.ours;
    text += "| " + task.id + " | " +
            (ours == nullptr ? std::string() : time(ours->seconds) + " (" + digits(ours->digits) + ")") +
            " " + beside(verdict.as_exact, ours) + beside(verdict.usual, ours) + "| " + verdict.text + " |\n";
    if (verdict.is_slow && !task.why.empty())
      why += "- " + task.id + ", " + verdict.as_exact->tool + ": " + task.why + ".\n";
  }
  return text + (why.empty() ? "" : "\nWhy not ten times:\n\n" + why);
}

std::string task_tables(const std::vector<Task>& tasks, const std::vector<Row>& rows) {
  std::string text;
  for (const Task& task : tasks) {
    text += "\n## " + task.id + ": " + task.title + "\n\n";
    if (!task.start.empty()) text += "The others start at " + task.start + ".\n\n";
    text += "| tool | variant | in the process | as a process | digits | |\n|---|---|---|---|---|---|\n";
    for (const Row& row : rows) {
      if (row.task != task.id) continue;
      text += "| " + row.tool + " | " + row.variant + (row.is_judged ? "" : " (listed)") + " | " +
              time(row.seconds) + " | " + time(row.process_seconds) + " | " + digits(row.digits) + " | " +
              notes(row) + " |\n";
    }
  }
  return text;
}

}  // namespace shadefit::side_by_side
