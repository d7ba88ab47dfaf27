#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "fit/bounds/study_certificate.hpp"
#include "reports/io/table.hpp"

/// Proofs of studies, as rows, as JSON and in words. Bounds are doubles, rounded outward. Their decimals
/// read back exactly.
namespace shadefit {

/// A proof; `from` is the origin of its constants: given or fitted.
struct ProvenStudy {
  CertifiedStudy certified;
  std::string_view from;
};

/// "sqrt(1-x) (a + b x) ~ acos(x), x in 0:1, absolute error, proven in 168 bits".
OthersText proof_headline(const StudyCertificate& certificate);

/// A row for each proof: the given constants, the parameters, the bounds, the place and the boxes. The
/// studies differ in their given constants alone.
Table study_proofs_table(const std::vector<ProvenStudy>& proofs);

/// A line for each end of a range that is not the number that was asked for, but the double nearest to it.
std::string ends_text(const StudyCertificate& certificate);

/// A proof without its boxes.
nlohmann::ordered_json study_proof_json(const ProvenStudy& proof);

/// Adds the proven bounds to the JSON of a fit: `certified_max_error`, `certified_max_error_at`, `boxes`.
void add_study_proof(nlohmann::ordered_json& fit, const ProvenStudy& proof);

/// What a certificate states, a line for each fact.
std::string statement_of(const StudyCertificate& certificate);

}  // namespace shadefit
