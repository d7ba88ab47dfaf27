#pragma once

#include <array>
#include <string_view>

#include "approx/records/record.hpp"
#include "approx/records/sources.hpp"

/// Measured optical constants: the complex index of refraction n + i k of a material at a wavelength.
namespace shadefit {

struct OpticalConstants {
  std::string_view material;
  std::string_view wavelength;  ///< in nanometres, in vacuum
  std::string_view ior;         ///< n
  std::string_view extinction;  ///< k; 0 for a dielectric
  Source source;
};

/// Dielectrics, from outside: water, glass and a gem, with the usual rounded values.
inline constexpr std::array dielectrics{
    OpticalConstants{"dielectric", "", "1.33", "0", sources::born_wolf_1999},
    OpticalConstants{"dielectric", "", "1.5", "0", sources::born_wolf_1999},
    OpticalConstants{"dielectric", "", "2.0", "0", sources::born_wolf_1999},
};

/// Glass. Its reflectance at normal incidence is `reference_f0` of approx/fresnel.hpp.
inline constexpr const OpticalConstants& glass = dielectrics[1];

/// Metals, at the tabulated wavelengths nearest to 650, 550 and 450 nm.
inline constexpr std::array metals{
    OpticalConstants{"gold", "659.5", "0.14", "3.697", sources::johnson_christy_1972},
    OpticalConstants{"gold", "548.6", "0.43", "2.455", sources::johnson_christy_1972},
    OpticalConstants{"gold", "450.9", "1.38", "1.914", sources::johnson_christy_1972},
    OpticalConstants{"copper", "659.5", "0.22", "3.747", sources::johnson_christy_1972},
    OpticalConstants{"copper", "548.6", "1.02", "2.577", sources::johnson_christy_1972},
    OpticalConstants{"copper", "450.9", "1.24", "2.397", sources::johnson_christy_1972},
    OpticalConstants{"aluminium", "652.25", "1.5724", "7.7354", sources::rakic_1995},
    OpticalConstants{"aluminium", "563.57", "1.0728", "6.7839", sources::rakic_1995},
    OpticalConstants{"aluminium", "442.8", "0.6079", "5.3676", sources::rakic_1995},
};

/// Gold in green light.
inline constexpr const OpticalConstants& gold = metals[1];

}  // namespace shadefit
