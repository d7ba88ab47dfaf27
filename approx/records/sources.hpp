#pragma once

#include "approx/records/record.hpp"

/// The publications that the records cite.
namespace shadefit::sources {

inline constexpr Source henyey_greenstein_1941{"Henyey, Greenstein", 1941, "Diffuse Radiation in the Galaxy",
                                               "The Astrophysical Journal 93, pp. 70-83",
                                               "https://doi.org/10.1086/144246"};

inline constexpr Source johnson_christy_1972{
    "Johnson, Christy", 1972, "Optical Constants of the Noble Metals", "Physical Review B 6, pp. 4370-4379",
    "https://doi.org/10.1103/PhysRevB.6.4370"};

inline constexpr Source fisher_woo_1994{"Fisher, Woo", 1994, "R.E versus N.H Specular Highlights",
                                        "Graphics Gems IV, Academic Press, pp. 388-400"};

inline constexpr Source rakic_1995{
    "Rakic", 1995,
    "Algorithm for the determination of intrinsic optical constants of metal films: application to aluminum",
    "Applied Optics 34, pp. 4755-4767", "https://doi.org/10.1364/AO.34.004755"};

inline constexpr Source born_wolf_1999{"Born, Wolf", 1999, "Principles of Optics",
                                       "7th edition, Cambridge University Press",
                                       "https://doi.org/10.1017/CBO9781139644181"};

inline constexpr Source walter_2007{
    "Walter, Marschner, Li, Torrance", 2007, "Microfacet Models for Refraction through Rough Surfaces",
    "Eurographics Symposium on Rendering 2007, pp. 195-206", "https://doi.org/10.2312/EGWR/EGSR07/195-206"};

inline constexpr Source gotanda_2010{
    "Gotanda", 2010, "Practical Implementation of Physically-Based Shading Models at tri-Ace",
    "SIGGRAPH 2010 course, Physically-Based Shading Models in Film and Game Production",
    "http://renderwonk.com/publications/s2010-shading-course/gotanda/course_note_practical_implementation_at_triace.pdf"};

inline constexpr Source lagarde_2011_adopting{"Lagarde", 2011, "Adopting a physically based shading model",
                                              "seblagarde.wordpress.com/2011/08/17/hello-world"};

inline constexpr Source lagarde_2012_phong_blinn{
    "Lagarde", 2012, "Relationship between Phong and Blinn lighting model", "seblagarde.wordpress.com"};

inline constexpr Source lagarde_2011_buffer{"Lagarde", 2011, "Dive in SH buffer idea",
                                            "seblagarde.wordpress.com"};

inline constexpr Source lagarde_2011_feeding{
    "Lagarde", 2011, "Feeding a physically based shading model",
    "seblagarde.wordpress.com/2011/08/17/feeding-a-physical-based-lighting-mode"};

inline constexpr Source lagarde_2012_chart{
    "Lagarde", 2012, "DONTNOD specular and glossiness chart",
    "seblagarde.wordpress.com/2012/04/30/dontnod-specular-and-glossiness-chart"};

inline constexpr Source lagarde_2012_pi{
    "Lagarde", 2012, "PI or not to PI in game lighting equation",
    "seblagarde.wordpress.com/2012/01/08/pi-or-not-to-pi-in-game-lighting-equation"};

inline constexpr Source lagarde_2012{
    "Lagarde", 2012, "Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel",
    "seblagarde.wordpress.com/2012/06/03/spherical-gaussien-approximation-for-blinn-phong-phong-and-fresnel"};

/// The post of 2012 before its corrections.
inline constexpr Source lagarde_2012_first{
    "Lagarde", 2012, "Spherical gaussien approximation for Blinn-Phong, Phong and Fresnel (first version)",
    "seblagarde.wordpress.com/2012/06/03/spherical-gaussien-approximation-for-blinn-phong-phong-and-fresnel"};

inline constexpr Source lagarde_2012_cubemapgen{
    "Lagarde", 2012, "AMD Cubemapgen for physically based rendering",
    "seblagarde.wordpress.com/2012/06/10/amd-cubemapgen-for-physically-based-rendering"};

inline constexpr Source burley_2012{
    "Burley", 2012, "Physically-Based Shading at Disney",
    "SIGGRAPH 2012 course, Practical Physically-Based Shading in Film and Game Production",
    "http://blog.selfshadow.com/publications/s2012-shading-course/"};

inline constexpr Source karis_2013{"Karis", 2013, "Specular BRDF Reference",
                                   "graphicrants.blogspot.com/2013/08/specular-brdf-reference.html"};

inline constexpr Source mcguire_2013{"McGuire, Evangelakos, Wilcox, Donow, Mara", 2013,
                                     "Plausible Environment Lighting in Two Lines of Code",
                                     "graphics.cs.williams.edu/papers/EnvMipReport2013"};

inline constexpr Source heitz_2014{
    "Heitz", 2014, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs",
    "Journal of Computer Graphics Techniques 3(2), pp. 48-107", "http://jcgt.org/published/0003/02/03/"};

inline constexpr Source pestana_workflows_2014{
    "Pestana", 2014, "Physically Based Shading, Metallic and Specular workflows", "alexandre-pestana.com"};

inline constexpr Source pestana_volumes_2014{"Pestana", 2014, "Volumetric lights",
                                             "alexandre-pestana.com/volumetric-lights"};

}  // namespace shadefit::sources
