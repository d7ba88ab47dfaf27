#include <gtest/gtest.h>

#include "scene/mtl/read_mtl.hpp"
#include "tests/scene/samples.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit::scene {
namespace {

using shadefit::testing::metallic_roughness_png;
using shadefit::testing::png_of;
using shadefit::testing::refusal;
using shadefit::testing::TemporaryDirectory;
using namespace std::string_literals;

Material mtl(const std::string& lines, const Conventions& conventions = {}) {
  return read_mtl("newmtl a\n" + lines, "a.mtl", conventions).materials.at(0);
}

std::string refusal_of_mtl(const std::string& text) {
  return refusal([&] { read_mtl(text, "a.mtl", {}); });
}

TEST(Mtl, PhongHasAFactorAndAPower) {
  const Material material = mtl("Ns 50.5\nKs 0.25 0.5 1.5\nillum 2\n");
  EXPECT_EQ(material.name, "a");
  EXPECT_EQ(material.file, "a.mtl");
  EXPECT_EQ(material.fresnel, FresnelTerm::none);
  EXPECT_EQ(material.f0, (std::array{Range{0.25, 0.25}, Range{0.5, 0.5}, Range{1.5, 1.5}}));
  EXPECT_EQ(material.powers, (std::vector<PowerShare>{{50.5, 1}}));
  EXPECT_FALSE(material.is_power_textured());
  EXPECT_TRUE(material.unknowns.empty() && material.remarks.empty());
}

TEST(Mtl, BlackOrUnsaidOrByIlluminationThereIsNoSpecular) {
  constexpr std::array<Range, 3> black{};
  for (const char* lines :
       {"Ks 0 0 0\nNs 20", "Ns 20", "Ns 20\nKs 1 1 1\nillum 0", "Ns 20\nKs 1 1 1\nillum 1"}) {
    EXPECT_EQ(mtl(lines).f0, black) << lines;
    EXPECT_EQ(mtl(lines).powers, (std::vector<PowerShare>{{20, 1}})) << lines;
  }
  EXPECT_EQ(mtl("Kd 1 1 1").powers, (std::vector<PowerShare>{{0, 1}}));
  EXPECT_EQ(mtl("Ks 1\nNs 5\nillum 3").f0[2], (Range{1, 1}));
}

// As editors and exporters write them.
TEST(Mtl, AMarkAndAPlusAreTaken) {
  const Scene scene = read_mtl("\xEF\xBB\xBFnewmtl a\nKs +0.5\nNs +3\nnewmtl b\n", "a.mtl", {});
  ASSERT_EQ(scene.materials.size(), 2U);
  EXPECT_EQ(scene.materials[0].name, "a");
  EXPECT_EQ(scene.materials[0].powers, (std::vector<PowerShare>{{3, 1}}));
  EXPECT_EQ(scene.materials[0].f0[0], (Range{0.5, 0.5}));
  EXPECT_EQ(refusal_of_mtl("newmtl a\nNs +-3"), "'a.mtl', line 2: Ns: '+-3' is not a number");
}

TEST(Mtl, AColourTooBrightIsLimited) {
  EXPECT_EQ(mtl("Ks 1e300\nNs 3").f0[0], (Range{most_factor, most_factor}));
  EXPECT_EQ(mtl("Ks 1e300\nNs 3").remarks, std::vector<std::string>{"Ks above 1000000 is taken for that"});
}

TEST(Mtl, UnsaidPowerIsOneWithARemark) {
  EXPECT_EQ(mtl("Ks 1 1 1").powers, (std::vector<PowerShare>{{1, 1}}));
  EXPECT_EQ(mtl("Ks 1 1 1").remarks, std::vector<std::string>{"Ns is missing and is taken for 1"});
}

TEST(Mtl, LargePowersAreLimited) {
  EXPECT_EQ(mtl("Ks 1\nNs 1e30").powers, (std::vector<PowerShare>{{most_power, 1}}));
  EXPECT_EQ(mtl("Ks 1\nNs 1e30").remarks, std::vector<std::string>{"Ns = 1e+30 is taken for 1e+09"});
  EXPECT_EQ(mtl("Ks 0\nNs 1e30").remarks, std::vector<std::string>{"Ns = 1e+30 is taken for 1e+09"});
  EXPECT_TRUE(mtl("Ks 1\nNs 1e9").remarks.empty());
}

TEST(Mtl, FilesOfEveryHabit) {
  const Scene scene = read_mtl(
      "# made by hand\r\n\r\nNs 7\r\n  newmtl \t two words \r\n\tNs 3 # three\r\n\tKs 1\r\nnewmtl two words\rNs 4\rKs "
      "0.5\rfoo bar\rNs 5",
      "a.mtl", {});
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].name, "two words");
  EXPECT_EQ(scene.materials[0].powers, (std::vector<PowerShare>{{3, 1}}));
  EXPECT_EQ(scene.materials[1].name, "two words");
  EXPECT_EQ(scene.materials[1].powers, (std::vector<PowerShare>{{5, 1}}));
  EXPECT_TRUE(read_mtl("", "a.mtl", {}).materials.empty());
  EXPECT_TRUE(read_mtl("# none\n", "a.mtl", {}).materials.empty());
}

