#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "fit/better/fit_extras.hpp"
#include "reports/table/table.hpp"

/// The proofs of forms and fits, as rows and as JSON. Bounds are doubles, rounded outward. Their decimals
/// read back exactly.
namespace shadefit {

/// One row for each fit.
Table proofs_table(const Refit& refit, const std::vector<FitProof>& proofs);

/// Appends to the JSON of a fit: `certified_max_abs_error`, the `.._at` it may be, `curve`,
/// `stationary_point`.
void add_proof_json(nlohmann::ordered_json& fit_json, const FittableFamily& family, const FitProof& proof);

/// A line for each fit whose bounds are wider than requested.
std::string not_reached_lines(const Refit& refit, const std::vector<FitProof>& proofs);

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
