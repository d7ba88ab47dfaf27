#include "fit/truths/albedos.hpp"

#include <array>
#include <limits>
#include <numbers>
#include <vector>

#include "fit/truths/albedo_rules.hpp"
#include "fit/truths/albedo_table.hpp"

namespace shadefit {
namespace {

template <Masking masking>
double albedo_under(double c, double alpha) {
  return ggx_albedo(masking, c, alpha);
}
template <Masking masking>
double bias_under(double c, double alpha) {
  return ggx_bias(masking, c, alpha);
}
double charlie_albedo(double c, double alpha) {
  return sheen_albedo(c, alpha, 1);
}
double imageworks_sheen_albedo(double c, double alpha) {
  return sheen_albedo(c, alpha, std::numeric_limits<double>::infinity());
}

struct NamedRule {
  std::string_view name;
  AlbedoTable::Rule rule;
};

constexpr std::array ggx_rules{
    NamedRule{"ggx_albedo", albedo_under<Masking::height_correlated>},
    NamedRule{"ggx_albedo_separable", albedo_under<Masking::separable>},
    NamedRule{"ggx_albedo_k", albedo_under<Masking::schlick>},
    NamedRule{"ggx_bias", bias_under<Masking::height_correlated>},
    NamedRule{"ggx_bias_separable", bias_under<Masking::separable>},
    NamedRule{"ggx_bias_k", bias_under<Masking::schlick>},
};
constexpr std::array sheen_rules{
    NamedRule{"charlie_albedo", charlie_albedo},
    NamedRule{"imageworks_sheen_albedo", imageworks_sheen_albedo},
};

const NamedRule& rule_of(std::size_t index) {
  return index < ggx_rules.size() ? ggx_rules[index] : sheen_rules[index - ggx_rules.size()];
}

const AlbedoTable& table_of(std::size_t index) {
  static const std::vector<AlbedoTable> tables = [] {
    std::vector<AlbedoTable> result;
    for (const NamedRule& named : ggx_rules) result.emplace_back(named.rule, 2, std::vector<double>{});
    // The lobe of sheen is a function of c^2/alpha: the strip where it is analytic is half as wide. Below
    // c = 1/4 the visibility of Charlie is cut off for some lights; at c = 1 - sqrt(3)/2 for the mirrored
    // view.
    result.emplace_back(charlie_albedo, 1, std::vector{0.5, 0.25, 0.16, 1 - std::numbers::sqrt3 / 2, 0.11});
    result.emplace_back(imageworks_sheen_albedo, 1, std::vector<double>{});
    return result;
  }();
  return tables[index];
}

}  // namespace

std::optional<Albedo> find_albedo(std::string_view name) {
  for (std::size_t i = 0; i < ggx_rules.size() + sheen_rules.size(); ++i) {
    if (rule_of(i).name == name) return Albedo{i};
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
  return rule_of(albedo.index).rule(c, alpha);
}

}  // namespace shadefit
