#include <gtest/gtest.h>

#include <cmath>

#include "scene/gltf/read_gltf.hpp"
#include "tests/scene/samples.hpp"

namespace shadefit::scene {
namespace {

using shadefit::testing::gltf_of;
using shadefit::testing::gltf_of_material;

Material material_of(const std::string& members, const Conventions& conventions = {}) {
  return read_gltf(gltf_of_material(members), "a.gltf", conventions).materials.at(0);
}

void expect_f0(const Material& material, const std::array<Range, 3>& f0) {
  for (std::size_t i = 0; i < f0.size(); ++i) {
    EXPECT_NEAR(material.f0[i].least, f0[i].least, 1e-15) << i;
    EXPECT_NEAR(material.f0[i].most, f0[i].most, 1e-15) << i;
  }
}

void expect_power(const Material& material, double power) {
  ASSERT_EQ(material.powers.size(), 1u);
  EXPECT_NEAR(material.powers[0].power, power, 1e-12 * power);
  EXPECT_EQ(material.powers[0].share, 1);
  EXPECT_FALSE(material.is_power_textured());
}

constexpr std::array<Range, 3> white{Range{1, 1}, Range{1, 1}, Range{1, 1}};

TEST(Gltf, NothingSaidIsTheSpecificationsDefault) {
  const Material material = material_of("");
  EXPECT_EQ(material.name, "material 0");
  EXPECT_EQ(material.file, "a.gltf");
  EXPECT_EQ(material.fresnel, FresnelTerm::schlick);
  expect_f0(material, white);
  expect_power(material, 0);
  EXPECT_TRUE(material.unknowns.empty());
  EXPECT_TRUE(material.remarks.empty());
}

// 2/alpha^2 - 2 at alpha = 1/4 is 30, at 1/2 it is 6.
TEST(Gltf, RoughnessBecomesAPower) {
  const std::string half = R"("pbrMetallicRoughness":{"roughnessFactor":0.5})";
  expect_power(material_of(half), 30);
  expect_power(material_of(half, {.is_roughness_squared = false}), 6);
}

TEST(Gltf, SmoothIsTheMostPowerWithARemark) {
  for (const char* roughness : {"0", "1e-200", "0.001"}) {
    const Material material =
        material_of(std::string(R"("pbrMetallicRoughness":{"roughnessFactor":)") + roughness + "}");
    expect_power(material, most_power);
    ASSERT_EQ(material.remarks.size(), 1u);
  }
  EXPECT_EQ(material_of(R"("pbrMetallicRoughness":{"roughnessFactor":0})").remarks[0],
            "the specular power = inf is taken for 1e+09");
  EXPECT_EQ(material_of(R"("pbrMetallicRoughness":{"roughnessFactor":0.001})").remarks[0],
            "the specular power = 2e+12 is taken for 1e+09");
}

// Metals have their base colour, dielectrics 4 %; in between a line.
TEST(Gltf, MetallicMixesLinearly) {
  const auto with = [&](const std::string& metallic) {
    return material_of(R"("pbrMetallicRoughness":{"baseColorFactor":[0.8,0.4,0.04,0.5],"metallicFactor":)" +
                       metallic + "}");
  };
  expect_f0(with("1"), {Range{0.8, 0.8}, Range{0.4, 0.4}, Range{0.04, 0.04}});
  expect_f0(with("0"), {Range{0.04, 0.04}, Range{0.04, 0.04}, Range{0.04, 0.04}});
  expect_f0(with("0.5"), {Range{0.42, 0.42}, Range{0.22, 0.22}, Range{0.04, 0.04}});
}

TEST(Gltf, BaseColourTextureMakesARangeOfMetalsAlone) {
  const auto with = [&](const std::string& metallic) {
    return material_of(
        R"("pbrMetallicRoughness":{"baseColorFactor":[0.8,0.4,0.2,1],"baseColorTexture":{"index":7},)"
        R"("metallicFactor":)" +
        metallic + "}");
  };
  expect_f0(with("1"), {Range{0, 0.8}, Range{0, 0.4}, Range{0, 0.2}});
  EXPECT_EQ(
      with("1").unknowns,
      std::vector<std::string>{"base colour texture is not read: F0 of metal is taken from 0 to the factor"});
  expect_f0(with("0.5"), {Range{0.02, 0.42}, Range{0.02, 0.22}, Range{0.02, 0.12}});
  expect_f0(with("0"), {Range{0.04, 0.04}, Range{0.04, 0.04}, Range{0.04, 0.04}});
  EXPECT_TRUE(with("0").unknowns.empty());
}

TEST(Gltf, ColoursOfVerticesMakeARangeToo) {
  const Scene scene = read_gltf(
      gltf_of(R"("materials":[{}],"meshes":[{"primitives":[{"material":0,"attributes":{"COLOR_0":1}}]}])"),
      "a.gltf", {});
  ASSERT_EQ(scene.materials.size(), 1u);
  expect_f0(scene.materials[0], {Range{0, 1}, Range{0, 1}, Range{0, 1}});
  EXPECT_EQ(scene.materials[0].unknowns,
            std::vector<std::string>{
                "colours of vertices are not read: F0 of metal is taken from 0 to the factor"});
}

// ((2 - 1)/(2 + 1))^2 = 1/9; an index of 0 reflects all.
TEST(Gltf, IndexOfRefraction) {
  const auto with = [&](const std::string& ior) {
    return material_of(R"("pbrMetallicRoughness":{"metallicFactor":0},"extensions":{"KHR_materials_ior":{)" +
                       ior + "}}");
  };
  const Range ninth{1.0 / 9, 1.0 / 9}, glass{0.04, 0.04};
  expect_f0(with(R"("ior":2)"), {ninth, ninth, ninth});
  expect_f0(with(R"("ior":0)"), white);
  expect_f0(with(R"("ior":1)"), {});
  expect_f0(with(""), {glass, glass, glass});
}

// min(1/9 colour, 1) factor, and the factor at grazing angles.
TEST(Gltf, Specular) {
  const auto with = [&](const std::string& metallic, const std::string& members) {
    return material_of(R"("pbrMetallicRoughness":{"metallicFactor":)" + metallic +
                       R"(},"extensions":{"KHR_materials_ior":{"ior":2},"KHR_materials_specular":{)" +
                       members + "}}");
  };
  const std::string members = R"("specularFactor":0.5,"specularColorFactor":[0.9,3,90])";
  expect_f0(with("0", members), {Range{0.05, 0.05}, Range{1 / 6.0, 1 / 6.0}, Range{0.5, 0.5}});
  EXPECT_EQ(with("0", members).f90, (Range{0.5, 0.5}));
  expect_f0(with("1", members), white);
  EXPECT_EQ(with("1", members).f90, (Range{1, 1}));
  EXPECT_EQ(with("0.5", members).f90, (Range{0.75, 0.75}));
  const std::string textured =
      members + R"(,"specularTexture":{"index":0},"specularColorTexture":{"index":0})";
  const Material material = with("0", textured);
  expect_f0(material, {Range{0, 0.05}, Range{0, 1 / 6.0}, Range{0, 0.5}});
  EXPECT_EQ(material.f90, (Range{0, 0.5}));
  EXPECT_EQ(material.unknowns,
            (std::vector<std::string>{
                "specular texture is not read: F0 and F90 of dielectrics are taken from 0 to the factor",
                "specular colour texture is not read: F0 of dielectrics is taken from 0 to the factor"}));
  EXPECT_EQ(with("0", R"("specularColorTexture":{"index":0})").f90, (Range{1, 1}));
}

TEST(Gltf, UnlitHasNoReflectance) {
  const Material material = material_of(R"("name":"sky","extensions":{"KHR_materials_unlit":{}})");
  EXPECT_TRUE(material.is_unlit);
  EXPECT_EQ(material.name, "sky");
  expect_f0(material, {});
  EXPECT_EQ(material.f90, (Range{0, 0}));
  expect_power(material, 0);
}

// A gloss of 1/2 is a roughness of 1/2, or the power 2^6.
TEST(Gltf, SpecularGlossiness) {
  const std::string members =
      R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{"specularFactor":[0.1,0.2,0.3],"glossinessFactor":0.5}})";
  const Material material = material_of(members);
  expect_f0(material, {Range{0.1, 0.1}, Range{0.2, 0.2}, Range{0.3, 0.3}});
  EXPECT_EQ(material.f90, (Range{1, 1}));
  expect_power(material, 30);
  expect_power(material_of(members, {.is_gloss_exponential = true}), 64);
  const Material unsaid = material_of(R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{}})");
  expect_f0(unsaid, white);
  expect_power(unsaid, most_power);
}

