#pragma once

#include "approx/records/record.hpp"

/// The publications that the records cite; those of claims alone are in studies/claims/sources.toml.
namespace shadefit::sources {

inline constexpr Source johnson_christy_1972{
    "Johnson, Christy", 1972, "Optical Constants of the Noble Metals", "Physical Review B 6, pp. 4370-4379",
    "https://doi.org/10.1103/PhysRevB.6.4370"};

inline constexpr Source rakic_1995{
    "Rakic", 1995,
    "Algorithm for the determination of intrinsic optical constants of metal films: application to aluminum",
    "Applied Optics 34, pp. 4755-4767", "https://doi.org/10.1364/AO.34.004755"};

inline constexpr Source born_wolf_1999{"Born, Wolf", 1999, "Principles of Optics",
                                       "7th edition, Cambridge University Press",
                                       "https://doi.org/10.1017/CBO9781139644181"};

inline constexpr Source lagarde_2011_adopting{"Lagarde", 2011, "Adopting a physically based shading model",
                                              "seblagarde.wordpress.com/2011/08/17/hello-world"};

inline constexpr Source lagarde_2012{
    "Lagarde", 2012, "Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel",
    "seblagarde.wordpress.com/2012/06/03/spherical-gaussien-approximation-for-blinn-phong-phong-and-fresnel"};

}  // namespace shadefit::sources
