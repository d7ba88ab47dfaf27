#include "bench/peers/verdict.hpp"

#include <cstdio>

namespace shadefit::side_by_side {
namespace {

const Row* quicker(const Row* best, const Row& row) {
  return best == nullptr || *row.seconds < *best->seconds ? &row : best;
}

}  // namespace

std::string times(double ratio) {
  char text[32];
  std::snprintf(text, sizeof text, ratio < 100 ? "%.1f" : "%.0f", ratio);
  return text;
}

TaskVerdict judge(const std::vector<Row>& rows, const std::string& task) {
  TaskVerdict verdict;
  bool has_peer = false;
  for (const Row& row : rows) {
    if (row.task != task || !row.is_judged || !row.seconds || !row.digits) continue;
    if (row.is_ours) {
      verdict.ours = quicker(verdict.ours, row);
    } else {
      has_peer = true;
      if (!row.is_expert) verdict.usual = quicker(verdict.usual, row);
      if (*row.digits >= promised_digits) verdict.as_exact = quicker(verdict.as_exact, row);
    }
  }
  if (verdict.ours == nullptr) {
    verdict.text = "OURS FAILED";
  } else if (*verdict.ours->digits < promised_digits) {
    verdict.text = "OURS LOST DIGITS";
  } else if (!has_peer) {
    verdict.holds = true;
    verdict.text = "no peer ran";
  } else if (verdict.as_exact == nullptr) {
    verdict.holds = true;
    verdict.text = "no peer reaches our digits";
  } else {
    const double ratio = *verdict.as_exact->seconds / *verdict.ours->seconds;
    verdict.holds = ratio >= wanted_ratio;
    verdict.is_slow = !verdict.holds;
    verdict.text = (verdict.holds ? "" : "ONLY ") + times(ratio) + " x";
  }
  return verdict;
}

}  // namespace shadefit::side_by_side
