#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <stdio.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scene/gltf/read_gltf.hpp"
#include "scene/gltf/read_mtl.hpp"
#include "tests/scene/samples.hpp"

namespace shadefit::scene {
namespace {

using shadefit::testing::base64;
using shadefit::testing::gltf_of;
using shadefit::testing::gltf_of_material;
using shadefit::testing::png_of;
using shadefit::testing::refusal;

constexpr Conventions with_features{.has_features = true};
const std::string tests_folder = SHADEFIT_SOURCE_DIR "/tests/";

std::string listed(const Features& features) {
  return fmt::format("{}", fmt::join(features, ", "));
}

// Each material is named after its features; that which nothing uses is not among them.
TEST(Features, OfGltfAreByValue) {
  const std::filesystem::path file = tests_folder + "scene/features.gltf";
  const std::vector<Material> materials = read_gltf(file, with_features).materials;
  EXPECT_GT(materials.size(), 50U);
  for (std::size_t i = 0; i < materials.size(); ++i)
    EXPECT_EQ(listed(materials[i].features), materials[i].name) << "material " << i;
  EXPECT_TRUE(read_gltf(file, Conventions{}).materials[1].features.empty());
}

// A channel that is the same everywhere is a factor. Where it is full, a metal of factor 1 has no ior.
TEST(Features, TexelsOfMetallicAndRoughnessDecide) {
  struct Case {
    std::vector<std::uint8_t> texels;
    std::string features;
  };
  for (const auto& [texels, features] : {Case{{0, 9, 9, 0, 9, 9}, "ior"},
                                         {{0, 9, 255, 0, 9, 255}, ""},
                                         {{0, 8, 255, 0, 9, 255}, "roughness texture"},
                                         {{0, 9, 254, 0, 9, 255}, "ior, metallic texture"}}) {
    const std::string image =
        R"("uri":"data:;base64,)" + base64(png_of({2, 1, PNG_COLOR_TYPE_RGB, texels})) + '"';
    const std::string document =
        gltf_of(R"("materials":[{"pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}},)"
                R"("extensions":{"KHR_materials_ior":{"ior":2}}}],"textures":[{"source":0}],"images":[{)" +
                image + "}]");
    EXPECT_EQ(listed(read_gltf(document, "a.gltf", with_features).materials.at(0).features), features);
  }
}

/// What a program of ours, which reads the JSON by itself, says of a file.
nlohmann::json independent_features(const std::string& file) {
  const std::string command =
      SHADEFIT_PYTHON " -B '" + tests_folder + "scene/features_of_gltf.py' '" + file + "'";
  std::FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = 0; pipe != nullptr && (c = std::fgetc(pipe)) != EOF;) text.push_back(static_cast<char>(c));
  EXPECT_EQ(pclose(pipe), 0) << file;
  return nlohmann::json::parse(text);
}

TEST(Features, AgreeWithAnIndependentReader) {
  std::vector<std::string> files{tests_folder + "scene/features.gltf"};
  for (const auto& entry : std::filesystem::directory_iterator(tests_folder + "fuzz/corpus/read_gltf"))
    if (entry.path().stem() != "outside") files.push_back(entry.path().string());
  EXPECT_GE(files.size(), 9U);
  for (const std::string& file : files) {
    const nlohmann::json expected = independent_features(file);
    const std::vector<Material> materials = read_gltf(std::filesystem::path(file), with_features).materials;
    ASSERT_EQ(materials.size(), expected.size()) << file;
    for (std::size_t i = 0; i < materials.size(); ++i) {
      EXPECT_EQ(materials[i].name, expected[i][0].get<std::string>()) << file;
      Features features = expected[i][1].get<Features>();
      // it decodes no picture
      for (const char* texture : {"metallic texture", "roughness texture"})
        if (!materials[i].features.contains(texture)) features.erase(texture);
      EXPECT_EQ(materials[i].features, features) << file << ": " << materials[i].name;
    }
  }
}

TEST(Features, OfMtlAreByValue) {
  for (const auto& [lines, features] : {std::pair{"Ks 0 0 0\nNs 3", ""},
                                        {"Ks 0.1 0 0\nNs 3", "specular"},
                                        {"Ks 0.1 0 0\nNs 3\nillum 1", ""},
                                        {"map_Ks a.png\nNs 3", "specular, specular texture"},
                                        {"map_Ks a.png\nKs 0\nNs 3", ""},
                                        {"Ks 1\nNs 3\nmap_Ns a.png", "shininess texture, specular"},
                                        {"map_Kd a.png", "base colour texture"},
                                        {"map_Kd a.png\nKd 0 0 0", ""},
                                        {"Ke 0 0 0\nmap_Ke a.png", ""},
                                        {"Ke 0 1 0", "emission"},
                                        {"map_Ke a.png", "emission, emission texture"},
                                        {"bump -bm 1 a.png", "normal map"},
                                        {"norm a.png", "normal map"},
                                        {"d 1\nTr 0", ""},
                                        {"d -halo 0.5", "alpha blend"},
                                        {"Tr 0.5", "alpha blend"},
                                        {"map_d a.png", "alpha blend"},
                                        {"Pr 0.5\nPm 0.5\nNi 1.5", ""},
                                        {"Pr 0.5\nPm 0.5\nNi 2", "ior"},
                                        {"Pr 0.5\nPm 1\nNi 2", ""},
                                        {"map_Pr a.png\nmap_Pm a.png", "metallic texture, roughness texture"},
                                        {"map_Pr a.png\nPr 0\nPm 1", ""},
                                        {"Pc 0.5\nPs 0.1\naniso 0.2", "anisotropy, clear coat, sheen"},
                                        {"Pc 0\nPs 0\naniso 0", ""}}) {
    const Scene scene = read_mtl(std::string("newmtl a\n") + lines, "no such folder/a.mtl", with_features);
    EXPECT_EQ(listed(scene.materials.at(0).features), features) << lines;
  }
}

TEST(Features, OfBadValuesAreRefused) {
  const std::string place = "'a.gltf': /materials/0/";
  for (const auto& [members, words] :
       {std::pair{R"("alphaMode":"GLASS")", R"(alphaMode = "GLASS": it must be OPAQUE, MASK or BLEND)"},
        {R"("doubleSided":1)", "doubleSided = 1: it must be true or false"},
        {R"("emissiveFactor":[0,"1",0])", R"(emissiveFactor/1 = "1": it must be a number)"},
        {R"("normalTexture":5)", "normalTexture = 5: it must be an object"}}) {
    const std::string document = gltf_of_material(members);
    EXPECT_EQ(refusal([&] { read_gltf(document, "a.gltf", with_features); }), place + words);
    EXPECT_EQ(refusal([&] { read_gltf(document, "a.gltf", {}); }), "") << "a plan needs none of these";
  }
}

}  // namespace
}  // namespace shadefit::scene
