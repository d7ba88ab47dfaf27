#include "approx/phase.hpp"
#include "approx/full_range.hpp"

#include "fit/stress/regime.hpp"

namespace shadefit {
namespace {

/// g at 0, at both ends and random; y likewise, and near (1 - |g|)^2/2, where the function falls.
std::vector<Input> phase_inputs(const BinaryFormat& format, std::size_t random) {
  const double end = below_one(format);
  const auto sizes = with_neighbours(format,
                                     {0, least_subnormal(format), 1e-3, 0.1, 0.25, 0.5, 0.76, 0.9, 0.97, 0.99,
                                      0.995, 0.999, 0.9999, 0.999999, end},
                                     0, end, 1);
  const auto all_edges = edges(format, 2);
  std::vector<Input> all;
  for (const double size : sizes) {
    for (const double g : {size, -size}) {
      for (const double y : all_edges) all.push_back({y, g});
      const double width = (1 - size) * (1 - size) / 2;
      for (double t = 0x1p-6; t < 0x1p6; t *= 2) {
        const double from_peak = std::min(round_to(format, t * width), 2.0);
        all.push_back({g < 0 ? round_to(format, 2 - from_peak) : from_peak, g});
      }
    }
  }
  Sequence sequence(8);
  for (std::size_t i = 0; i < random; ++i) {
    const double rest = log_uniform(sequence, 1 - end, 1);
    const double size = std::min(round_to(format, 1 - rest), end);
    const double from_peak = i % 2 == 0 ? sequence.between(0, 2)
                                        : std::min(2.0, rest * rest * log_uniform(sequence, 0x1p-8, 0x1p8));
    const bool is_back = i % 4 < 2;
    all.push_back({round_to(format, is_back ? 2 - from_peak : from_peak), is_back ? -size : size});
  }
  return all;
}

}  // namespace

std::vector<Regime> phase_regimes() {
  return {{.topic = "Henyey-Greenstein",
           .domain = "y = 1 - c in [0, 2], every g in (-1, 1)",
           .names = {"y", "g"},
           .forms = {{"henyey_greenstein", "(1 - g^2)/(4 pi (1 + g^2 - 2 g c)^1.5), c = 1 - y",
                      in_formats([](auto y, auto g) {
                        return henyey_greenstein(decltype(y)(integer<decltype(y)>(1) - y), g);
                      })},
                     {"henyey_greenstein_near_peak", "the same of b = (1 - g)^2 + 2 g y",
                      in_formats([](auto y, auto g) { return henyey_greenstein_near_peak(y, g); })},
                     // (1 + |g|)/(4 pi): 3 with pi's own. rest/b': 1, 4 and 1, as b' sums a square, 2 x 1 +
                     // 1, and a product, 2. 64/sqrt(b'): 4/2 + 1 and 1. And two products
                     {"henyey_greenstein_from_both_sides", "the same of |g| from either side, scaled",
                      in_formats([](auto y, auto g) { return henyey_greenstein_from_both_sides(y, g); }),
                      Roundings{.operations = 15}}},
           .truth = [](const Decimal50& y, const Decimal50& g) { return henyey_greenstein_near_peak(y, g); },
           .inputs = phase_inputs}};
}

}  // namespace shadefit
