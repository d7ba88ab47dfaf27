#pragma once

#include "approx/scalar.hpp"
#include "tests/approx/formulas/formula.hpp"

namespace shadefit::testing {

/// Of the functions that no formula of approx/ calls: users' formulas call them.
template <class Visit>
void vocabulary_formulas(const Visit& visit) {
  using Places = Arguments;
  visit(Formula{"tan", [](auto x) { return tan(x); }, Places{{"0.25"}, {"-1.25"}}, 4});
  visit(Formula{"asin", [](auto x) { return asin(x); }, Places{{"0.25"}, {"-0.9375"}}, 4});
  visit(Formula{"acos", [](auto x) { return acos(x); }, Places{{"0.25"}, {"-0.5"}, {"0.9921875"}}, 4});
  visit(Formula{"atan2", [](auto y, auto x) { return atan2(y, x); },
                Places{{"0.25", "0.5"}, {"0.25", "-0.5"}, {"-2", "-0.5"}, {"-2", "0.5"}}, 4});
  visit(Formula{"sinh", [](auto x) { return sinh(x); }, Places{{"0.0625"}, {"-2"}}, 4});
  visit(Formula{"cosh", [](auto x) { return cosh(x); }, Places{{"0.0625"}, {"-2"}}, 4});
  visit(Formula{"tanh", [](auto x) { return tanh(x); }, Places{{"0.0625"}, {"-2"}}, 4});
  visit(Formula{"erf", [](auto x) { return erf(x); }, Places{{"0.0625"}, {"-1"}}, 4});
  visit(Formula{"floor", [](auto x) { return floor(x); }, Places{{"0.75"}, {"-2.5"}, {"3"}}, 0.5});
  visit(Formula{"abs", [](auto x) { return abs(x); }, Places{{"0.75"}, {"-2.5"}}, 0.5});
  visit(Formula{"sign", [](auto x) { return signum(x); }, Places{{"0.75"}, {"-2.5"}, {"0"}}, 0.5});
}

}  // namespace shadefit::testing
