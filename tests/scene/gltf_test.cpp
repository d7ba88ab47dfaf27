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
       {"anisotropy", "clearcoat", "diffuse_transmission", "dispersion", "emissive_strength", "iridescence",
        "sheen", "transmission", "volume", "unknown"})
    EXPECT_EQ(told_of(khr(name, "")), "F0 1, F90 1, n 0; KHR_materials_" + name + " is left out");
  EXPECT_EQ(scene_of_gltf(R"("extensionsUsed":["ACME_fog","KHR_materials_ior","KHR_materials_sheen",)"
                          R"("KHR_texture_transform","EXT_lights_image_based"],)"
                          R"("materials":[{"extensions":{"KHR_materials_sheen":{}}}])")
                .remarks,
            (Texts{"ACME_fog is left out", "EXT_lights_image_based is left out"}));
}

TEST(Gltf, AnimatedFactorsTakeTheirWholeRange) {
  const auto moved = [](const std::string& member, const std::string& material,
                        const std::string& path = "/materials/0/") {
    const Material read =
        scene_of_gltf(
            R"("materials":[{)" + material +
            R"(}],"animations":[{"samplers":[],"channels":[{"sampler":0,"target":{"path":"pointer",)"
            R"("extensions":{"KHR_animation_pointer":{"pointer":")" +
            path + member + R"("}}}}]}])")
            .materials.at(0);
    return told(read);
  };
  const std::string of_metal = "pbrMetallicRoughness/",
                    gloss = "extensions/KHR_materials_pbrSpecularGlossiness/";
  const std::string dull = metal(R"("roughnessFactor":1)"), is_animated = " is animated: it is taken from 0 ";
  const std::string plastic = metal(R"("metallicFactor":0)");
  const std::string all = " 0 to 1000000000 of ", limit = "; the specular power = inf is taken for 1e+09";
  const std::string dielectric =
      plastic + R"(,"extensions":{"KHR_materials_ior":{},"KHR_materials_specular":{}})";
  for (const std::string& material : {dull, std::string()})
    EXPECT_EQ(moved(of_metal + "roughnessFactor", material),
              "F0 1, F90 1, n" + all + "roughness; roughnessFactor" + is_animated + "to 1" + limit);
  EXPECT_EQ(moved(of_metal + "roughnessFactor", dull, "/materials/1/"), "F0 1, F90 1, n 0");
  EXPECT_EQ(moved(of_metal + "metallicFactor", plastic),
            "F0 0.04 to 1, F90 1, n 0; metallicFactor" + is_animated + "to 1");
  EXPECT_EQ(moved(of_metal + "baseColorFactor", ""),
            "F0 0 to 1, F90 1, n 0; baseColorFactor" + is_animated + "to 1");
  EXPECT_EQ(moved("extensions/KHR_materials_ior/ior", dielectric),
            "F0 0 to 1, F90 1, n 0; ior is animated: it is taken from 1 on");
  EXPECT_EQ(moved("extensions/KHR_materials_specular/specularFactor", dielectric),
            "F0 0 to 0.04, F90 0 to 1, n 0; specularFactor" + is_animated + "to 1");
  EXPECT_EQ(moved("extensions/KHR_materials_specular/specularColorFactor", dielectric),
            "F0 0 to 1, F90 1, n 0; specularColorFactor" + is_animated + "on");
  EXPECT_EQ(moved(gloss + "specularFactor", khr("pbrSpecularGlossiness", R"("glossinessFactor":0.5)")),
            "F0 0 to 1, F90 1, n 30; specularFactor" + is_animated + "to 1");
  EXPECT_EQ(moved(gloss + "glossinessFactor", khr("pbrSpecularGlossiness", R"("specularFactor":[0,0,0])")),
            "F0 0, F90 1, n" + all + "gloss; glossinessFactor" + is_animated + "to 1" + limit);
  EXPECT_EQ(told(scene_of_gltf(R"("materials":[{}],"animations":[{"channels":[{"sampler":0,"target":)"
                               R"({"node":0,"path":"rotation"}}]}])")
                     .materials[0]),
            "F0 1, F90 1, n 0");
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
        {three + R"(,"extensionsUsed":["MSFT_lod"],"meshes":[{"primitives":[{"material":1}]}])",
         {"a", "b", "c"},
         {}},
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

// A tolerance is for light that shows white; the sun has 1e5 lux.
TEST(Gltf, LightsAboveOneAreNamed) {
  const auto remarks = [](const std::string& lights, const std::string& more = "") {
    return scene_of_gltf(R"("extensions":{"KHR_lights_punctual":{"lights":[)" + lights + "]}}" + more)
        .remarks;
  };
  const std::string sun = R"({"type":"directional","name":"sun","intensity":100000})";
  const std::string lamp = R"({"type":"point","intensity":2.5})", dim = R"({"intensity":1})";
  EXPECT_TRUE(remarks(dim + ",{}").empty());
  EXPECT_EQ(
      remarks(sun + "," + dim + "," + lamp),
      Texts{
          "lights above 1: 'sun' (100000 lux), /extensions/KHR_lights_punctual/lights/2 (2.5 candela). The "
          "tolerance is for a light of 1, which shows white: an error of these is as many times larger before "
          "exposure"});
  const std::string of_dim = R"(,"nodes":[{"extensions":{"KHR_lights_punctual":{"light":1}}}])";
  EXPECT_TRUE(remarks(sun + "," + dim, of_dim).empty()) << "of no node";
  EXPECT_NE(remarks(lamp + "," + lamp + "," + lamp + "," + lamp + "," + lamp + "," + lamp)
                .at(0)
                .find("/3 (2.5 candela) and 2 more"),
            std::string::npos);
  const std::string moved =
      R"(,"animations":[{"channels":[{"target":{"extensions":{"KHR_animation_pointer":{"pointer":)"
      R"("/extensions/KHR_lights_punctual/lights/0/intensity"}}}}]}])";
  EXPECT_NE(remarks(dim, moved).at(0).find("(1 candela, animated)"), std::string::npos);
}

// Those of nodes, if any has one. A cycle of nodes does not matter, and geometry is not read.
TEST(Gltf, CountsLights) {
  const std::string lit = R"({"extensions":{"KHR_lights_punctual":{"light":2}}})";
  for (const auto& [nodes, count] :
       {std::pair<std::string, int>{"", 3}, {"{}", 3}, {lit, 1}, {lit + ",{}," + lit, 2}}) {
    const std::string lights = R"("extensions":{"KHR_lights_punctual":{"lights":[{},{},{}]}},"nodes":[)";
    EXPECT_EQ(scene_of_gltf(lights + nodes + "]").lights, count) << nodes;
  }
  for (const char* members : {R"("nodes":[{}])", R"("nodes":[{"children":[1]},{"children":[0,1]}])",
                              R"("accessors":{"a":[{}]},"skins":7,"materials":[{"extras":{"extras":1}}])"}) {
    EXPECT_EQ(scene_of_gltf(members).lights, 0);
    EXPECT_EQ(scene_of_gltf(members).materials.size(), 1U);
  }
}

}  // namespace
}  // namespace shadefit::scene