TEST(Mtl, PhysicallyBased) {
  const Material material = mtl("Pr 0.5\nPm 0.5\nKd 0.8 0.4 0.04\nNs 3\nKs 1 1 1");
  EXPECT_EQ(material.fresnel, FresnelTerm::schlick);
  EXPECT_EQ(material.f90, (Range{1, 1}));
  EXPECT_NEAR(material.f0[0].most, 0.42, 1e-15);
  EXPECT_NEAR(material.f0[1].most, 0.22, 1e-15);
  EXPECT_EQ(material.powers.size(), 1u);
  EXPECT_NEAR(material.powers[0].power, 30, 1e-12);
  EXPECT_NEAR(mtl("Pr 0.5\nNi 2").f0[0].most, 1.0 / 9, 1e-15);
  EXPECT_NEAR(mtl("Pr 0.5", {.is_roughness_squared = false}).powers[0].power, 6, 1e-12);
  EXPECT_EQ(mtl("Pr 0").powers, (std::vector<PowerShare>{{most_power, 1}}));
}

TEST(Mtl, PhysicallyBasedWithoutARoughness) {
  EXPECT_EQ(mtl("Pm 1\nNs 7").powers, (std::vector<PowerShare>{{7, 1}}));
  const Material material = mtl("Pm 1");
  EXPECT_EQ(material.unknowns, std::vector<std::string>{"roughness is missing"});
  EXPECT_GT(material.powers.size(), 250u);
  EXPECT_EQ(mtl("Pm 1\nKd 2 0.5 1").f0, (std::array{Range{1, 1}, Range{0.5, 0.5}, Range{1, 1}}));
  EXPECT_EQ(mtl("Pr 1\nKd 2 0.5 1").remarks, std::vector<std::string>{"Kd above 1 is taken for 1"});
}

TEST(Mtl, MapsScaleWhatTheyAreNamedAfter) {
  const TemporaryDirectory directory;
  directory.file("maps/n.png", png_of({2, 1, PNG_COLOR_TYPE_GRAY, {51, 255}}));
  const auto read = [&](const std::string& lines) {
    return read_mtl("newmtl a\n" + lines, directory / "a.mtl", {}).materials.at(0);
  };
  const Material material = read("Ns 50\nKs 0.5 1 0\nmap_Ns -s 1 1 1 maps\\n.png\nmap_Ks gone.png");
  EXPECT_EQ(material.powers, (std::vector<PowerShare>{{10, 0.5}, {50, 0.5}}));
  EXPECT_TRUE(material.is_power_textured());
  EXPECT_EQ(material.f0, (std::array{Range{0, 0.5}, Range{0, 1}, Range{0, 0}}));
  EXPECT_EQ(material.unknowns,
            std::vector<std::string>{"specular texture is not read: Ks is taken from 0 to its value"});
  EXPECT_EQ(read("Ns 50\nmap_Ks gone.png").f0[0], (Range{0, 1}));
  EXPECT_EQ(read("Ns 50\nmap_Ks -clamp on").f0[0], (Range{0, 0})) << "options without a file";
}

