#include <gtest/gtest.h>

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
using shadefit::testing::khr;
using shadefit::testing::metal;
using shadefit::testing::metallic_roughness_png;
using shadefit::testing::png_of;
using shadefit::testing::TemporaryDirectory;
using shadefit::testing::told;
using namespace std::string_literals;

/// Roughness from 0 to 1: powers without end, and 0. Metallic from 0 to 1 with a white base colour.
constexpr const char* the_sample =
    "F0 0.04 to 1, F90 1, n 0 to 1000000000 of roughness; the specular power = inf is taken for 1e+09";

std::string told_first(const Scene& scene) {
  return told(scene.materials.at(0));
}

std::string buffer_of(std::size_t size, const std::string& uri) {
  return R"(,"buffers":[{"byteLength":)" + std::to_string(size) +
         (uri.empty() ? "" : R"(,"uri":")" + uri + "\"") + "}]";
}

std::string view_of(std::size_t offset, std::size_t size) {
  return R"(,"bufferViews":[{"buffer":0,"byteOffset":)" + std::to_string(offset) + R"(,"byteLength":)" +
         std::to_string(size) + "}]";
}

TEST(GltfTextures, AreReadWhereverTheyAre) {
  const std::string png = metallic_roughness_png(), content = "???" + png + "?";
  const std::string uri = R"("uri":"data:image/png;base64,)" + base64(png) + "\"";
  EXPECT_EQ(told_first(read_gltf(gltf_of_image(uri), "a.gltf", {})), the_sample);
  const TemporaryDirectory directory;
  directory.file("maps/rough ness.png", png);
  directory.file("a.bin", content);
  const std::string beside = directory.file("a.gltf", gltf_of_image(R"("uri":"maps/rough%20ness.pn%67")"));
  const Scene scene = read_gltf(beside, {});
  EXPECT_EQ(told_first(scene), the_sample);
  EXPECT_EQ(scene.materials[0].file, beside);
  const auto document = [&](const std::string& buffer) {
    return gltf_of_image(R"("bufferView":0,"mimeType":"image/png")",
                         view_of(3, png.size()) + buffer_of(content.size(), buffer));
  };
  const std::string data = "data:application/octet-stream;base64," + base64(content);
  const std::string glb = glb_of(chunk("JSON", document("")) + chunk("BIN\0"s, content));
  EXPECT_EQ(told_first(read_gltf(std::filesystem::path(directory.file("b.gltf", document("a.bin"))), {})),
            the_sample);
  EXPECT_EQ(told_first(read_gltf(document(data), "a.gltf", {})), the_sample);
  EXPECT_EQ(told_first(read_gltf(glb, "a.glb", {})), the_sample);
  EXPECT_EQ(told_first(read_gltf(std::filesystem::path(directory.file("b.GLB", glb)), {})), the_sample);
}

TEST(GltfTextures, FactorsScaleThemAndGlossIsInTheAlpha) {
  const auto with = [](const std::string& material, const std::string& png) {
    return gltf_of(R"("materials":[{)" + material + R"(}],"textures":[{"source":0}],"images":[{"uri":)" +
                   R"("data:;base64,)" + base64(png) + R"("}])");
  };
  const std::string halves =
      R"("roughnessFactor":0.5,"metallicFactor":0.5,"metallicRoughnessTexture":{"index":0})";
  EXPECT_EQ(told_first(read_gltf(with(metal(halves), metallic_roughness_png()), "a.gltf", {})),
            "F0 0.04 to 0.52, F90 1, n 30 to 1000000000 of roughness; the specular power = inf "
            "is taken for 1e+09");
  const std::string glossy =
      khr("pbrSpecularGlossiness", R"("specularFactor":[0.5,1,1],"specularGlossinessTexture":{"index":0})");
  const std::string png = png_of({2, 1, PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 0, 1, 2, 3, 255}});
  EXPECT_EQ(told_first(read_gltf(with(glossy, png), "a.gltf", {.is_gloss_exponential = true})),
            "F0 0 to 0.5 | 0 to 1 | 0 to 1, F90 1, n 2 to 2048 of gloss; colour of the specular-glossiness "
            "texture is not read: F0 is taken from 0 to the factor");
}

/// Roughness and metallic from 0 to 1.
void expect_unknown(const Scene& scene, const std::string& words) {
  EXPECT_EQ(told_first(scene),
            "F0 0.04 to 1, F90 1, n 0 to 1000000000 of roughness; metallic-roughness texture " + words +
                "; the specular power = inf is taken for 1e+09");
}

TEST(GltfTextures, WhatIsMissingIsNamed) {
  const TemporaryDirectory directory;
  const auto scene_of = [&](const std::string& image, const std::string& more = "") {
    return read_gltf(gltf_of_image(image, more), directory / "a.gltf", {});
  };
  expect_unknown(scene_of(R"("uri":"gone.png")"), "'gone.png' is missing");
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

// 4 Mi pixels each time, were it not for that: more than a scene may have.
TEST(GltfTextures, APictureIsReadOnce) {
  const std::string material = R"({"pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}}})";
  std::string materials = material;
  for (int i = 1; i < 1100; ++i) materials += "," + material;
  const std::string large =
      png_of({2048, 2048, PNG_COLOR_TYPE_RGB, std::vector<std::uint8_t>(3 * 2048 * 2048)});
  const std::string document =
      gltf_of(R"("materials":[)" + materials +
              R"(],"textures":[{"source":0}],"images":[{"uri":"data:;base64,)" + base64(large) + R"("}])");
  EXPECT_EQ(read_gltf(document, "a.gltf", {}).materials.size(), 1100u);
}

}  // namespace
}  // namespace shadefit::scene
