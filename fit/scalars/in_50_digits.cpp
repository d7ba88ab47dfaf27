#include "fit/scalars/in_50_digits.hpp"

#include <stdexcept>

namespace shadefit {

Decimal50 in_50_digits(const Symbolic& expression,
                       const std::function<Decimal50(const std::string&)>& value_of) {
  return evaluate<Decimal50>(expression, value_of);
}

Decimal50 in_50_digits(const Symbolic& expression) {
  return in_50_digits(expression, [](const std::string& name) -> Decimal50 { throw std::logic_error(name); });
}

}  // namespace shadefit
