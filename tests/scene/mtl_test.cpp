#include <gtest/gtest.h>

#include "scene/gltf/read_mtl.hpp"
#include "tests/scene/samples.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit::scene {
namespace {

using shadefit::testing::metallic_roughness_png;
using shadefit::testing::png_of;
using shadefit::testing::refusal;
using shadefit::testing::TemporaryDirectory;
using shadefit::testing::told;
using namespace std::string_literals;

std::string mtl(const std::string& lines, const Conventions& conventions = {},
                const std::string& file = "a.mtl") {
  return told(read_mtl("newmtl a\n" + lines, file, conventions).materials.at(0));
}

std::string refusal_of_mtl(const std::string& text) {
  return refusal([&] { read_mtl(text, "a.mtl", {}); });
}

TEST(Mtl, LinesBecomeALobe) {
  for (const auto& [lines, text] :
       {std::pair{"Ns 50.5\nKs 0.25 0.5 1.5\nillum 2\n", "F0 0.25 | 0.5 | 1.5, no Fresnel, n 50.5"},
        {"Ks 1\nNs 5\nillum 3", "F0 1, no Fresnel, n 5"},
        // black, unsaid, or by illumination there is no specular
        {"Ks 0 0 0\nNs 20", "F0 0, no Fresnel, n 20"},
        {"Ns 20", "F0 0, no Fresnel, n 20"},
        {"Ns 20\nKs 1 1 1\nillum 0", "F0 0, no Fresnel, n 20"},
        {"Ns 20\nKs 1 1 1\nillum 1", "F0 0, no Fresnel, n 20"},
        {"Kd 1 1 1", "F0 0, no Fresnel, n 0"},
        {"Ns 50\nmap_Ks -clamp on", "F0 0, no Fresnel, n 50"},
        // what is too large is limited, what is missing is one
        {"Ks 1e300\nNs 3", "F0 1000000, no Fresnel, n 3; Ks above 1000000 is taken for that"},
        {"Ks 1 1 1", "F0 1, no Fresnel, n 1; Ns is missing and is taken for 1"},
        {"Ks 1\nNs 1e30", "F0 1, no Fresnel, n 1000000000; Ns = 1e+30 is taken for 1e+09"},
        {"Ks 0\nNs 1e30", "F0 0, no Fresnel, n 1000000000; Ns = 1e+30 is taken for 1e+09"},
        {"Ks 1\nNs 1e9", "F0 1, no Fresnel, n 1000000000"},
        // physically based
        {"Pr 0.5\nPm 0.5\nKd 0.8 0.4 0.04\nNs 3\nKs 1 1 1", "F0 0.42 | 0.22 | 0.04, F90 1, n 30"},
        {"Pr 0.5\nNi 2", "F0 0.111111111111, F90 1, n 30"},
        {"Pr 0", "F0 0.04, F90 1, n 1000000000; the specular power = inf is taken for 1e+09"},
        {"Pm 1\nNs 7", "F0 1, F90 1, n 7"},
        {"Pm 1",
         "F0 1, F90 1, n 0 to 1000000000; roughness is missing; the specular power = inf is taken for 1e+09"},
        {"Pm 1\nNs 7\nKd 2 0.5 1", "F0 1 | 0.5 | 1, F90 1, n 7; Kd above 1 is taken for 1"},
        // other lobes
        {"Ns 2\nKs 1\nPc 0.5\naniso 0.1\nPs 0.2 0.3 0\n",
         "F0 1, no Fresnel, n 2; Pc is left out; Ps is left out; aniso is left out"},
        {"Ns 2\nKs 1\nPc 0\naniso 0\nPs 0\n", "F0 1, no Fresnel, n 2"}})
    EXPECT_EQ(mtl(lines), text) << lines;
  EXPECT_EQ(mtl("Pr 0.5", {.is_roughness_squared = false}), "F0 0.04, F90 1, n 6");
  const Material material = read_mtl("newmtl a", "a.mtl", {}).materials.at(0);
  EXPECT_EQ(material.name, "a");
  EXPECT_EQ(material.file, "a.mtl");
}

// As editors and exporters write them: with a mark, a plus, carriage returns, comments, blanks.
TEST(Mtl, FilesOfEveryHabit) {
  const Scene marked = read_mtl("\xEF\xBB\xBFnewmtl a\nKs +0.5\nNs +3\nnewmtl b\n", "a.mtl", {});
  ASSERT_EQ(marked.materials.size(), 2U);
  EXPECT_EQ(marked.materials[0].name, "a");
  EXPECT_EQ(told(marked.materials[0]), "F0 0.5, no Fresnel, n 3");
  const Scene scene = read_mtl(
      "# made by hand\r\n\r\nNs 7\r\n  newmtl \t two words \r\n\tNs 3 # three\r\n\tKs 1\r\nnewmtl two words\rNs 4\rKs "
      "0.5\rfoo bar\rNs 5",
      "a.mtl", {});
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].name, "two words");
  EXPECT_EQ(told(scene.materials[0]), "F0 1, no Fresnel, n 3");
  EXPECT_EQ(scene.materials[1].name, "two words");
  EXPECT_EQ(told(scene.materials[1]), "F0 0.5, no Fresnel, n 5");
  EXPECT_TRUE(read_mtl("", "a.mtl", {}).materials.empty());
  EXPECT_TRUE(read_mtl("# none\n", "a.mtl", {}).materials.empty());
}

