#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "fit/fit.hpp"
#include "fit/proof/certificate.hpp"
#include "reports/table/table.hpp"

/// The proofs of forms, as rows and as JSON. Bounds are doubles, rounded outward. Their decimals
/// read back exactly.
namespace shadefit {

/// A form with constants and its proofs; `from` is their origin: given, published or fitted.
struct CertifiedForm {
  Certified certified;
  std::string_view from;
};

/// One row for each form of a family.
Table certificates_table(const FittableFamily& family, const std::vector<CertifiedForm>& forms);

/// A form's bounds, without the boxes of its certificate.
nlohmann::ordered_json write_certified_json(const CertifiedForm& form);

}  // namespace shadefit