TEST(Gltf, OtherLobesAreRemarkedOn) {
  EXPECT_EQ(
      material_of(R"("extensions":{"KHR_materials_sheen":{},"KHR_materials_clearcoat":{},"X":{}})").remarks,
      (std::vector<std::string>{"KHR_materials_clearcoat is left out", "KHR_materials_sheen is left out",
                                "X is left out"}));
}

// Transmission and emission are not part of a light's specular term, but the notes name them.
TEST(Gltf, WhatIsNotCountedIsRemarkedOn) {
  for (const std::string name :
       {"KHR_materials_anisotropy", "KHR_materials_diffuse_transmission", "KHR_materials_dispersion",
        "KHR_materials_emissive_strength", "KHR_materials_iridescence", "KHR_materials_transmission",
        "KHR_materials_volume"}) {
    const std::string members = R"("extensions":{")" + name + R"(":{}})";
    EXPECT_EQ(material_of(members).remarks, std::vector<std::string>{name + " is left out"});
  }
  EXPECT_TRUE(
      material_of(R"("extensions":{"KHR_materials_ior":{},"KHR_materials_specular":{}})").remarks.empty());
  const Scene scene = read_gltf(
      gltf_of(
          R"("extensionsUsed":["ACME_fog","KHR_materials_ior","KHR_materials_sheen","KHR_texture_transform",)"
          R"("EXT_lights_image_based"],"materials":[{"extensions":{"KHR_materials_sheen":{}}}])"),
      "a.gltf", {});
  EXPECT_EQ(scene.remarks,
            (std::vector<std::string>{"ACME_fog is left out", "EXT_lights_image_based is left out"}));
}

