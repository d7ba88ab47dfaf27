#include "fit/verdicts/published_curve.hpp"

#include <algorithm>
#include <stdexcept>

#include "approx/ledger/catalogue.hpp"

namespace shadefit {

std::vector<const Published*> numbers_of(const Family& family) {
  std::vector<const Published*> numbers;
  for (const Published& published : published_constants) {
    if (published.family == family.id) numbers.push_back(&published);
  }
  return numbers;
}

std::vector<std::pair<std::string_view, std::string_view>> printed_parameters(const FittableFamily& family,
                                                                              const Published& published) {
  std::vector<std::pair<std::string_view, std::string_view>> parameters;
  for (const std::string_view parameter : family.parameters) {
    if (parameter == published.parameter) {
      parameters.emplace_back(parameter, published.printed);
      continue;
    }
    const auto found =
        std::find_if(published_constants.begin(), published_constants.end(), [&](const Published& other) {
          return other.family == published.family && other.parameter == parameter &&
                 other.source.place == published.source.place && other.statement == published.statement &&
                 other.convention.name == published.convention.name;
        });
    if (found == published_constants.end()) throw std::logic_error("a published curve lacks a parameter");
    parameters.emplace_back(parameter, found->printed);
  }
  return parameters;
}

std::vector<double> published_parameters(const FittableFamily& family, const Published& published) {
  std::vector<double> values;
  for (const auto& parameter : printed_parameters(family, published))
    values.push_back(constant<double>(parameter.second));
  return values;
}

}  // namespace shadefit
