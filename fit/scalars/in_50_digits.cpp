#include "fit/scalars/in_50_digits.hpp"

#include <stdexcept>

#include "fit/scalars/rounded_once.hpp"

namespace shadefit {

Decimal50 in_50_digits(const Symbolic& expression,
                       const std::function<Decimal50(const std::string&)>& value_of) {
  return evaluate<Decimal50>(expression, value_of);
}

Decimal50 in_50_digits(const Symbolic& expression) {
  return in_50_digits(expression, [](const std::string& name) -> Decimal50 { throw std::logic_error(name); });
}

long double rounded_once(const Symbolic& expression,
                         const std::function<std::array<long double, 2>(const std::string&)>& value_of) {
  return static_cast<long double>(in_50_digits(expression, [&](const std::string& name) {
    const auto [a, b] = value_of(name);
    return Decimal50(Decimal50(a) + Decimal50(b));
  }));
}

long double rounded_once(const Symbolic& expression) {
  return static_cast<long double>(in_50_digits(expression));
}

}  // namespace shadefit
