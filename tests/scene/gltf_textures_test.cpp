#include <gtest/gtest.h>

#include <numeric>

#include "scene/gltf/read_gltf.hpp"
#include "tests/scene/samples.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit::scene {
namespace {

using shadefit::testing::base64;
using shadefit::testing::chunk;
using shadefit::testing::glb_of;
using shadefit::testing::gltf_of;
using shadefit::testing::gltf_of_image;
using shadefit::testing::metallic_roughness_png;
using shadefit::testing::png_of;
using shadefit::testing::TemporaryDirectory;
using namespace std::string_literals;

/// Roughness 0, 1/5 (twice) and 1: powers without end, 2 5^4 - 2 = 1248, and 0. Metallic from 0 to 1 with a
/// white base colour.
void expect_the_sample(const Material& material) {
  ASSERT_EQ(material.powers.size(), 3u);
  EXPECT_EQ(material.powers[0], (PowerShare{0, 0.25}));
  EXPECT_NEAR(material.powers[1].power, 1248, 1e-9);
  EXPECT_EQ(material.powers[1].share, 0.5);
  EXPECT_EQ(material.powers[2], (PowerShare{most_power, 0.25}));
  EXPECT_TRUE(material.is_power_textured());
  EXPECT_NEAR(material.f0[0].least, 0.04, 1e-15);
  EXPECT_EQ(material.f0[0].most, 1);
  EXPECT_TRUE(material.unknowns.empty());
}

std::string buffer_of(std::size_t size, const std::string& uri) {
  return R"(,"buffers":[{"byteLength":)" + std::to_string(size) +
         (uri.empty() ? "" : R"(,"uri":")" + uri + "\"") + "}]";
}

std::string view_of(std::size_t offset, std::size_t size) {
  return R"(,"bufferViews":[{"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
         std::to_string(size) + "}]";
}

TEST(GltfTextures, OfADataUri) {
  const std::string uri = R"("uri":"data:image/png;base64,)" + base64(metallic_roughness_png()) + "\"";
  expect_the_sample(read_gltf(gltf_of_image(uri), "a.gltf", {}).materials.at(0));
}

TEST(GltfTextures, OfAFileBesideWhoseNameIsEncoded) {
  const TemporaryDirectory directory;
  directory.file("maps/rough ness.png", metallic_roughness_png());
  const std::string file = directory.file("a.gltf", gltf_of_image(R"("uri":"maps/rough%20ness.png")"));
  const Scene scene = read_gltf(file, {});
  expect_the_sample(scene.materials.at(0));
  EXPECT_EQ(scene.materials[0].file, file);
  EXPECT_TRUE(scene.missing.empty());
}

TEST(GltfTextures, OfABufferInAFileInDataAndInAGlb) {
  const std::string png = metallic_roughness_png(), content = "???" + png + "?";
  const std::string view = R"("bufferView":0,"mimeType":"image/png")";
  const auto document = [&](const std::string& uri) {
    return gltf_of_image(view, view_of(3, png.size()) + buffer_of(content.size(), uri));
  };
  const TemporaryDirectory directory;
  directory.file("a.bin", content);
  expect_the_sample(
      read_gltf(std::filesystem::path(directory.file("a.gltf", document("a.bin"))), {}).materials.at(0));
  expect_the_sample(
      read_gltf(document("data:application/octet-stream;base64," + base64(content)), "a.gltf", {})
          .materials.at(0));
  const std::string glb = glb_of(chunk("JSON", document("")) + chunk("BIN\0"s, content));
  expect_the_sample(read_gltf(glb, "a.glb", {}).materials.at(0));
  expect_the_sample(read_gltf(std::filesystem::path(directory.file("b.GLB", glb)), {}).materials.at(0));
}

TEST(GltfTextures, FactorsScaleThem) {
  const std::string members =
      R"("materials":[{"pbrMetallicRoughness":{"roughnessFactor":0.5,"metallicFactor":0.5,)"
      R"("metallicRoughnessTexture":{"index":0}}}],"textures":[{"source":0}],"images":[{"uri":"data:;base64,)" +
      base64(metallic_roughness_png()) + R"("}])";
  const Material material = read_gltf(gltf_of(members), "a.gltf", {}).materials.at(0);
  ASSERT_EQ(material.powers.size(), 3u);
  EXPECT_NEAR(material.powers[0].power, 30, 1e-12);
  EXPECT_NEAR(material.powers[1].power, 19998, 1e-8);
  EXPECT_NEAR(material.f0[0].most, 0.52, 1e-15);
}