TEST(Mtl, MapsScaleWhatTheyAreNamedAfter) {
  const TemporaryDirectory directory;
  directory.file("maps/n.png", png_of({2, 1, PNG_COLOR_TYPE_GRAY, {51, 255}}));
  directory.file("2 n.png", png_of({2, 1, PNG_COLOR_TYPE_RGB, {255, 51, 255, 255, 51, 255}}));
  directory.file("m.png", metallic_roughness_png());
  directory.file("a.tga", "????");
  const std::string unread = "; specular texture is not read: Ks is taken from 0 to its value";
  const std::string limit = "; the specular power = inf is taken for 1e+09";
  const auto expect = [&](const std::string& lines, const std::string& text) {
    EXPECT_EQ(mtl(lines, {}, directory / "a.mtl"), text) << lines;
  };
  expect("Ns 50\nKs 0.5 1 0\nmap_Ns -s 1 1 1 maps\\n.png\nmap_Ks gone.png",
         "F0 0 to 0.5 | 0 to 1 | 0, no Fresnel, n 10 to 50 of a power" + unread);
  expect("Ns 50\nmap_Ks gone.png", "F0 0 to 1, no Fresnel, n 50" + unread);
  // options stand before the name
  for (const std::string options : {"-imfchan g ", "-o 1 -imfchan g ", "-s 1 -2 -imfchan g -clamp on ",
                                    "-t +1 .5 2e0 -imfchan g ", "-mm 0 1 -imfchan g -bm 1 -type sphere "})
    expect("Ns 50\nKs 1\nmap_Ns " + options + "2 n.png", "F0 1, no Fresnel, n 10");
  expect("Ns 2\nKs 1\nmap_Ns -x y.png",
         "F0 1, no Fresnel, n 0 to 2 of a power; shininess texture '-x y.png' is missing");
  expect("Kd 1 1 1\nmap_Kd gone.png\nmap_Pr -imfchan g m.png\nmap_Pm -imfchan b m.png\nPm 0.5\n",
         "F0 0.02 to 0.52, F90 1, n 0 to 1000000000 of roughness; base colour texture is not "
         "read: F0 of metal is taken from 0 to Kd" +
             limit);
  // what is missing may be anything
  expect("Ns 255\nKs 1\nmap_Ns gone.png",
         "F0 1, no Fresnel, n 0 to 255 of a power; shininess texture 'gone.png' is missing");
  expect(
      "map_Pr a.tga\nmap_Pm gone.png",
      "F0 0.04 to 1, F90 1, n 0 to 1000000000 of roughness; roughness texture 'a.tga' is neither PNG nor JPEG; "
      "metallic texture 'gone.png' is missing" +
          limit);
}

