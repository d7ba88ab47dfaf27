#include "fit/errors/one_code.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>

#include "approx/encoding.hpp"

namespace shadefit {

double change_of_one_code() {
  // The change in codes is proportional to the grey times the slope of the encoding. That is largest at
  // white.
  const auto beyond = [](double change) { return srgb_code(1.0) - srgb_code(1 - change) - 1; };
  std::uintmax_t steps = 60;
  const auto root = boost::math::tools::toms748_solve(beyond, 0.0, 0.5,
                                                      boost::math::tools::eps_tolerance<double>(45), steps);
  return (root.first + root.second) / 2;
}

}  // namespace shadefit
