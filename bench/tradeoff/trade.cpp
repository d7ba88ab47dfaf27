#include "bench/tradeoff/trade.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <utility>

namespace shadefit::bench {

Spread spread_of(std::vector<double> samples) {
  std::ranges::sort(samples);
  const auto quantile = [&](double share) {
    const double rank = share * static_cast<double>(samples.size() - 1);
    const auto below = static_cast<std::size_t>(rank), above = std::min(below + 1, samples.size() - 1);
    return samples[below] + (rank - static_cast<double>(below)) * (samples[above] - samples[below]);
  };
  return {quantile(0.5), quantile(0.75) - quantile(0.25)};
}

std::string this_cpu() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

const TimedTarget& target_of(const Trade& trade, const TimedForm& form) {
  return *std::ranges::find(trade.targets, form.target, &TimedTarget::id);
}

std::string full_id(const TimedForm& timed) {
  return timed.exp2_degree == 0 ? timed.form : timed.form + "/exp2-" + std::to_string(timed.exp2_degree);
}

void mark_unbeaten(std::vector<TimedForm>& forms) {
  double least = std::numeric_limits<double>::infinity();
  for (TimedForm& form : forms) {
    form.is_unbeaten = form.max_abs_error && *form.max_abs_error < least;
    if (form.is_unbeaten) least = *form.max_abs_error;
  }
}

std::vector<TimedForm> shown_forms(const Trade& trade, const std::string& target) {
  std::vector<TimedForm> shown;
  for (const TimedForm& timed : trade.forms) {
    if (timed.target != target) continue;
    const auto same = std::ranges::find_if(shown, [&](const TimedForm& other) {
      return full_id(other) == full_id(timed) && other.precision == timed.precision;
    });
    if (trade.shows_all_sets || same == shown.end()) {
      shown.push_back(timed);
    } else if (timed.max_abs_error < same->max_abs_error) {
      *same = timed;
    }
  }
  std::ranges::stable_sort(shown, {},
                           [](const TimedForm& row) { return std::pair(row.ns.median, row.max_abs_error); });
  mark_unbeaten(shown);
  return shown;
}

}  // namespace shadefit::bench
