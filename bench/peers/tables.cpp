#include "bench/peers/tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace shadefit::side_by_side {
namespace {

/// Three digits with a suitable unit.
std::string time(const std::optional<double>& seconds) {
  if (!seconds) return "";
  const auto [size, unit] = *seconds >= 1      ? std::pair(1.0, "s")
                            : *seconds >= 1e-3 ? std::pair(1e-3, "ms")
                                               : std::pair(1e-6, "us");
  const double value = *seconds / size;
  return fmt::format("{:.{}f} {}", value, value < 10 ? 2 : value < 100 ? 1 : 0, unit);
}

/// Rounded down to a tenth: 13.96 is not 14.
std::string digits(const std::optional<double>& value) {
  return value ? fmt::format("{:.1f}", std::floor(*value * 10) / 10) : "";
}

/// A peer in a sentence: name, time, digits, and the ratio to our time.
std::string beside(const Row* peer, const Row* ours) {
  if (peer == nullptr) return "|||";
  return fmt::format("| {} {} | {} ({}) | {} ", peer->tool, peer->variant, time(peer->seconds),
                     digits(peer->digits), times(ours == nullptr ? 0 : *peer->seconds / *ours->seconds));
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
    text +=
        fmt::format("| {} | {} {}{}| {} |\n", task.id,
                    ours == nullptr ? "" : fmt::format("{} ({})", time(ours->seconds), digits(ours->digits)),
                    beside(verdict.as_exact, ours), beside(verdict.usual, ours), verdict.text);
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
      text += fmt::format("| {} | {}{} | {} | {} | {} | {} |\n", row.tool, row.variant,
                          row.is_judged ? "" : " (listed)", time(row.seconds), time(row.process_seconds),
                          digits(row.digits), fmt::join(row.notes, "; "));
    }
  }
  return text;
}

}  // namespace shadefit::side_by_side
