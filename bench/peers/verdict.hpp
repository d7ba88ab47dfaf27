#pragma once

#include <optional>
#include <string>
#include <vector>

namespace shadefit::side_by_side {

/// What became of one variant of one tool on one task.
struct Row {
  std::string task, tool, variant;
  bool is_ours = false;
  bool is_judged = true;
  bool is_expert = false;  ///< a way that wants a derivation by hand or nodes of one's own; judged as well
  std::optional<double> seconds = {};          ///< in the process, the least; empty where it failed
  std::optional<double> process_seconds = {};  ///< of the whole process, the least
  std::optional<double> digits = {};           ///< of the worst number; empty where none was asked for
  std::vector<std::string> notes = {};
};

/// How much faster ours has to be than a peer that answers as exactly.
inline constexpr double wanted_ratio = 10;
/// The digits that ours promises and must not lose. What more a double can hold is luck of its last bits, so
/// a peer with as many counts as equal.
inline constexpr double promised_digits = 14;

struct TaskVerdict {
  const Row* ours = nullptr;
  const Row* as_exact = nullptr;  ///< the fastest judged peer with as many digits; null where there is none
  const Row* usual = nullptr;     ///< the fastest judged peer of any digits, experts' ways apart
  bool holds = false;
  bool is_slow = false;  ///< `as_exact` takes less than `wanted_ratio` times as long
  std::string text;      ///< in words
};

/// The verdict on one task. Ours has to have kept its digits and to be `wanted_ratio` times as fast as
/// `as_exact`, where there is one. The rows have to outlive it.
TaskVerdict judge(const std::vector<Row>& rows, const std::string& task);

}  // namespace shadefit::side_by_side
