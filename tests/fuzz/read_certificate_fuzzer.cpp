#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fit/support/user_error.hpp"
#include "reports/rows/certificate_json.hpp"

// One input is a certificate: refused, or read back as it was written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shadefit;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const Certificate certificate = read_certificate(text, "a").certificate;
    const ReadCertificate again = read_certificate(certificate_text(certificate), "a");
    if (!again.refused.empty() || !(again.certificate == certificate)) std::abort();
  } catch (const UserError&) {
    return 0;  // refused, as bad input has to be
  }
  return 0;
}
