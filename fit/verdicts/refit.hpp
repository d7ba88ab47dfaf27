#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "approx/lobe.hpp"
#include "approx/records/record.hpp"
#include "fit/fit.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/published_curve.hpp"
#include "fit/verdicts/verdict.hpp"

/// Refitting a family: its exponents under each measure, and what that says of the published numbers.
namespace shadefit {

/// Where a number that was published without its exponent is right.
struct ExponentRange {
  double from, to;  ///< here the fitted parameter rounds to all printed digits
  double exactly;   ///< and here it is the printed number
};

/// A published number against what the fits give for it under one metric: a parameter, a mean or a limit.
struct Assessment {
  const Published* published;
  Metric metric;
  double computed;
  Judgement judgement;
  Effect effect;  ///< of replacing the printed number by the computed one, at the worst of its exponents
  std::optional<ExponentRange> holds_for = std::nullopt;  ///< for a number published without its exponent
};

/// A fit and the published numbers that are meant for it.
struct FitReport {
  Fit fit;
  std::vector<Assessment> assessments;
};

/// A family refitted over a sweep.
struct Refit {
  const FittableFamily* family;
  std::vector<const Published*> numbers;  ///< the published ones that it judges
  std::vector<FitReport> fits;            ///< by metric, then by exponent
  std::vector<Assessment> derived;  ///< means, limits, numbers without exponent: by number, then by metric
};

/// The fits of one family, each computed once. Not for use from several threads.
class FitCache {
 public:
  explicit FitCache(const FittableFamily& family) : family_(family) {}
  const FittableFamily& family() const { return family_; }
  const Fit& at(const Setting& setting, const Metric& metric);

 private:
  const FittableFamily& family_;
  std::map<std::pair<Metric, Setting>, Fit> fits_;
};

/// The fits of all families, each computed once: a run has one, which its tables and its ledger share.
class Fits {
 public:
  FitCache& of(const FittableFamily& family);

 private:
  std::map<const FittableFamily*, FitCache> caches_;
};

/// Fits the family at each setting under each of `under`, and judges the published
/// numbers that are meant for those fits. The checkpoint is called before each fit.
std::vector<FitReport> fit_and_assess(FitCache& fits, const std::vector<Setting>& settings,
                                      std::span<const Metric> under,
                                      const Checkpoint& checkpoint = keep_going);

/// Fits the cache's family at the exponents, and at those that the `numbers` were published for, in rising
/// order, and judges the numbers: also those that are means or limits of fits. The checkpoint is called
/// before each fit and each mean or limit.
Refit refit(FitCache& fits, std::vector<double> exponents, std::vector<const Published*> numbers,
            std::span<const Metric> under, const Checkpoint& checkpoint = keep_going);

/// The value that a published number states, computed under a metric. Empty where a fit that it needs did not
/// converge, or where there is no limit.
std::optional<double> computed_value(FitCache& fits, const Published& published, const Metric& metric);

/// Judges one published number of the cache's family: the value under `metric`, against the other measures
/// and the record's own convention. Empty where a fit that the value needs did not converge.
std::optional<Assessment> assess(FitCache& fits, const Published& published, const Metric& metric);

/// Quadratic extrapolation in 1/k to 1/k = 0 from the fits at k = 1e4, 1e5, 1e6: exact but for terms in
/// 1/k^3. Empty where a fit did not converge, or where those at k = 1e5, 1e6, 1e7 lead elsewhere: on a domain
/// that leaves the peak out the best parameter grows without bound.
std::optional<ApproachLaw<double>> extrapolate(FitCache& fits, const Metric& metric, std::size_t parameter);

/// Where the fitted parameter takes the printed value: its crossings of that value and of the two numbers
/// half a unit of its last digit away, looked for between the exponents of the family's sweep. Empty where it
/// does not cross them.
std::optional<ExponentRange> where_it_holds(FitCache& fits, const Published& published, const Metric& metric);

/// The exponents that a published number speaks of; a limit is looked at from k = 1e6, no exponent stands as
/// {0}.
std::vector<double> exponents_of(const Published& published);

/// Those to fit at before it is judged: of a number published without its exponent the family's sweep.
std::vector<double> exponents_needed_by(const Published& published, const Family& family);

/// The whole domain under every measure, in their order.
std::vector<Metric> whole_domain_metrics();

}  // namespace shadefit