TEST(Mtl, OptionsOfMapsStandBeforeTheName) {
  const TemporaryDirectory directory;
  directory.file("2 n.png", png_of({2, 1, PNG_COLOR_TYPE_RGB, {255, 51, 255, 255, 51, 255}}));
  for (const std::string options : {"-imfchan g ", "-o 1 -imfchan g ", "-s 1 -2 -imfchan g -clamp on ",
                                    "-t +1 .5 2e0 -imfchan g ", "-mm 0 1 -imfchan g -bm 1 -type sphere "}) {
    const std::string lines = "newmtl a\nNs 50\nKs 1\nmap_Ns " + options + "2 n.png";
    const Material material = read_mtl(lines, directory / "a.mtl", {}).materials.at(0);
    EXPECT_EQ(material.powers, (std::vector<PowerShare>{{10, 1}})) << options;
  }
  const Material unknown =
      read_mtl("newmtl a\nNs 50\nKs 1\nmap_Ns -x y.png", directory / "a.mtl", {}).materials.at(0);
  EXPECT_EQ(unknown.unknowns, std::vector<std::string>{"shininess texture '-x y.png' is missing"});
}

TEST(Mtl, MapsOfThePhysicallyBasedKeys) {
  const TemporaryDirectory directory;
  directory.file("m.png", metallic_roughness_png());
  const std::string lines =
      "newmtl a\nKd 1 1 1\nmap_Kd gone.png\nmap_Pr -imfchan g m.png\nmap_Pm -imfchan b m.png\nPm 0.5\n";
  const Material material = read_mtl(lines, directory / "a.mtl", {}).materials.at(0);
  ASSERT_EQ(material.powers.size(), 3u);
  EXPECT_EQ(material.powers[0], (PowerShare{0, 0.25}));
  EXPECT_NEAR(material.powers[1].power, 1248, 1e-9);
  EXPECT_NEAR(material.f0[0].least, 0.02, 1e-15);
  EXPECT_NEAR(material.f0[0].most, 0.52, 1e-15);
  EXPECT_EQ(material.unknowns,
            std::vector<std::string>{"base colour texture is not read: F0 of metal is taken from 0 to Kd"});
}

TEST(Mtl, MapsOfAnExporterThatPutsRoughnessIntoNs) {
  const TemporaryDirectory directory;
  directory.file("r.png", png_of({2, 1, PNG_COLOR_TYPE_GRAY, {51, 255}}));
  directory.file("m.png", png_of({2, 1, PNG_COLOR_TYPE_GRAY, {0, 102}}));
  const std::string lines = "newmtl a\nNs 7\nKs 1 1 1\nKd 1 1 1\nmap_Ns r.png\nmap_Ka m.png\n";
  const Material material = read_mtl(lines, directory / "a.mtl", {.are_maps_pbr = true}).materials.at(0);
  EXPECT_EQ(material.fresnel, FresnelTerm::schlick);
  ASSERT_EQ(material.powers.size(), 2u);
  EXPECT_NEAR(material.powers[1].power, 1248, 1e-9);
  EXPECT_NEAR(material.f0[0].least, 0.04, 1e-15);
  EXPECT_NEAR(material.f0[0].most, 0.04 + 0.4 * 0.96, 1e-15);
  EXPECT_EQ(read_mtl(lines, directory / "a.mtl", {}).materials.at(0).fresnel, FresnelTerm::none);
  const Material metal =
      read_mtl("newmtl a\nmap_Ka m.png\nNs 7", directory / "a.mtl", {.are_maps_pbr = true}).materials.at(0);
  EXPECT_EQ(metal.powers, (std::vector<PowerShare>{{7, 1}}));
}

