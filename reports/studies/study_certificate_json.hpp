#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "fit/bounds/study_certificate.hpp"

/// Certificates as files.
///
/// Every number of a proof is text: a hexadecimal double in the spelling of `hex_text`, or for a parameter
/// the decimal as it was printed, which the proof encloses. Nothing is rounded on the way. A text must be
/// exactly what `write_study_certificate_json` writes for its content, else it is refused: no unknown field,
/// no double field, no other spelling. `digest` is the CRC-32 of all other fields, compact and in their
/// order. It finds accidents, such as a changed digit or a lost line. A false statement with a fresh digest
/// fails in `reason_to_refuse`.
namespace shadefit {

/// The size limit of a file. The most boxes take 400 kB.
inline constexpr std::uintmax_t most_certificate_bytes = 4U << 20;

/// What the file says that it is.
inline constexpr const char* study_certificate_kind = "shadefit certificate of a study";

/// The version of the file; it grows when a field changes its meaning.
inline constexpr int study_certificate_schema = 1;

/// A certificate with its digest.
nlohmann::ordered_json write_study_certificate_json(const StudyCertificate& certificate);

/// The same as the text of a file.
std::string certificate_text(const StudyCertificate& certificate);

/// The result of reading a file.
struct ReadCertificate {
  StudyCertificate certificate = {};
  std::string refused;  ///< empty; else that its digest is not that of its fields
};

/// Reads a certificate. `name` is for messages. Throws UserError with one line if `parse_own_json` refuses
/// the text, if it is not a certificate or has another version, if a field is missing, or if a field is not
/// as shadefit writes it.
ReadCertificate read_study_certificate(const std::string& text, const std::string& name);

}  // namespace shadefit
