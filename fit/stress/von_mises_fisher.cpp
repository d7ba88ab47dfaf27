#include "approx/von_mises_fisher.hpp"
#include "approx/full_range.hpp"

#include "fit/stress/regime.hpp"

namespace shadefit {
namespace {

/// The usual lobes, and inputs that are hard for a normalisation: k towards 0, and k where sinh overflows.
std::vector<Input> von_mises_fisher_inputs(const BinaryFormat& format, std::size_t random) {
  auto all = near_peak_inputs(format, 2, random, 6);
  const double top = largest(format);
  const auto concentrations =
      with_neighbours(format,
                      {0, least_subnormal(format), least_normal(format), 1e-30, 1e-20, 1e-12, 1e-7, 1e-5,
                       11.09, 11.78, 88.72, 89.4, 709.7, 710, 710.5, 711, top / 2, top},
                      0, top);
  Sequence sequence(7);
  for (const double k : concentrations) {
    for (const double y : {0.0, 0x1p-10, 0.5, 1.0, 1.5, 2.0}) all.push_back({y, k});
  }
  for (std::size_t i = 0; i < random / 2; ++i) {
    const double k = round_to(format, log_uniform(sequence, least_subnormal(format), top));
    all.push_back({round_to(format, sequence.between(0, 2)), k});
  }
  return all;
}

/// k/(2 pi (1 - e^(-2k))) e^(-k y). At k = 0 it is 1/(4 pi).
Decimal50 truth(const Decimal50& y, const Decimal50& k) {
  return k == 0 ? Decimal50(1 / (4 * pi<Decimal50>())) : von_mises_fisher_near_peak(y, k);
}

}  // namespace

std::vector<Regime> von_mises_fisher_regimes() {
  return {
      {.topic = "von Mises-Fisher",
       .domain = "y = 1 - c in [0, 2], every finite k >= 0",
       .names = {"y", "k"},
       .forms = {{"von_mises_fisher", "k/(4 pi sinh k) e^(k c), c = 1 - y", in_formats([](auto y, auto k) {
                    return von_mises_fisher(decltype(y)(integer<decltype(y)>(1) - y), k);
                  })},
                 {"von_mises_fisher_near_peak", "k/(2 pi (1 - e^(-2k))) e^(-k y)",
                  in_formats([](auto y, auto k) { return von_mises_fisher_near_peak(y, k); })},
                 // expm1 and two exp; their two products, the quotients by it and by 2 pi, and pi itself. In
                 // the exponent k y is rounded
                 {"von_mises_fisher_of_any_concentration", "the same, e^(-k y) in two factors",
                  in_formats([](auto y, auto k) { return von_mises_fisher_of_any_concentration(y, k); }),
                  Roundings{.operations = 5, .functions = 3, .operations_per_fold = 1}}},
       .truth = truth,
       .folds = [](double y, double k) { return k * y; },
       .inputs = von_mises_fisher_inputs}};
}

}  // namespace shadefit
