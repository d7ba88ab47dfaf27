#include "fit/truths/albedos.hpp"

#include <array>
#include <limits>
#include <numbers>
#include <vector>

#include "fit/truths/albedo_rules.hpp"
#include "fit/truths/albedo_table.hpp"

namespace shadefit {
namespace {

/// A rule by its name, with the largest side of its table in log(c).
struct NamedRule {
  std::string_view name;
  AlbedoTable::Rule rule;
  double side = 2;
};

double charlie_albedo(double c, double alpha) {
  return sheen_albedo(c, alpha, 1);
}

// The lobe of sheen is a function of c^2/alpha: the strip where it is analytic is half as wide.
constexpr std::array albedo_rules{
    NamedRule{"ggx_albedo",
              [](double c, double a) { return ggx_albedo(JointMasking::height_correlated, c, a); }},
    NamedRule{"ggx_albedo_separable",
              [](double c, double a) { return ggx_albedo(JointMasking::separable, c, a); }},
    NamedRule{"ggx_albedo_k", [](double c, double a) { return ggx_albedo(JointMasking::schlick, c, a); }},
    NamedRule{"ggx_bias", [](double c, double a) { return ggx_bias(JointMasking::height_correlated, c, a); }},
    NamedRule{"ggx_bias_separable",
              [](double c, double a) { return ggx_bias(JointMasking::separable, c, a); }},
    NamedRule{"ggx_bias_k", [](double c, double a) { return ggx_bias(JointMasking::schlick, c, a); }},
    NamedRule{"charlie_albedo", charlie_albedo, 1},
    NamedRule{"imageworks_sheen_albedo",
              [](double c, double a) { return sheen_albedo(c, a, std::numeric_limits<double>::infinity()); },
              1},
};

const AlbedoTable& table_of(std::size_t index) {
  static const std::vector<AlbedoTable> tables = [] {
    // Below c = 1/4 the visibility of Charlie is cut off for some lights; at c = 1 - sqrt(3)/2 for the
    // mirrored view.
    const std::vector edges{0.5, 0.25, 0.16, 1 - std::numbers::sqrt3 / 2, 0.11};
    std::vector<AlbedoTable> result;
    for (const auto& [name, rule, side] : albedo_rules)
      result.emplace_back(rule, side, rule == charlie_albedo ? edges : std::vector<double>{});
    return result;
  }();
  return tables[index];
}

}  // namespace

std::optional<Albedo> find_albedo(std::string_view name) {
  for (std::size_t i = 0; i < albedo_rules.size(); ++i) {
    if (albedo_rules[i].name == name) return Albedo{i};
  }
  return std::nullopt;
}

double albedo_value(const Albedo& albedo, double c, double alpha) {
  return table_of(albedo.index).derivative(albedo.by_c, albedo.by_alpha, c, alpha);
}

long double albedo_value(const Albedo& albedo, long double c, long double alpha) {
  return table_of(albedo.index).derivative(albedo.by_c, albedo.by_alpha, c, alpha);
}

double albedo_by_rule(const Albedo& albedo, double c, double alpha) {
  return albedo_rules[albedo.index].rule(c, alpha);
}

}  // namespace shadefit
