#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/quadrature/metric.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/support/decimal.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"

/// The stored reference values, made by the programs beside them: fits.csv by power series, integrals.csv by
/// tanh-sinh.
namespace shadefit::testing {

struct Reference {
  std::string constant, parameter, measure;
  std::optional<double> exponent;
  std::string domain;
  Decimal50 value;

  Metric metric() const {
    Metric metric;
    for (const Measure known : measures) {
      if (measure == name(known)) metric.measure = known;
    }
    const auto colon = domain.find(':');
    metric.domain = {*parse_number(domain.substr(0, colon)), *parse_number(domain.substr(colon + 1))};
    return metric;
  }

  std::string describe() const {
    return constant + " " + parameter + (exponent ? " " + std::to_string(*exponent) : "") + " " + measure +
           " " + domain;
  }
};

inline std::vector<Reference> read_references() {
  std::vector<Reference> references;
  const std::string directory = SHADEFIT_SOURCE_DIR "/tests/references/";
  for (const auto& row : parse_csv(read_file(directory + "fits.csv"), "fits.csv").rows) {
    references.push_back({row[0], row[1], row[3], parse_number(row[2]), "0:1", Decimal50(row[4])});
  }
  for (const auto& row : parse_csv(read_file(directory + "integrals.csv"), "integrals.csv").rows) {
    references.push_back({row[0], row[1], row[3], parse_number(row[2]), row[4], Decimal50(row[5])});
  }
  return references;
}

}  // namespace shadefit::testing
