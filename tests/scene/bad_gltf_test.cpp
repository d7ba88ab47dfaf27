#include <gtest/gtest.h>

#include <filesystem>

#include "fit/input/json_document.hpp"
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
using shadefit::testing::gltf_of_material;
using shadefit::testing::khr;
using shadefit::testing::metal;
using shadefit::testing::metallic_roughness_png;
using shadefit::testing::png_header;
using shadefit::testing::refusal;
using shadefit::testing::TemporaryDirectory;

std::string refusal_of_gltf(const std::string& document) {
  return refusal([&] { read_gltf(document, "a.gltf", {}); });
}

std::string refusal_of_material(const std::string& members) {
  return refusal_of_gltf(gltf_of_material(members));
}

std::string refusal_of_factor(const std::string& members) {
  return refusal_of_material(metal(members));
}

/// A document or members, and what is wrong with it.
using Refusals = std::vector<std::pair<std::string, std::string>>;

TEST(BadGltf, MalformedJsonAndOtherVersions) {
  for (const auto& [document, words] :
       Refusals{{"", ", line 1, column 1: the JSON ends early"},
                {"{\n  \"a\": 1,\n  b\n}", ", line 3, column 3: malformed JSON"},
                {"{\"a\": 1", ", line 1, column 8: the JSON ends early"},
                {"{\"a\": NaN}", ", line 1, column 7: malformed JSON"},
                {"{\"a\": \"\xFF\"}", ", line 1, column 8: malformed JSON"},
                {"{\"a\": 1e999}", ", line 1, column 11: a number is too large"},
                {"[]", ": /: it must be an object"},
                {"{}", ": /: its member 'asset' is missing"},
                {R"({"asset":{}})", ": /asset: its member 'version' is missing"},
                {R"({"asset":{"version":2.0}})", ": /asset/version = 2.0: it must be a text"},
                {R"({"asset":{"version":"1.0"}})", ": /asset/version = \"1.0\": it must be 2.0"}})
    EXPECT_EQ(refusal_of_gltf(document), "'a.gltf'" + words);
}

TEST(BadGltf, WhatTwoReadersMayReadInTwoWays) {
  EXPECT_EQ(refusal_of_gltf(R"({"asset":{"version":"2.0"},"materials":[{}],"materials":[]})"),
            "'a.gltf': JSON has two members 'materials' in one object");
  EXPECT_EQ(refusal_of_gltf(gltf_of_material("") + std::string("\0 ", 2)).substr(0, 10), "'a.gltf', ");
  EXPECT_EQ(refusal_of_gltf(R"({"extras":{"a":1,"a":2},"asset":{"version":"2.0"}})"), "")
      << "what is not kept is nobody's";
}

// Depth and the number of materials: tests/app/hostile_scene_test.cpp.
TEST(BadGltf, TheNumberOfValuesIsBounded) {
  std::string many = "[0";
  for (std::size_t i = 0; i < most_json_values; ++i) many += ",0";
  EXPECT_EQ(refusal_of_gltf(gltf_of(R"("materials":)" + many + "]")),
            "'a.gltf': JSON has more than 4000000 values");
}

TEST(BadGltf, FactorsOutOfRange) {
  for (const auto& [member, words] :
       Refusals{{R"("roughnessFactor":1.5)", " = 1.5: it must be in [0, 1]"},
                {R"("roughnessFactor":-0.5)", " = -0.5: it must be in [0, 1]"},
                {R"("roughnessFactor":null)", " = null: it must be a number"},
                {R"("roughnessFactor":"1")", " = \"1\": it must be a number"},
                {R"("metallicFactor":2)", " = 2: it must be in [0, 1]"},
                {R"("metallicFactor":[1])", ": it must be a number"},
                {R"("baseColorFactor":[1,1,1])", ": it must have 4 numbers"},
                {R"("baseColorFactor":{})", ": it must be an array"},
                {R"("baseColorFactor":[1,2,1,1])", "/1 = 2: it must be in [0, 1]"}}) {
    const std::string key = member.substr(1, member.find(':') - 2);
    EXPECT_EQ(refusal_of_factor(member), "'a.gltf': /materials/0/pbrMetallicRoughness/" + key + words);
  }
  EXPECT_EQ(refusal_of_material(R"("name":5)"), "'a.gltf': /materials/0/name = 5: it must be a text");
  struct Case {
    std::string extension, member, words;
  };
  for (const auto& [extension, member, words] :
       {Case{"ior", R"("ior":0.5)", " = 0.5: it must be at least 1, or 0 for a reflectance of 1"},
        {"ior", R"("ior":-1)", " = -1: it must be at least 0"},
        {"specular", R"("specularFactor":2)", " = 2: it must be in [0, 1]"},
        {"specular", R"("specularColorFactor":[1,-1,1])", "/1 = -1: it must be at least 0"},
        {"pbrSpecularGlossiness", R"("glossinessFactor":2)", " = 2: it must be in [0, 1]"}}) {
    const std::string key = member.substr(1, member.find(':') - 2);
    EXPECT_EQ(refusal_of_material(khr(extension, member)),
              "'a.gltf': /materials/0/extensions/KHR_materials_" + extension + "/" + key + words);
  }
}

