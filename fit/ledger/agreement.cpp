#include "fit/ledger/agreement.hpp"

#include "approx/lobe.hpp"
#include "fit/decimal.hpp"
#include "fit/effect.hpp"

namespace shadefit {

std::string within(double gap, std::string_view tolerance) {
  return gap <= number_of(tolerance) ? "within " + std::string(tolerance) : "to " + decimal(gap, 2);
}

std::string effect_of_power(double from, double to) {
  const auto lobe = [](double exponent) {
    return [exponent]<class T>(const Cosine<T>& c) { return power_lobe(c.cos_theta, lift<T>(exponent)); };
  };
  const Substitution domain({.measure = Measure::cosine}, {.concentration = std::min(from, to)});
  return sentence(effect_between(lobe(from), lobe(to), domain));
}

}  // namespace shadefit
