#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bench/tradeoff/trade.hpp"
#include "reports/findings/finding.hpp"

/// The times of a run against those of an older one, perhaps of another machine.
namespace shadefit::bench {

/// The median times of a run by `benchmark_name`, in the unit of its file. Only their ratios have a meaning.
using Medians = std::map<std::string, double, std::less<>>;

/// The medians in a file of `bench --json`, or of Google Benchmark. Throws UserError naming `file` if it is
/// no such file.
Medians medians_of(std::string_view text, const std::string& file);

/// A form that was timed in both runs, with its data in the first cache: in memory the time is the memory's,
/// and its ratio to arithmetic is the machine's. Its time counts in those of the reference of its target in
/// the same run (scalar, of its precision), so the speeds of two machines cancel, as far as one is faster at
/// everything alike.
struct FormTimes {
  std::string name, reference;
  double before = 0, now = 0;                       ///< time of the form / time of the reference
  double more() const { return now / before - 1; }  ///< how much longer it takes now: 0.1 is 10 %
};

/// The forms of both runs, by their order in the new one.
std::vector<FormTimes> times_in_both(const Trade& now, const Medians& before);

/// Those that take longer by more than `share` as findings, each with both ratios. `file` has the older run.
findings::FindingReport slower_forms(const std::vector<FormTimes>& forms, double share,
                                     const std::string& file);

}  // namespace shadefit::bench