TEST(BadGltf, IndicesOutOfRange) {
  const std::string info = "'a.gltf': /materials/0/pbrMetallicRoughness/metallicRoughnessTexture";
  for (const auto& [members, words] :
       Refusals{{"", ": its member 'index' is missing"},
                {R"("index":0)", "/index = 0: there are 0 in /textures, counted from 0"},
                {R"("index":-1)", "/index = -1: it must be a whole number from 0 on"},
                {R"("index":1e9)", "/index = 1000000000.0: it must be a whole number from 0 on"}})
    EXPECT_EQ(refusal_of_factor(R"("metallicRoughnessTexture":{)" + members + "}"), info + words);
  const std::string textured =
      R"("materials":[{"pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}}}],)";
  const std::string source = textured + R"("textures":[{"source":0}],)";
  for (const auto& [members, words] : Refusals{
           {textured + R"("textures":[{"source":3}],"images":[{}])",
            "/textures/0/source = 3: there are 1 in /images, counted from 0"},
           {source + R"("images":[{}])", "/images/0: it must have a uri or a bufferView, and not both"},
           {source + R"("images":[{"bufferView":1}],"bufferViews":[{}])",
            "/images/0/bufferView = 1: there are 1 in /bufferViews, counted from 0"},
           {source + R"("images":[{"bufferView":0}],"bufferViews":[{"buffer":1}],"buffers":[])",
            "/bufferViews/0/buffer = 1: there are 0 in /buffers, counted from 0"},
           {R"("meshes":[{"primitives":[{"material":0}]}])",
            "/meshes/0/primitives/0/material = 0: there are 0 in /materials, counted from 0"},
           {R"("nodes":[{"extensions":{"KHR_lights_punctual":{"light":0}}}])",
            "/nodes/0/extensions/KHR_lights_punctual/light = 0: there are 0 in "
            "/extensions/KHR_lights_punctual/lights, counted from 0"},
           {R"("extensionsRequired":["KHR_mesh_quantization","ACME_paint"])",
            "/extensionsRequired/1 = \"ACME_paint\": the file requires this extension, and it is not known"}})
    EXPECT_EQ(refusal_of_gltf(gltf_of(members)), "'a.gltf': " + words);
  EXPECT_EQ(refusal_of_gltf(gltf_of(R"("extensionsRequired":["KHR_materials_volume","KHR_texture_basisu"])")),
            "");
}

TEST(BadGltf, ViewsPastTheEnd) {
  const TemporaryDirectory directory;
  directory.file("short.bin", "12345");
  const std::string path = std::filesystem::weakly_canonical(directory / "short.bin").string();
  const std::string short_file = R"(,"uri":"short.bin")", most = "18446744073709551615";
  struct Case {
    std::string view, buffer, words;
  };
  for (const auto& [view, buffer, words] :
       {Case{"6", "5" + short_file, "bufferViews/0: 6 bytes from 0 on go past the 5 of /buffers/0"},
        {R"(1,"byteOffset":)" + most, "5" + short_file,
         "bufferViews/0: 1 bytes from " + most + " on go past the 5 of /buffers/0"},
        {R"(4,"byteOffset":2)", "9" + short_file,
         "bufferViews/0: cannot read '" + path + "': 4 bytes from 2 on are asked of a file of 5"},
        {"4", R"(9,"uri":"data:,ab")", "bufferViews/0: 4 bytes from 0 on go past the 2 of /buffers/0"},
        {"4", "9", "buffers/0: it has neither a uri nor a chunk BIN"},
        {"4", "1e9", "buffers/0/byteLength = 1000000000.0: it must be a whole number from 0 on"}}) {
    const std::string document =
        gltf_of_image(R"("bufferView":0)", R"(,"bufferViews":[{"buffer":0,"byteLength":)" + view +
                                               R"(}],"buffers":[{"byteLength":)" + buffer + "}]");
    EXPECT_EQ(refusal([&] { read_gltf(document, directory / "a.gltf", {}); }),
              "'" + directory / "a.gltf" + "': /" + words);
  }
}

