#include <gtest/gtest.h>

#include "scene/gltf/read_gltf.hpp"
#include "tests/scene/samples.hpp"

namespace shadefit::scene {
namespace {

using shadefit::testing::gltf_of;
using shadefit::testing::gltf_of_material;
using shadefit::testing::khr;
using shadefit::testing::metal;
using shadefit::testing::told;
using Texts = std::vector<std::string>;

Scene scene_of_gltf(const std::string& members) {
  return read_gltf(gltf_of(members), "a.gltf", {});
}

std::string told_of(const std::string& members, const Conventions& conventions = {}) {
  return told(read_gltf(gltf_of_material(members), "a.gltf", conventions).materials.at(0));
}

// Metals have their base colour, dielectrics 4 %; in between a line. A roughness r has the power 2/r^4 - 2.
TEST(Gltf, MaterialsBecomeALobeAndAFresnelTerm) {
  const std::string colour = R"("baseColorFactor":[0.8,0.4,0.04,0.5],"metallicFactor":)";
  const std::string textured = R"("baseColorTexture":{"index":7},)" + colour;
  const std::string dielectric = metal(R"("metallicFactor":0)") + ",";
  const std::string unread = "; base colour texture is not read: F0 of metal is taken from 0 to the factor";
  for (const auto& [members, text] :
       {std::pair<std::string, std::string>{"", "F0 1, F90 1, n 0"},
        {metal(R"("roughnessFactor":0.5)"), "F0 1, F90 1, n 30"},
        {metal(colour + "1"), "F0 0.8 | 0.4 | 0.04, F90 1, n 0"},
        {metal(colour + "0"), "F0 0.04, F90 1, n 0"},
        {metal(colour + "0.5"), "F0 0.42 | 0.22 | 0.04, F90 1, n 0"},
        {metal(textured + "1"), "F0 0 to 0.8 | 0 to 0.4 | 0 to 0.04, F90 1, n 0" + unread},
        {metal(textured + "0.5"), "F0 0.02 to 0.42 | 0.02 to 0.22 | 0.02 to 0.04, F90 1, n 0" + unread},
        {metal(textured + "0"), "F0 0.04, F90 1, n 0"},
        // ((2 - 1)/(2 + 1))^2; an index of 0 reflects all
        {dielectric + khr("ior", R"("ior":2)"), "F0 0.111111111111, F90 1, n 0"},
        {dielectric + khr("ior", R"("ior":0)"), "F0 1, F90 1, n 0"},
        {dielectric + khr("ior", R"("ior":1)"), "F0 0, F90 1, n 0"},
        {dielectric + khr("ior", ""), "F0 0.04, F90 1, n 0"},
        {R"("name":"sky",)" + khr("unlit", ""), "unlit, F0 0, F90 0, n 0"},
        // a gloss of 1/2 is a roughness of 1/2
        {khr("pbrSpecularGlossiness", R"("specularFactor":[0.1,0.2,0.3],"glossinessFactor":0.5)"),
         "F0 0.1 | 0.2 | 0.3, F90 1, n 30"},
        {khr("pbrSpecularGlossiness", ""),
         "F0 1, F90 1, n 1000000000; the specular power = inf is taken for 1e+09"},
        {metal(R"("roughnessFactor":0)"),
         "F0 1, F90 1, n 1000000000; the specular power = inf is taken for 1e+09"},
        {metal(R"("roughnessFactor":1e-200)"),
         "F0 1, F90 1, n 1000000000; the specular power = inf is taken for 1e+09"},
        {metal(R"("roughnessFactor":0.001)"),
         "F0 1, F90 1, n 1000000000; the specular power = 2e+12 is taken for 1e+09"}})
    EXPECT_EQ(told_of(members), text) << members;
  const Material material = read_gltf(gltf_of_material(""), "a.gltf", {}).materials.at(0);
  EXPECT_EQ(material.name, "material 0");
  EXPECT_EQ(material.file, "a.gltf");
}

// min(1/9 colour, 1) factor, and the factor at grazing angles.
TEST(Gltf, Specular) {
  const auto with = [&](const std::string& metallic, const std::string& members) {
    return told_of(metal(R"("metallicFactor":)" + metallic) +
                   R"(,"extensions":{"KHR_materials_ior":{"ior":2},"KHR_materials_specular":{)" + members +
                   "}}");
  };
  const std::string members = R"("specularFactor":0.5,"specularColorFactor":[0.9,3,90])";
  const std::string textures = R"("specularTexture":{"index":0},"specularColorTexture":{"index":0})";
  EXPECT_EQ(with("0", members), "F0 0.05 | 0.166666666667 | 0.5, F90 0.5, n 0");
  EXPECT_EQ(with("1", members), "F0 1, F90 1, n 0");
  EXPECT_EQ(with("0.5", members), "F0 0.525 | 0.583333333333 | 0.75, F90 0.75, n 0");
  EXPECT_EQ(
      with("0", members + "," + textures),
      "F0 0 to 0.05 | 0 to 0.166666666667 | 0 to 0.5, F90 0 to 0.5, n 0; specular texture is not read: F0 and "
      "F90 of dielectrics are taken from 0 to the factor; specular colour texture is not read: F0 of dielectrics "
      "is taken from 0 to the factor");
  EXPECT_EQ(
      with("0", R"("specularColorTexture":{"index":0})"),
      "F0 0 to 0.111111111111, F90 1, n 0; specular colour texture is not read: F0 of dielectrics is taken from 0 "
      "to the factor");
}

// A roughness of 0 is an infinite power; engines have a floor above 0.
TEST(Gltf, ConventionsDecideThePower) {
  const std::string glossy = khr("pbrSpecularGlossiness", R"("glossinessFactor":0.5)");
  const std::string half = metal(R"("roughnessFactor":0.5)"), smooth = metal(R"("roughnessFactor":0.01)");
  EXPECT_EQ(told_of(half, {.is_roughness_squared = false}), "F0 1, F90 1, n 6");
  EXPECT_EQ(told_of(glossy, {.is_gloss_exponential = true}), "F0 1, F90 1, n 64");
  EXPECT_EQ(told_of(smooth, {.min_roughness = 0.5}), "F0 1, F90 1, n 30");
  EXPECT_EQ(told_of(khr("pbrSpecularGlossiness", ""), {.min_roughness = 0.5}), "F0 1, F90 1, n 30");
}

TEST(Gltf, ColoursOfVerticesMakeARangeToo) {
  const Scene scene = scene_of_gltf(
      R"("materials":[{}],"meshes":[{"primitives":[{"material":0,"attributes":{"COLOR_0":1}}]}])");
  EXPECT_EQ(
      told(scene.materials.at(0)),
      "F0 0 to 1, F90 1, n 0; colours of vertices are not read: F0 of metal is taken from 0 to the factor");
}

// Transmission and emission are not part of a light's specular term, but the notes name them.
TEST(Gltf, WhatIsNotCountedIsRemarkedOn) {
  for (const std::string name :
       {"EXT_lights_image_based", "KHR_animation_pointer", "KHR_materials_anisotropy",
        "KHR_materials_clearcoat", "KHR_materials_diffuse_transmission", "KHR_materials_dispersion",
        "KHR_materials_emissive_strength", "KHR_materials_iridescence", "KHR_materials_sheen",
        "KHR_materials_transmission", "KHR_materials_volume", "MSFT_lod", "ACME fog"})
    EXPECT_EQ(
        scene_of_gltf(R"("extensionsUsed":["KHR_materials_ior","KHR_texture_transform",")" + name + "\"]")
            .remarks,
        Texts{name + " is left out"});
}

TEST(Gltf, MaterialsAreThoseThatPrimitivesHave) {
  struct Case {
    std::string members;
    Texts used, unused;
  };
  const std::string three = R"("materials":[{"name":"a"},{"name":"b"},{"name":"c"}])";
  for (const auto& [members, used, unused] :
       {Case{R"("nodes":[])", {"default"}, {}},
        {R"("materials":[],"meshes":[{"primitives":[{}]}])", {"default"}, {}},
        {three, {"a", "b", "c"}, {}},
        {three + R"(,"meshes":[{"primitives":[{"material":1},{"material":0}]}])", {"a", "b"}, {"c"}},
        {three + R"(,"meshes":[{"primitives":[{"material":1},{}]}])", {"b", "default"}, {"a", "c"}},
        {three + R"(,"meshes":[{"primitives":[{"material":1,"extensions":{"KHR_materials_variants":{)"
                 R"("mappings":[{"material":2,"variants":[0]}]}}}]}])",
         {"b", "c"},
         {"a"}},
        {three + R"(,"meshes":[])", {"a", "b", "c"}, {}},
        {three + R"(,"meshes":[{"primitives":[]}])", {"a", "b", "c"}, {}}}) {
    const Scene scene = scene_of_gltf(members);
    Texts names;
    for (const Material& material : scene.materials) names.push_back(material.name);
    EXPECT_EQ(names, used) << members;
    EXPECT_EQ(scene.unused, unused) << members;
  }
  EXPECT_EQ(told(scene_of_gltf(R"("nodes":[])").materials[0]), "F0 1, F90 1, n 0");
  EXPECT_EQ(scene_of_gltf(R"("nodes":[])").materials[0].file, "a.gltf");
}

// Those of nodes, if any has one. A tolerance is for light that shows white; the sun has 1e5 lux. A cycle of
// nodes does not matter, and geometry is not read.
TEST(Gltf, CountsLightsAndThoseAboveOne) {
  const std::string lights =
      R"("extensions":{"KHR_lights_punctual":{"lights":[{"intensity":100000},{"intensity":1},{"intensity":2}]}},)";
  const auto lit = [](int light) {
    return R"({"extensions":{"KHR_lights_punctual":{"light":)" + std::to_string(light) + "}}}";
  };
  struct Case {
    std::string nodes;
    int count;
    std::string bright;
  };
  for (const auto& [nodes, count, bright] :
       {Case{"", 3, "2"}, {"{}", 3, "2"}, {lit(1), 1, ""}, {lit(2) + ",{}," + lit(2), 2, "1"}}) {
    const Scene scene = scene_of_gltf(lights + R"("nodes":[)" + nodes + "]");
    EXPECT_EQ(scene.lights, count) << nodes;
    EXPECT_EQ(scene.remarks.size(), bright.empty() ? 0U : 1U) << nodes;
    for (const std::string& remark : scene.remarks)
      EXPECT_TRUE(remark.starts_with("lights above 1: " + bright + " of 3. The tolerance is ")) << remark;
  }
  for (const char* members : {R"("nodes":[{}])", R"("nodes":[{"children":[1]},{"children":[0,1]}])",
                              R"("accessors":{"a":[{}]},"skins":7,"materials":[{"extras":{"extras":1}}])"}) {
    EXPECT_EQ(scene_of_gltf(members).lights, 0);
    EXPECT_EQ(scene_of_gltf(members).materials.size(), 1U);
  }
}

}  // namespace
}  // namespace shadefit::scene
