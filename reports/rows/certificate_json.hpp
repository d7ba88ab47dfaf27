#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "fit/proof/certificate.hpp"

/// Certificates as files.
///
/// Every number that a proof rests on is text: a hexadecimal double, in the one spelling that `hex_text`
/// gives it; of a parameter also a decimal as it was printed, which the proof encloses. Nothing is rounded on
/// the way. What is read is what `write_certificate_json` writes of it, or it is refused: no field is
/// unknown, doubled, or said in another way. `digest` is the CRC-32 of all other fields, compact and in their
/// order. It is for accidents, a changed digit or a lost line; whoever recomputes it over a false statement
/// meets the mathematics of `reason_to_refuse`.
namespace shadefit {

/// The version of the file; it rises when a field changes its meaning.
inline constexpr int certificate_schema = 1;

/// What a file may have. A proof cuts a domain into 26 000 boxes at most (`most_boxes`, `most_curve_boxes`),
/// which take 3 MB.
inline constexpr std::uintmax_t most_certificate_bytes = 4U << 20;

/// A certificate with its digest.
nlohmann::ordered_json write_certificate_json(const Certificate& certificate);

/// The same as the text of a file.
std::string certificate_text(const Certificate& certificate);

/// The result of reading a file: a certificate, or the reason to refuse it.
struct ReadCertificate {
  Certificate certificate;
  std::string refused;  ///< empty; else that its digest is not that of its fields
};

/// Reads a certificate. `name` is for messages. Throws UserError, a line, for a text that `parse_own_json`
/// refuses, is no certificate, is one of another version, lacks a field, or has one that is not as shadefit
/// writes it.
ReadCertificate read_certificate(const std::string& text, const std::string& name);

}  // namespace shadefit
