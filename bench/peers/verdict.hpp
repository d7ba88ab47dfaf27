#pragma once

#include <optional>
#include <string>
#include <vector>

namespace shadefit::side_by_side {

/// The result of one variant of one tool on one task.
struct Row {
  std::string task, tool, variant;
  bool is_ours = false;
  bool is_judged = true;
  bool is_expert = false;              ///< a method that needs a derivation by hand or own nodes; judged too
  std::optional<double> seconds = {};  ///< the least time in the process; empty if it failed
  std::optional<double> process_seconds = {};  ///< the least time of the whole process
  std::optional<double> digits = {};           ///< of the worst number; empty if no number was requested
  std::vector<std::string> notes = {};
};

/// The required ratio of times to a peer with the same digits.
inline constexpr double wanted_ratio = 10;
/// The digits that ours promises and must not lose. More digits are luck in the last bits of a double, so a
/// peer with this many counts as equal.
inline constexpr double promised_digits = 14;

struct TaskVerdict {
  const Row* ours = nullptr;
  const Row* as_exact = nullptr;  ///< the fastest judged peer with the same digits; null if there is none
  const Row* usual = nullptr;     ///< the fastest judged peer with any digits, without experts' methods
  bool holds = false;
  bool is_slow = false;  ///< `as_exact` takes less than `wanted_ratio` times as long
  std::string text;      ///< in words
};

/// A ratio of times: one decimal, or a whole number from 100 on.
std::string times(double ratio);

/// The verdict on one task. Ours must keep its digits and be `wanted_ratio` times as fast as `as_exact`, if
/// there is one. The rows must outlive it.
TaskVerdict judge(const std::vector<Row>& rows, const std::string& task);

}  // namespace shadefit::side_by_side
