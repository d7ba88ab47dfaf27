#include "fit/stress/fits.hpp"

namespace shadefit {

std::vector<Fit> fits_under_stress(const Checkpoint& checkpoint) {
  std::vector<Fit> fits;
  for (const Family& family : families()) {
    const auto add = [&](double exponent, const Domain& domain) {
      checkpoint();
      fits.push_back(family.fit(Setting(exponent), {.domain = domain}));
    };
    if (family.has_exponent()) {
      for (const double exponent : {1e-3, 0.1, 1.0, 3.7, 15.0, 1e3, 1e6, 1e9}) add(exponent, {});
    } else {
      add(0, {});
    }
    for (const Domain& narrow : {Domain{0.999, 1}, Domain{0.4995, 0.5005}, Domain{0, 1e-3}}) add(15, narrow);
  }
  return fits;
}

}  // namespace shadefit