TEST(BadGltf, NamesOutsideOfTheFolder) {
  const TemporaryDirectory directory;
  directory.file("secret.png", metallic_roughness_png());
  directory.file("scene/a.png", metallic_roughness_png());
  std::filesystem::create_symlink(directory.path() / "secret.png", directory.path() / "scene/link.png");
  std::filesystem::create_directory_symlink(directory.path(), directory.path() / "scene/up");
  const std::string file = directory / "scene/a.gltf";
  for (const char* uri :
       {"../secret.png", "%2e%2e/secret.png", "x/../../secret.png", "..\\\\secret.png", "/etc/passwd",
        "file:///etc/passwd", "FILE:a.png", "C:/a.png", "link.png", "up/secret.png", "."}) {
    const std::string image = std::string(R"("uri":")") + uri + "\"";
    const std::string words = refusal([&] { read_gltf(gltf_of_image(image), file, {}); });
    EXPECT_NE(words.find("is outside of the scene's folder"), std::string::npos) << uri << ": " << words;
  }
  EXPECT_EQ(refusal([&] { read_gltf(gltf_of_image(R"("uri":"../../etc/passwd")"), file, {}); }),
            "'" + file + "': /images/0/uri: '../../etc/passwd' is outside of the scene's folder '" +
                directory / "scene" + "'");
  EXPECT_EQ(refusal([&] { read_gltf(gltf_of_image(R"("uri":"x/../a.png")"), file, {}); }), "");
}

TEST(BadGltf, MalformedUrisAndPictures) {
  const std::string base64_of = "data:;base64,";
  const auto refused = [&](const std::string& uri) {
    return refusal_of_gltf(gltf_of_image(R"("uri":")" + uri + "\""));
  };
  for (const auto& [uri, words] :
       Refusals{{"data:image/png;base64", "/uri: the data URI has no comma before its data"},
                {base64_of + "abc*", "/uri: character 4 of the base64 is not one of its 64"},
                {base64_of + "abcde", "/uri: base64 ends within a byte"},
                {"a%2", "/uri: character 2 of the URI is a % without two digits of a byte"},
                {"a%zz", "/uri: character 2 of the URI is a % without two digits of a byte"},
                {"a%00", "/uri: character 2 of the URI is a % without two digits of a byte"},
                {"", "/uri: the name of a file is empty"},
                {"a\\u0000", "/uri: the name of a file has a zero within"},
                {std::string(4097, 'x'), "/uri: the name of a file has 4097 bytes, more than 4096"},
                {base64_of + base64(png_header(60000, 60000)),
                 ": the picture has 60000 x 60000 pixels, more than 67108864 together"},
                {base64_of + base64(metallic_roughness_png().substr(0, 50)),
                 ": the PNG is damaged: the file ends before the picture does"}})
    EXPECT_EQ(refused(uri), "'a.gltf': /images/0" + words);
  EXPECT_NE(refused(std::string(4000, 'x')).find("cannot be followed: File name too long"),
            std::string::npos);
}

TEST(BadGltf, Files) {
  const TemporaryDirectory directory;
  EXPECT_EQ(refusal([&] { read_gltf(std::filesystem::path(directory / "gone.gltf"), {}); }),
            "cannot read '" + directory / "gone.gltf" + "': there is no such file");
  EXPECT_EQ(refusal([&] { read_gltf(directory.path(), {}); }),
            "cannot read '" + directory.path().string() + "': it is a directory");
  const std::string large = directory.file("large.gltf", "");
  std::filesystem::resize_file(large, most_json_bytes + 1);
  EXPECT_EQ(refusal([&] { read_gltf(std::filesystem::path(large), {}); }),
            "cannot read '" + large + "': it has 67108865 bytes, more than 67108864");
  EXPECT_EQ(refusal([&] { read_gltf("glTF", "a.glb", {}); }),
            "'a.glb': byte 0: a GLB file begins with 12 bytes, and has 4");
  const std::string padded = glb_of(chunk("JSON", std::string(most_json_bytes + 4, ' ')));
  EXPECT_EQ(refusal([&] { read_gltf(padded, "a.glb", {}); }),
            "'a.glb': its JSON has 67108868 bytes, more than the 67108864 that it may have");
}

// Of a text of the file a message has the beginning.
TEST(BadGltf, LongTextsAreShortened) {
  const std::string is_long(100000, 'x');
  const std::string said = refusal_of_factor(R"("roughnessFactor":")" + is_long + "\"");
  EXPECT_EQ(said, "'a.gltf': /materials/0/pbrMetallicRoughness/roughnessFactor = \"" + std::string(200, 'x') +
                      " ..\": it must be a number");
  const std::string euros = "\xE2\x82\xAC";
  std::string many = "x";
  for (int i = 0; i < 1000; ++i) many += euros;
  const Scene scene = read_gltf(gltf_of_material(R"("name":")" + many + "\""), "a.gltf", {});
  EXPECT_EQ(scene.materials[0].name, many.substr(0, 199) + " ..") << "no code point is cut";
  const std::string remote = gltf_of_image(R"("uri":"http://)" + is_long + "\"");
  EXPECT_LT(read_gltf(remote, "a.gltf", {}).materials[0].unknowns.at(0).size(), 300U);
}

}  // namespace
}  // namespace shadefit::scene
