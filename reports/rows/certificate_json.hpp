#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fit/proof/certificate.hpp"

/// Certificates as files.
///
/// Every number of a proof is text: a hexadecimal double in the spelling of `hex_text`, or for a parameter
/// the decimal as it was printed, which the proof encloses. Nothing is rounded on the way. A text must be
/// exactly what `write_certificate_json` writes for its content, else it is refused: no unknown field, no
/// double field, no other spelling. `digest` is the CRC-32 of all other fields, compact and in their order.
/// It finds accidents, such as a changed digit or a lost line. A false statement with a fresh digest fails in
/// `reason_to_refuse`.
namespace shadefit {

/// The version of the file; it grows when a field changes its meaning.
inline constexpr int certificate_schema = 1;

/// The size limit of a file. A proof has at most 26 000 boxes (`most_boxes`, `most_curve_boxes`), which take
/// 3 MB.
inline constexpr std::uintmax_t most_certificate_bytes = 4U << 20;

/// The kinds of errors by their names in files.
inline const std::vector<std::pair<std::string_view, Error>> named_errors{
    {name(Error::absolute), Error::absolute}, {name(Error::relative), Error::relative}};

/// Numbers as `hex_text` writes them.
nlohmann::ordered_json hex_list(const std::vector<double>& values);

/// A certificate with its digest.
nlohmann::ordered_json write_certificate_json(const Certificate& certificate);

/// The same as the text of a file.
std::string certificate_text(const Certificate& certificate);

/// The result of reading a file: a certificate, of a family or a study, or the reason to refuse it.
template <class AnyCertificate>
struct ReadCertificate {
  AnyCertificate certificate = {};
  std::string refused;  ///< empty; else that its digest is not that of its fields
};

/// Reads a certificate. `name` is for messages. Throws UserError with one line if `parse_own_json` refuses
/// the text, if it is not a certificate or has another version, if a field is missing, or if a field is not
/// as shadefit writes it.
ReadCertificate<Certificate> read_certificate(const std::string& text, const std::string& name);

}  // namespace shadefit
