#include <benchmark/benchmark.h>

#include <string>
#include <utility>

#include "approx/normalisation.hpp"
#include "bench/solver/benchmarks.hpp"
#include "fit/families/families.hpp"
#include "fit/fit.hpp"
#include "fit/integrals/directional_reflectance.hpp"
#include "fit/integrals/normalisation_check.hpp"
#include "fit/integrals/reflectance.hpp"
#include "fit/least_squares/least_squares.hpp"

namespace shadefit::bench {
namespace {

/// Times `part`, whose result is not used.
template <class Part>
void register_part(const std::string& name, const Part& part) {
  benchmark::RegisterBenchmark(("part/" + name).c_str(), [part](benchmark::State& state) {
    for (auto _ : state) {
      auto value = part();
      benchmark::DoNotOptimize(value);
    }
  })->Unit(benchmark::kMicrosecond);
}

/// The three rules of a fit, for the basin, the polish and the check, sampled.
template <class F>
void register_sampling(const F& family) {
  register_part("sampling/" + std::string(F::info.id),
                [family] { return LeastSquares<F>(family, Metric{}); });
}

/// The search for the largest absolute error of a given fit.
void register_search(const FittableFamily& family, const Setting& setting) {
  const Fit fit = family.fit(setting, Metric{});
  register_part("largest-error/" + std::string(family.info.id), [family, setting, fit] {
    return family.max_abs_error(setting, fit.metric.domain, fit.parameters);
  });
}

}  // namespace

void register_parts() {
  // 5: an ordinary exponent, for which the lobe is not cut.
  constexpr double exponent = 5;
  register_sampling(FresnelQuadratic{});
  register_sampling(SgOffset{{exponent}});
  register_sampling(PhongBlinn{{exponent}});
  for (const FittableFamily& family : fittable_families()) register_search(family, exponent);

  // At each of the eight exponents of the table.
  register_part("normalisation/norm-phong-brdf", [] { return check_normalisation(PhongBrdfLobe::record); });

  const auto register_point = [](const std::string& name, ReflectedLobe lobe) {
    const View view(60);
    register_part("reflectance/" + name, [lobe, view] {
      // A view and an exponent of the table, with the tolerance of the table.
      constexpr double alpha = 64, tolerance = reflectance_tolerance / 100;
      return std::pair(reflect_by_circles(lobe, alpha, view, tolerance),
                       reflect_by_longitude(lobe, alpha, view, tolerance));
    });
  };
  register_point("phong", ReflectedLobe::phong);
  register_point("blinn-phong", ReflectedLobe::blinn_phong);
}

}  // namespace shadefit::bench
