#include "approx/gloss.hpp"
#include "approx/full_range.hpp"

#include <algorithm>
#include <cmath>

#include "fit/stress/regime.hpp"

namespace shadefit {
namespace {

/// The decode of the record: 2^(10 g + 1).
constexpr int doublings = 10, first = 1;

/// Both ends and beyond them, every 8-bit gloss by division and by multiplication, and random numbers.
std::vector<Input> gloss_inputs(const BinaryFormat& format, std::size_t random) {
  std::vector<double> numbers = edges(format, 1);
  const double ulp = 1 - below_one(format);
  for (const double g : {-0.0, -least_subnormal(format), -ulp, -0.01, 1 + 2 * ulp, 1 + 4 * ulp, 1.01})
    numbers.push_back(g);
  for (int byte = 0; byte <= 255; ++byte) {
    numbers.push_back(byte / 255.0);
    numbers.push_back(byte * round_to(format, 1 / 255.0));
  }
  Sequence sequence(10);
  for (std::size_t i = 0; i < random; ++i) numbers.push_back(sequence.unit());
  return single_inputs(format, numbers);
}

template <class T>
T decoded(const T& gloss) {
  return decode_gloss(gloss, integer<T>(doublings), integer<T>(first));
}

}  // namespace

std::vector<Regime> gloss_regimes() {
  return {
      {.topic = "gloss",
       .domain = "any g in [-0.01, 1.01], 10 doublings from 2",
       .names = {"g", ""},
       .forms = {{"decode_gloss", "exp2(10 g + 1)",
                  in_formats([](auto gloss, auto) { return decoded(gloss); })},
                 // two exp2 and their product; in the exponent 10 g is rounded
                 {"decode_clamped_gloss", "exp2(10 g) exp2(1), g clamped", in_formats([](auto gloss, auto) {
                    using T = decltype(gloss);
                    return decode_clamped_gloss(gloss, integer<T>(doublings), integer<T>(first));
                  }),
                  Roundings{.operations = 1, .functions = 2, .operations_per_fold = 1}}},
       .truth = [](const Decimal50& gloss, const Decimal50&) { return decoded(unit_cosine(gloss)); },
       .folds = [](double gloss, double) { return doublings * std::clamp(gloss, 0.0, 1.0) * std::log(2.0); },
       .at_most = 2048,
       .inputs = gloss_inputs}};
}

}  // namespace shadefit