TEST(Mtl, MapsOfAnExporterThatPutsRoughnessIntoNs) {
  const TemporaryDirectory directory;
  directory.file("r.png", png_of({2, 1, PNG_COLOR_TYPE_GRAY, {51, 255}}));
  directory.file("m.png", png_of({2, 1, PNG_COLOR_TYPE_GRAY, {0, 102}}));
  const std::string lines = "Ns 7\nKs 1 1 1\nKd 1 1 1\nmap_Ns r.png\nmap_Ka m.png\n",
                    file = directory / "a.mtl";
  EXPECT_EQ(mtl(lines, {.are_maps_pbr = true}, file), "F0 0.04 to 0.424, F90 1, n 0 to 1248 of roughness");
  EXPECT_EQ(mtl(lines, {}, file), "F0 1, no Fresnel, n 1.4 to 7 of a power");
  EXPECT_EQ(mtl("map_Ka m.png\nNs 7", {.are_maps_pbr = true}, file), "F0 0.04 to 0.424, F90 1, n 7");
}

TEST(Mtl, NumbersThatAreNone) {
  for (const auto& [line, words] : {std::pair{"Ns abc", "'abc' is not a number"},
                                    {"Ns +-3", "'+-3' is not a number"},
                                    {"Ns 1,5", "'1,5' is not a number"},
                                    {"Ns nan", "'nan' is not a finite number of double precision"},
                                    {"Ns 1e999", "'1e999' is not a finite number of double precision"},
                                    {"Ks 1 inf 1", "'inf' is not a finite number of double precision"},
                                    {"Ns -1", "-1 is negative"},
                                    {"Ks 0 0 -0.5", "-0.5 is negative"},
                                    {"Pr 1.5", "1.5 is not in [0, 1]"},
                                    {"Pm -1", "-1 is not in [0, 1]"},
                                    {"Ni x", "'x' is not a number"},
                                    {"Pc x", "'x' is not a number"},
                                    {"Ke x", "'x' is not a number"},
                                    {"d -halo x", "'x' is not a number"},
                                    {"Tr -1", "-1 is negative"},
                                    {"Ns", "it must have one number"},
                                    {"Ns 1 2", "it must have one number"},
                                    {"Ks 1 2", "it must have one number or three"},
                                    {"Ks 1 2 3 4", "it has more than three numbers"},
                                    {"Ks spectral a.rfl", "'spectral' is not a number"},
                                    {"illum 1.5", "it must be a whole number"}}) {
    const std::string text = line, key = text.substr(0, text.find(' '));
    EXPECT_EQ(refusal_of_mtl("newmtl a\r\n\r\n" + text), "'a.mtl', line 3: " + key + ": " + words);
  }
  EXPECT_EQ(refusal_of_mtl("Ns abc"), "'a.mtl', line 1: Ns: 'abc' is not a number");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nNs " + std::string(100000, 'x')),
            "'a.mtl', line 2: Ns: '" + std::string(200, 'x') + " ..' is not a number");
}

TEST(Mtl, FilesThatAreNone) {
  EXPECT_EQ(refusal_of_mtl("newmtl"), "'a.mtl', line 1: newmtl: the material has no name");
  EXPECT_EQ(refusal_of_mtl("newmtl a\n\0"s), "'a.mtl', line 2: there is a zero byte: this is not text");
  std::string many;
  for (std::size_t i = 0; i <= most_materials; ++i) many += "newmtl a\n";
  EXPECT_EQ(refusal_of_mtl(many), "'a.mtl', line 65537: newmtl: there are more than 65536 materials");
  const TemporaryDirectory directory;
  const std::string large = directory.file("large.mtl", "");
  std::filesystem::resize_file(large, most_mtl_bytes + 1);
  EXPECT_EQ(refusal([&] { read_mtl(std::filesystem::path(large), {}); }),
            "cannot read '" + large + "': it has 67108865 bytes, more than 67108864");
}

TEST(Mtl, BadMapsNameTheMaterial) {
  const TemporaryDirectory directory;
  const std::string png = directory.file("a.png", metallic_roughness_png().substr(0, 50));
  const std::string file = directory / "a.mtl";
  const std::string place = "'" + file + "', material 'm' of line 2: ";
  EXPECT_EQ(refusal([&] { read_mtl("\nnewmtl m\nmap_Pr ../a.png", file, {}); }),
            place + "'../a.png' is outside of the scene's folder '" + directory.path().string() + "'");
  EXPECT_EQ(refusal([&] { read_mtl("\nnewmtl m\nmap_Pr a.png", file, {}); }),
            place + "'" + std::filesystem::weakly_canonical(png).string() +
                "': the PNG is damaged: the file ends before the picture does");
}

}  // namespace
}  // namespace shadefit::scene