TEST(GltfTextures, GlossIsInTheAlpha) {
  const std::string png = png_of({2, 1, PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 0, 1, 2, 3, 255}});
  const std::string document = gltf_of(
      R"("materials":[{"extensions":{"KHR_materials_pbrSpecularGlossiness":{"specularFactor":[0.5,1,1],)"
      R"("specularGlossinessTexture":{"index":0}}}}],"textures":[{"source":0}],"images":[{"uri":"data:;base64,)" +
      base64(png) + R"("}])");
  const Material material = read_gltf(document, "a.gltf", {.is_gloss_exponential = true}).materials.at(0);
  EXPECT_EQ(material.powers, (std::vector<PowerShare>{{2, 0.5}, {2048, 0.5}}));
  EXPECT_EQ(material.f0[0], (Range{0, 0.5}));
  EXPECT_EQ(material.unknowns,
            std::vector<std::string>{
                "colour of the specular-glossiness texture is not read: F0 is taken from 0 to the factor"});
}

/// Every code as often as another, and metallic from 0 to 1.
void expect_unknown(const Scene& scene, const std::string& words) {
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.unknowns, std::vector<std::string>{"metallic-roughness texture " + words});
  EXPECT_TRUE(material.is_power_textured());
  ASSERT_GT(material.powers.size(), 250u);
  EXPECT_EQ(material.powers.front(), (PowerShare{0, 1 / 256.0}));
  double shares = 0;
  for (const PowerShare& share : material.powers) shares += share.share;
  EXPECT_NEAR(shares, 1, 1e-12);
  EXPECT_NEAR(material.f0[0].least, 0.04, 1e-15);
  EXPECT_EQ(material.f0[0].most, 1);
}

TEST(GltfTextures, WhatIsMissingIsNamed) {
  const TemporaryDirectory directory;
  const auto scene_of = [&](const std::string& image, const std::string& more = "") {
    return read_gltf(gltf_of_image(image, more), directory / "a.gltf", {});
  };
  expect_unknown(scene_of(R"("uri":"gone.png")"), "'gone.png' is missing");
  EXPECT_TRUE(scene_of(R"("uri":"gone.png")").missing.empty());
  expect_unknown(scene_of(R"("uri":"https://x.org/a.png")"), "'https://x.org/a.png' is not fetched");
  expect_unknown(scene_of(R"("uri":"data:,RIFF")"), "/images/0 is neither PNG nor JPEG");
  const std::string view = R"("bufferView":0)";
  expect_unknown(scene_of(view, view_of(0, 5) + buffer_of(5, "gone.bin")), "'gone.bin' is missing");
  expect_unknown(scene_of(view, view_of(0, 5) + buffer_of(5, "http://x.org/b")),
                 "'http://x.org/b' is not fetched");
  directory.file("a.webp", "RIFF");
  expect_unknown(scene_of(R"("uri":"a.webp")"), "'a.webp' is neither PNG nor JPEG");
  const std::string without_source = gltf_of(
      R"("materials":[{"pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}}}],"textures":[{}])");
  expect_unknown(read_gltf(without_source, "a.gltf", {}), "/textures/0 has no source");
}

TEST(GltfTextures, MissingGeometryCostsNothing) {
  const TemporaryDirectory directory;
  directory.file("there.bin", "");
  const std::string members =
      R"("buffers":[{"byteLength":5,"uri":"z.bin"},{"byteLength":5,"uri":"there.bin"},{"byteLength":1},)"
      R"({"byteLength":5,"uri":"z.bin"}],"images":[{"uri":"colour.png"},{"uri":"data:,x"},{"uri":"http://x.org/a"}])";
  const Scene scene = read_gltf(gltf_of(members), directory / "a.gltf", {});
  EXPECT_EQ(scene.missing, (std::vector<std::string>{"colour.png", "z.bin"}));
  EXPECT_EQ(scene.materials.size(), 1u);
}

// 64 MiB of texels each time, were it not for that: a hundred materials would take a minute.
TEST(GltfTextures, APictureIsReadOnce) {
  const std::string material = R"({"pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}}})";
  std::string materials = material;
  for (int i = 1; i < 100; ++i) materials += "," + material;
  const std::string large =
      png_of({2048, 2048, PNG_COLOR_TYPE_RGB, std::vector<std::uint8_t>(3 * 2048 * 2048)});
  const std::string document =
      gltf_of(R"("materials":[)" + materials +
              R"(],"textures":[{"source":0}],"images":[{"uri":"data:;base64,)" + base64(large) + R"("}])");
  EXPECT_EQ(read_gltf(document, "a.gltf", {}).materials.size(), 100u);
}

}  // namespace
}  // namespace shadefit::scene