/// A document with one material and an animation of a member of it.
std::string animated_gltf(const std::string& member, const std::string& material,
                          const std::string& path = "/materials/0/") {
  return gltf_of(R"("materials":[{)" + material +
                 R"(}],"animations":[{"samplers":[],"channels":[{"sampler":0,"target":{"path":"pointer",)"
                 R"("extensions":{"KHR_animation_pointer":{"pointer":")" +
                 path + member + R"("}}}}]}])");
}

TEST(Gltf, AnAnimatedRoughnessTakesItsWholeRange) {
  const std::string dull = R"("pbrMetallicRoughness":{"roughnessFactor":1})";
  const std::string member = "pbrMetallicRoughness/roughnessFactor";
  for (const std::string& material : {dull, std::string()}) {
    const Material moved = read_gltf(animated_gltf(member, material), "a.gltf", {}).materials.at(0);
    EXPECT_EQ(moved.powers.front().power, 0);
    EXPECT_EQ(moved.powers.back().power, most_power);
    EXPECT_EQ(moved.power_texture, PowerTexture::roughness);
    EXPECT_EQ(moved.unknowns,
              std::vector<std::string>{"roughnessFactor is animated: it is taken from 0 to 1"});
  }
  expect_power(read_gltf(animated_gltf(member, dull, "/materials/1/"), "a.gltf", {}).materials.at(0), 0);
  const std::string of_node =
      R"("animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"rotation"}}]}])";
  EXPECT_TRUE(
      read_gltf(gltf_of(R"("materials":[{}],)" + of_node), "a.gltf", {}).materials[0].unknowns.empty());
}

