
#include "approx/scalar.hpp"
#include "fit/stress/regime.hpp"

namespace shadefit {
namespace {

std::vector<Input> remainder_inputs(const BinaryFormat& format, std::size_t random) {
  std::vector<double> numbers = edges(format, 2);
  const double end = below_one(format);
  for (const double x : edges(format, end)) numbers.push_back(-x);
  for (const double x : {10.0, 1000.0, largest(format)}) numbers.push_back(x);
  Sequence sequence(11);
  for (std::size_t i = 0; i < random; ++i) {
    const double size = i % 2 == 0 ? sequence.unit() : log_uniform(sequence, least_normal(format), 1);
    numbers.push_back(i % 4 < 2 ? size : -size);
  }
  return single_inputs(format, with_neighbours(format, numbers, -end, largest(format), 1));
}

}  // namespace

std::vector<Regime> remainder_regimes() {
  return {
      {.topic = "remainder",
       .domain = "every finite x > -1",
       .names = {"x", ""},
       .forms = {{"log1p", "log1p(x) - x", in_formats([](auto x, auto) { return log1p(x) - x; })},
                 // By the series up to |x| = 1/2: r = x/(2 + x) has 2, its square 5, the sum 1 and little
                 // more, the product with it 9 at most, of which the difference, 3/5 of x and more, keeps
                 // 2/3, 6, and its own; then the product with r: 10. Beyond, log1p is at most 4.3 times
                 // the difference, so its 2 count as 8.6, and the difference: 10. One for the rest.
                 {"log1p_remainder", "r (2 r^2 (1/3 + r^2/5 + ..) - x), r = x/(2 + x)",
                  in_formats([](auto x, auto) { return log1p_remainder(x); }), Roundings{.operations = 11}}},
       .truth = [](const Decimal50& x, const Decimal50&) { return log1p_remainder(x); },
       .is_positive = false,
       .inputs = remainder_inputs}};
}

}  // namespace shadefit
