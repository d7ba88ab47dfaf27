#include "approx/normalisation.hpp"
#include "approx/full_range.hpp"

#include <cmath>

#include "fit/stress/regime.hpp"

namespace shadefit {
namespace {

std::vector<Input> normalisation_inputs(const BinaryFormat& format, std::size_t random) {
  const double top = largest(format);
  std::vector<double> numbers = exponents(format);
  numbers.insert(numbers.end(), {0, least_subnormal(format), least_normal(format), 1e-30, 1e-12, 1e-7, 1e-5,
                                 1e18, 1e19, 1e20, std::sqrt(top), top});
  for (double alpha = 0.125; alpha < 4096; alpha += alpha < 32 ? 0.125 : 8) numbers.push_back(alpha);
  Sequence sequence(9);
  for (std::size_t i = 0; i < random; ++i)
    numbers.push_back(i % 2 == 0 ? log_uniform(sequence, 1e-3, 1e6)
                                 : log_uniform(sequence, least_subnormal(format), top));
  return single_inputs(format, with_neighbours(format, numbers, 0, top, 1));
}

}  // namespace

std::vector<Regime> normalisation_regimes() {
  return {
      {.topic = "normalisation",
       .domain = "every finite alpha >= 0",
       .names = {"alpha", ""},
       .forms = {{BlinnPhongBrdfLobe::record.id, std::string(BlinnPhongBrdfLobe::record.printed),
                  in_formats([](auto alpha, auto) { return BlinnPhongBrdfLobe::constant(alpha); })},
                 // a + 2, the sum, the quotient; a + 4, pi, the quotient; the product; and exp2
                 {"blinn_phong_brdf_constant_by_parts", "(a+2)/(2^(-a/2) + a) (a+4)/(8 pi)",
                  in_formats([](auto alpha, auto) { return blinn_phong_brdf_constant_by_parts(alpha); }),
                  Roundings{.operations = 7, .functions = 1}}},
       .truth = [](const Decimal50& alpha, const Decimal50&) { return BlinnPhongBrdfLobe::constant(alpha); },
       .inputs = normalisation_inputs},
      {.topic = "normalisation",
       .domain = "every finite alpha >= 0",
       .names = {"alpha", ""},
       // a + 2, the difference, pi, the product, the quotient; and exp2, at most as large as the difference
       .forms = {{BlinnPhongLobe::record.id, std::string(BlinnPhongLobe::record.printed),
                  in_formats([](auto alpha, auto) { return BlinnPhongLobe::constant(alpha); }),
                  Roundings{.operations = 5, .functions = 1}}},
       .truth = [](const Decimal50& alpha, const Decimal50&) { return BlinnPhongLobe::constant(alpha); },
       .inputs = normalisation_inputs}};
}

}  // namespace shadefit