TEST(Gltf, OtherAnimatedFactorsTakeTheirWholeRangeToo) {
  const auto moved = [](const std::string& member, const std::string& material) {
    const Material read = read_gltf(animated_gltf(member, material), "a.gltf", {}).materials.at(0);
    EXPECT_EQ(read.unknowns.size(), 1U) << member;
    return read;
  };
  constexpr Range all{0, 1};
  const std::string plastic = R"("pbrMetallicRoughness":{"metallicFactor":0,"baseColorFactor":[1,0,0,1]})";
  const Material metal = moved("pbrMetallicRoughness/metallicFactor", plastic);
  EXPECT_NEAR(metal.f0[0].least, 0.04, 1e-12);
  EXPECT_EQ(metal.f0[0].most, 1);
  const Material gold = moved("pbrMetallicRoughness/baseColorFactor", "");
  EXPECT_EQ(gold.f0[1], all);
  EXPECT_TRUE(gold.has_unread_colours);
  const std::string dielectric =
      R"("pbrMetallicRoughness":{"metallicFactor":0},"extensions":{"KHR_materials_ior":{},"KHR_materials_specular":{}})";
  EXPECT_EQ(moved("extensions/KHR_materials_ior/ior", dielectric).f0[0], all);
  const Material specular = moved("extensions/KHR_materials_specular/specularFactor", dielectric);
  EXPECT_NEAR(specular.f0[0].most, 0.04, 1e-12);
  EXPECT_EQ(specular.f90, all);
  EXPECT_EQ(moved("extensions/KHR_materials_specular/specularColorFactor", dielectric).f0[0], all);
  const std::string glossy =
      R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{"specularFactor":[0,0,0]}})";
  const std::string path = "extensions/KHR_materials_pbrSpecularGlossiness/";
  EXPECT_EQ(moved(path + "specularFactor", glossy).f0[2], all);
  const Material gloss = moved(path + "glossinessFactor", glossy);
  EXPECT_EQ(gloss.powers.front().power, 0);
  EXPECT_EQ(gloss.power_texture, PowerTexture::gloss);
}

// A roughness of 0 is an infinite power; engines have a floor above 0.
TEST(Gltf, ASmallRoughnessIsTakenForTheLeast) {
  const std::string smooth = R"("pbrMetallicRoughness":{"roughnessFactor":0.01})";
  const double alpha = 0.0525 * 0.0525;
  const Material floored = material_of(smooth, {.min_roughness = 0.0525});
  expect_power(floored, 2 / (alpha * alpha) - 2);
  EXPECT_TRUE(floored.remarks.empty());
  const std::string glossy = R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{"glossinessFactor":1}})";
  expect_power(material_of(glossy, {.min_roughness = 0.0525}), 2 / (alpha * alpha) - 2);
}

TEST(Gltf, TheDefaultMaterialIsThereWhereItIsUsed) {
  const auto names = [&](const std::string& members) {
    std::vector<std::string> found;
    for (const Material& material : read_gltf(gltf_of(members), "a.gltf", {}).materials)
      found.push_back(material.name);
    return found;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(R"("nodes":[])"), Names{"default"});
  EXPECT_EQ(names(R"("materials":[],"meshes":[{"primitives":[{}]}])"), Names{"default"});
  const std::string two = R"("materials":[{"name":"a"},{"name":"a"}])";
  EXPECT_EQ(names(two), (Names{"a", "a"}));
  EXPECT_EQ(names(two + R"(,"meshes":[{"primitives":[{"material":1},{"material":0}]}])"), (Names{"a", "a"}));
  EXPECT_EQ(names(two + R"(,"meshes":[{"primitives":[{"material":1},{}]}])"), (Names{"a", "default"}));
  const Material material = read_gltf(gltf_of(R"("nodes":[])"), "a.gltf", {}).materials[0];
  EXPECT_EQ(material.file, "a.gltf");
  expect_f0(material, white);
  expect_power(material, 0);
}

