#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fit/support/user_error.hpp"
#include "lint/tree/lint_config.hpp"

// One input is a .shadefit.toml.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shadefit;
  try {
    const auto config =
        lint::read_lint_config(std::string(reinterpret_cast<const char*>(data), size), "a/b.toml", {"wrong"});
    if (config.fail_on && *config.fail_on != "wrong") std::abort();
    if (config.max_effect && !(*config.max_effect >= 0 && std::isfinite(*config.max_effect))) std::abort();
    for (const std::string& path : config.paths)
      if (path.empty() || path.find('\0') != std::string::npos) std::abort();
  } catch (const UserError&) {
    return 0;  // refused, as bad input has to be
  }
  return 0;
}
