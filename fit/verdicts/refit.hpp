#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "approx/lobe.hpp"
#include "approx/records/record.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/verdicts/verdict.hpp"

/// Refits a family at its exponents under each measure, and judges the published numbers.
namespace shadefit {

/// Every number published for the family.
std::vector<const Published*> numbers_of(const Family& family);

/// The exponents for which a number is right that was published without its exponent.
struct ExponentRange {
  double from, to;  ///< in this range the fitted parameter rounds to the printed digits
  double exactly;   ///< at this exponent it is the printed number
};

/// A published number and the number that the fits give under one metric: a parameter, a mean or a limit.
struct Assessment {
  const Published* published;
  Metric metric;
  double computed;
  Judgement judgement;
  Effect effect;  ///< of replacing the printed number by the computed one, at the worst of its exponents
  std::optional<ExponentRange> holds_for = std::nullopt;  ///< for a number published without its exponent
};

/// A fit and the published numbers for it.
struct FitReport {
  Fit fit;
  std::vector<Assessment> assessments;
};

/// A family refitted over a sweep.
struct Refit {
  const Family* family;
  std::vector<const Published*> numbers;  ///< the published numbers that are judged
  std::vector<FitReport> fits;            ///< by metric, then by exponent
  std::vector<Assessment> derived;  ///< means, limits, numbers without exponent: by number, then by metric
};

/// The fits of one family, each computed once. Not thread-safe.
class FitCache {
 public:
  using Fitter = std::function<Fit(double exponent, const Metric&)>;

  explicit FitCache(const Family& family) : FitCache(family, std::bind_front(&Family::fit, &family)) {}
  FitCache(const Family& family, Fitter fitter) : family_(family), fitter_(std::move(fitter)) {}
  const Family& family() const { return family_; }
  const Fit& at(double exponent, const Metric& metric);

 private:
  const Family& family_;
  Fitter fitter_;
  std::map<std::pair<Metric, double>, Fit> fits_;
};

/// The fits of all families, each computed once. The tables and the ledger of a run share one.
class Fits {
 public:
  FitCache& of(const Family& family);

 private:
  std::map<const Family*, FitCache> caches_;
};

/// Fits the cache's family at the exponents and at those of the published `numbers`, in rising order, and
/// judges the numbers, including means and limits of fits. The checkpoint is called
/// before each fit and each mean or limit.
Refit refit(FitCache& fits, std::vector<double> exponents, std::vector<const Published*> numbers,
            std::span<const Metric> under, const Checkpoint& checkpoint = keep_going);

/// The value of a published number, computed under a metric. Empty if a fit that it needs did not converge,
/// or if there is no limit.
std::optional<double> computed_value(FitCache& fits, const Published& published, const Metric& metric);

/// Judges one published number of the cache's family: by the value under `metric`, then under the other
/// measures and the record's own convention. Empty if a fit that it needs did not converge.
std::optional<Assessment> assess(FitCache& fits, const Published& published, const Metric& metric);

/// Quadratic extrapolation in 1/k to 1/k = 0 from the fits at k = 1e4, 1e5, 1e6: exact except for terms in
/// 1/k^3. Empty if a fit did not converge, or if the fits at k = 1e5, 1e6, 1e7 give another limit: on a
/// domain without the peak, the best parameter grows without bound.
std::optional<ApproachLaw<double>> extrapolate(FitCache& fits, const Metric& metric, std::size_t parameter);

/// The exponents of a published number: from k = 1e6 for a limit, {0} if it has none.
std::vector<double> exponents_of(const Published& published);

/// The exponents of the fits that are needed to judge it: the family's sweep for a number without its
/// exponent.
std::vector<double> exponents_needed_by(const Published& published, const Family& family);

/// The whole domain, under each measure.
std::vector<Metric> whole_domain_metrics();

}  // namespace shadefit