TEST(Mtl, MissingMapsAreNamedAndHoldAnything) {
  const TemporaryDirectory directory;
  directory.file("a.tga", "????");
  const auto read = [&](const std::string& lines) {
    return read_mtl("newmtl a\n" + lines, directory / "a.mtl", {}).materials.at(0);
  };
  const Material material = read("Ns 255\nKs 1\nmap_Ns gone.png");
  EXPECT_EQ(material.unknowns, std::vector<std::string>{"shininess texture 'gone.png' is missing"});
  ASSERT_EQ(material.powers.size(), 256u);
  EXPECT_EQ(material.powers.front().power, 0);
  EXPECT_EQ(material.powers.back().power, 255);
  EXPECT_EQ(read("map_Pr a.tga\nmap_Pm gone.png").unknowns,
            (std::vector<std::string>{"roughness texture 'a.tga' is neither PNG nor JPEG",
                                      "metallic texture 'gone.png' is missing"}));
}

TEST(Mtl, NumbersThatAreNone) {
  EXPECT_EQ(refusal_of_mtl("newmtl a\nNs abc"), "'a.mtl', line 2: Ns: 'abc' is not a number");
  EXPECT_EQ(refusal_of_mtl("newmtl a\r\n\r\nNs 1,5"), "'a.mtl', line 3: Ns: '1,5' is not a number");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nNs nan"),
            "'a.mtl', line 2: Ns: 'nan' is not a finite number of double precision");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nNs 1e999"),
            "'a.mtl', line 2: Ns: '1e999' is not a finite number of double precision");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nKs 1 inf 1"),
            "'a.mtl', line 2: Ks: 'inf' is not a finite number of double precision");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nNs -1"), "'a.mtl', line 2: Ns: -1 is negative");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nKs 0 0 -0.5"), "'a.mtl', line 2: Ks: -0.5 is negative");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nPr 1.5"), "'a.mtl', line 2: Pr: 1.5 is not in [0, 1]");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nPm -1"), "'a.mtl', line 2: Pm: -1 is not in [0, 1]");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nNi x"), "'a.mtl', line 2: Ni: 'x' is not a number");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nNs"), "'a.mtl', line 2: Ns: it must have one number");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nNs 1 2"), "'a.mtl', line 2: Ns: it must have one number");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nKs 1 2"), "'a.mtl', line 2: Ks: it must have one number or three");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nKs 1 2 3 4"), "'a.mtl', line 2: Ks: it has more than three numbers");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nKs spectral a.rfl"), "'a.mtl', line 2: Ks: 'spectral' is not a number");
  EXPECT_EQ(refusal_of_mtl("newmtl a\nillum 1.5"), "'a.mtl', line 2: illum: it must be a whole number");
  EXPECT_EQ(refusal_of_mtl("Ns abc"), "'a.mtl', line 1: Ns: 'abc' is not a number");
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

TEST(Mtl, OtherLobesAreRemarkedOn) {
  using Remarks = std::vector<std::string>;
  EXPECT_EQ(mtl("Ns 2\nKs 1 1 1\nPc 0.5\naniso 0.1\nPs 0.2 0.3 0\n").remarks,
            (Remarks{"Pc is left out", "Ps is left out", "aniso is left out"}));
  EXPECT_EQ(mtl("Ns 2\nKs 1 1 1\nPc 0\naniso 0\nPs 0\n").remarks, Remarks{});
  EXPECT_EQ(refusal_of_mtl("newmtl a\nPc x\n"), "'a.mtl', line 2: Pc: 'x' is not a number");
}

TEST(Mtl, LongTextsAreShortened) {
  EXPECT_EQ(refusal_of_mtl("newmtl a\nNs " + std::string(100000, 'x')),
            "'a.mtl', line 2: Ns: '" + std::string(200, 'x') + " ..' is not a number");
}

}  // namespace
}  // namespace shadefit::scene
