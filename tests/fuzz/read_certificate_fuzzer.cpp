#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fit/support/user_error.hpp"
#include "reports/studies/study_certificate_json.hpp"

// One input is a certificate: refused, or read back as it was written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shadefit;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const std::string written = certificate_text(read_study_certificate(text, "a").certificate);
    const ReadCertificate again = read_study_certificate(written, "a");
    if (!again.refused.empty() || certificate_text(again.certificate) != written) std::abort();
  } catch (const UserError&) {
    return 0;  // refused, as bad input has to be
  }
  return 0;
}
