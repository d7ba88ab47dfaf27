#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

/// The truths of two variables that are integrals over the hemisphere, by their names. They are functions of
/// the cosine c and of the width alpha, both in [0, 1]; docs/truths.md defines them.
namespace shadefit {

/// A truth and which of its derivatives: (c d/dc)^by_c (alpha d/dalpha)^by_alpha.
struct Albedo {
  std::size_t index;
  int by_c = 0, by_alpha = 0;
};

/// The highest order of a derivative by one of the two.
inline constexpr int most_albedo_order = 3;

std::optional<Albedo> find_albedo(std::string_view name);

/// Its value, interpolated (albedo_table.hpp): to 1e-12, sampled. Not a number outside of [0, 1].
double albedo_value(const Albedo& albedo, double c, double alpha);
long double albedo_value(const Albedo& albedo, long double c, long double alpha);

/// The value by its quadrature, for tests and benchmarks.
double albedo_by_rule(const Albedo& albedo, double c, double alpha);

}  // namespace shadefit