TEST(Gltf, MaterialsThatNoPrimitiveHasAreUnused) {
  using Names = std::vector<std::string>;
  const auto unused = [](const std::string& members) {
    return read_gltf(gltf_of(R"("materials":[{"name":"a"},{"name":"b"},{"name":"c"}],)" + members), "a.gltf",
                     {})
        .unused;
  };
  EXPECT_EQ(unused(R"("meshes":[{"primitives":[{"material":1}]}])"), (Names{"a", "c"}));
  EXPECT_EQ(unused(R"("meshes":[{"primitives":[{}]}])"), (Names{"a", "b", "c"}));
  EXPECT_EQ(unused(R"("meshes":[{"primitives":[{"material":1,"extensions":{"KHR_materials_variants":{)"
                   R"("mappings":[{"material":2,"variants":[0]}]}}}]}])"),
            Names{"a"});
  EXPECT_EQ(unused(R"("extensionsUsed":["MSFT_lod"],"meshes":[{"primitives":[{"material":1}]}])"), Names{});
  EXPECT_EQ(unused(R"("meshes":[])"), Names{}) << "materials alone are for any use";
  EXPECT_EQ(unused(R"("meshes":[{"primitives":[]}])"), Names{});
}

// A tolerance is for light that shows white; the sun has 1e5 lux.
TEST(Gltf, LightsAboveOneAreNamed) {
  const auto remarks = [](const std::string& lights, const std::string& more = "") {
    return read_gltf(gltf_of(R"("extensions":{"KHR_lights_punctual":{"lights":[)" + lights + "]}}" + more),
                     "a.gltf", {})
        .remarks;
  };
  const std::string sun = R"({"type":"directional","name":"sun","intensity":100000})";
  const std::string lamp = R"({"type":"point","intensity":2.5})", dim = R"({"intensity":1})";
  EXPECT_TRUE(remarks(dim + ",{}").empty());
  const std::string rest =
      ". The tolerance is for a light of 1, which shows white: an error of these is as many times larger before "
      "exposure";
  EXPECT_EQ(remarks(sun + "," + dim + "," + lamp),
            std::vector<std::string>{
                "lights above 1: 'sun' (100000 lux), /extensions/KHR_lights_punctual/lights/2 (2.5 candela)" +
                rest});
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

TEST(Gltf, CountsLights) {
  const auto lights = [&](const std::string& nodes) {
    return read_gltf(gltf_of(R"("extensions":{"KHR_lights_punctual":{"lights":[{},{},{}]}},"nodes":[)" +
                             nodes + "]"),
                     "a.gltf", {})
        .lights;
  };
  const std::string lit = R"({"extensions":{"KHR_lights_punctual":{"light":2}}})";
  EXPECT_EQ(lights(""), 3);
  EXPECT_EQ(lights("{}"), 3);
  EXPECT_EQ(lights(lit), 1);
  EXPECT_EQ(lights(lit + ",{}," + lit), 2);
  EXPECT_EQ(read_gltf(gltf_of(R"("nodes":[{}])"), "a.gltf", {}).lights, 0);
}

TEST(Gltf, ACycleOfNodesDoesNotMatter) {
  EXPECT_EQ(
      read_gltf(gltf_of(R"("nodes":[{"children":[1]},{"children":[0,1]}])"), "a.gltf", {}).materials.size(),
      1u);
}

TEST(Gltf, GeometryIsNotRead) {
  EXPECT_EQ(read_gltf(gltf_of(R"("accessors":{"a":[{}]},"skins":7,"materials":[{"extras":{"extras":1}}])"),
                      "a.gltf", {})
                .materials.size(),
            1u);
}

}  // namespace
}  // namespace shadefit::scene
