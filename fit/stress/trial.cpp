#include "fit/stress/trial.hpp"

#include <cmath>

#include "fit/quadrature/metric.hpp"

namespace shadefit {

double Roundings::fixed(const BinaryFormat& format) const {
  return operations + functions * (format.digits == half_format.digits ? 1 : 2);
}

double Roundings::per_fold(const BinaryFormat& format) const {
  return operations_per_fold + functions_per_fold * (format.digits == half_format.digits ? 1 : 2);
}

std::string bound_text(const Roundings& roundings, const BinaryFormat& format) {
  const double per_fold = roundings.per_fold(format);
  const std::string fixed = to_text(roundings.fixed(format));
  return per_fold == 0 ? fixed : fixed + " + " + to_text(per_fold) + " L";
}

double bound_ulps(const Roundings& roundings, const BinaryFormat& format, double folds) {
  const double u = std::ldexp(1.0, -format.digits);
  return std::expm1((roundings.fixed(format) + roundings.per_fold(format) * folds) * u) / u;
}

}  // namespace shadefit
