#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/multiprecision.hpp"
#include "fit/sweep.hpp"
#include "reports/csv.hpp"
#include "reports/files.hpp"

/// The stored 50-digit reference values, made by tests/references/make_references.cpp.
namespace shadefit::testing {

struct Reference {
  std::string constant, parameter, measure;
  std::optional<double> exponent;
  Decimal50 value;

  std::string describe() const {
    return constant + " " + parameter + (exponent ? " " + std::to_string(*exponent) : "") + " " + measure;
  }
};

inline std::vector<Reference> read_references() {
  const std::string path = SHADEFIT_SOURCE_DIR "/tests/references/fits.csv";
  std::vector<Reference> references;
  for (const auto& row : parse_csv(read_file(path), path).rows) {
    references.push_back({row[0], row[1], row[3], parse_number(row[2]), Decimal50(row[4])});
  }
  return references;
}

}  // namespace shadefit::testing
