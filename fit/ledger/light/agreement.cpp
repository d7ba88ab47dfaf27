#include "fit/ledger/light/agreement.hpp"

#include "approx/lobe.hpp"
#include "fit/errors/effect.hpp"
#include "fit/support/format.hpp"

namespace shadefit {

std::string within(double gap, std::string_view tolerance) {
  return gap <= number_of(tolerance) ? fmt::format("within {}", tolerance) : fmt::format("to {:.2g}", gap);
}

std::string effect_of_power(double from, double to, std::string_view lead) {
  const auto lobe = [](double exponent) {
    return [exponent]<class T>(const Cosine<T>& c) { return power_lobe(c.cos_theta, lift<T>(exponent)); };
  };
  const double blunter = std::min(from, to);
  const Substitution domain({.measure = Measure::cosine},
                            {.concentration = blunter, .end_power = std::min(blunter, 1.0)});
  return sentence(effect_between(lobe(from), lobe(to), domain), "the curve", lead);
}

}  // namespace shadefit
