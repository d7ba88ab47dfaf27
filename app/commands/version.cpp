#include <ceres/version.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <jpeglib.h>
#include <mpfi.h>
#include <png.h>
#include <zlib.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include "app/commands/declare_commands.hpp"

namespace shadefit {
namespace {

/// "1.74.0" of 107400, the place values of Boost; fmt and libjpeg-turbo have others.
std::string version_of(int number, int major, int minor) {
  return fmt::format("{}.{}.{}", number / major, number % major / minor, number % minor);
}

template <typename... Part>
std::string version_of_parts(Part... part) {
  return fmt::format("{}", fmt::join({part...}, "."));
}

}  // namespace

std::string libraries_inside() {
  return fmt::format(
      "with Boost {}, Ceres {}, CLI11 {}, Eigen {}, fmt {}, GMP {}, libjpeg-turbo {}, libpng {}, libstdc++ {}, MPFI {}, MPFR {}, "
      "nlohmann/json {}, toml++ {}, zlib {}",
      version_of(BOOST_VERSION, 100000, 100), CERES_VERSION_STRING, CLI11_VERSION,
      version_of_parts(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION),
      version_of(FMT_VERSION, 10000, 100), gmp_version,
      version_of(LIBJPEG_TURBO_VERSION_NUMBER, 1000000, 1000), PNG_LIBPNG_VER_STRING, _GLIBCXX_RELEASE,
      mpfi_get_version(), mpfr_get_version(),
      version_of_parts(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH),
      SHADEFIT_TOML_VERSION, ZLIB_VERSION);
}

}  // namespace shadefit
