#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "fit/study_proof/study_certificate.hpp"
#include "reports/rows/certificate_json.hpp"

/// Certificates of studies as files. The rules are those of reports/rows/certificate_json.hpp: hexadecimal
/// doubles, exactly the fields and the spelling that `write_study_certificate_json` writes, a digest. The
/// size limit is the same: the most boxes take 400 kB.
namespace shadefit {

/// The version of the file; it grows when a field changes its meaning.
inline constexpr int study_certificate_schema = 1;

/// A certificate with its digest.
nlohmann::ordered_json write_study_certificate_json(const StudyCertificate& certificate);

/// The same as the text of a file.
std::string certificate_text(const StudyCertificate& certificate);

/// Whether a text says that it is a certificate of a study. Throws UserError if `parse_own_json` refuses it.
bool is_study_certificate(const std::string& text, const std::string& name);

/// Reads a certificate. `name` is for messages. Throws UserError with one line as `read_certificate` does.
ReadCertificate<StudyCertificate> read_study_certificate(const std::string& text, const std::string& name);

}  // namespace shadefit
