#include "scene/read_scene.hpp"

#include <gtest/gtest.h>

#include "tests/scene/samples.hpp"
#include "tests/temporary_directory.hpp"

namespace shadefit::scene {
namespace {

using shadefit::testing::chunk;
using shadefit::testing::glb_of;
using shadefit::testing::gltf_of;
using shadefit::testing::refusal;
using shadefit::testing::TemporaryDirectory;

std::vector<std::string> names_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const Material& material : scene.materials) names.push_back(material.name);
  return names;
}

using Names = std::vector<std::string>;

Scene scene_of(const std::vector<std::filesystem::path>& files) {
  return read_scene(files, {});
}

TEST(ReadScene, TakesFilesTogether) {
  const TemporaryDirectory directory;
  const std::string lights = R"("extensions":{"KHR_lights_punctual":{"lights":[{},{}]}})";
  const std::string gltf = directory.file("a.gltf", gltf_of(R"("materials":[{"name":"g"}],)" + lights));
  const std::string glb = directory.file("b.glb", glb_of(chunk("JSON", gltf_of(lights))));
  const std::string mtl = directory.file("c.MTL", "newmtl m\n");
  const Scene scene = scene_of({gltf, glb, mtl});
  EXPECT_EQ(names_of(scene), (Names{"g", "default", "m"}));
  EXPECT_EQ(scene.lights, 4);
  EXPECT_EQ(scene.materials[2].file, mtl);
  EXPECT_TRUE(scene_of({}).materials.empty());
}

TEST(ReadScene, AFolderStandsForItsScenes) {
  const TemporaryDirectory directory;
  directory.file("b.mtl", "newmtl b\n");
  directory.file("deep/er/a.GLTF", gltf_of(R"("materials":[{"name":"a"}])"));
  directory.file("deep/c.obj", "mtllib gone.mtl\n");
  EXPECT_EQ(names_of(scene_of({directory.path()})), (Names{"b", "a"}));
  std::filesystem::create_directory(directory.path() / "empty");
  EXPECT_EQ(refusal([&] { scene_of({directory / "empty"}); }),
            "'" + (directory / "empty") + "' holds no .gltf, .glb or .mtl");
}

TEST(ReadScene, RefusesOtherExtensions) {
  for (const std::string file : {"a.fbx", "gltf"})
    EXPECT_EQ(refusal([&] { scene_of({file}); }),
              "cannot read '" + file + "': its name must end with .gltf, .glb, .mtl or .obj");
}

// Each file may have as many as a scene.
TEST(ReadScene, MaterialsAreLimitedTogether) {
  const TemporaryDirectory directory;
  std::string half;
  for (std::size_t i = 0; i < most_materials / 2; ++i) half += "newmtl a\n";
  const std::string a = directory.file("a.mtl", half), b = directory.file("b.mtl", half);
  EXPECT_EQ(scene_of({a, b}).materials.size(), most_materials);
  const std::string c = directory.file("c.mtl", "newmtl c\n");
  EXPECT_EQ(refusal([&] {
              scene_of({a, b, c});
            }),
            "'" + c + "': with it there are more than 65536 materials");
}

TEST(ReadObj, MaterialsThatNoLineNamesAreUnused) {
  const TemporaryDirectory directory;
  directory.file("a.mtl", "newmtl a\nnewmtl two words\nnewmtl c\n");
  const auto read = [&](const std::string& lines) {
    return scene_of({directory.file("s.obj", "mtllib a.mtl\n" + lines)});
  };
  const Scene scene = read("usemtl two words\nf 1\nusemtl a\r\nusemtl a\nusemtl gone\n");
  EXPECT_EQ(names_of(scene), (Names{"a", "two words"}));
  EXPECT_EQ(scene.unused, Names{"c"});
  EXPECT_TRUE(read("f 1\n").unused.empty()) << "a file that names none is a list of libraries";
}

TEST(ReadObj, FollowsItsLibraries) {
  const TemporaryDirectory directory;
  directory.file("a.mtl", "newmtl a\n");
  directory.file("b.mtl", "newmtl b\n");
  directory.file("two words.mtl", "newmtl c\n");
  const std::string geometry(200000, '1');
  const std::string obj =
      directory.file("s.obj", "# obj\nmtllib a.mtl b.mtl\r\nv 0 0 " + geometry +
                                  "\nmtllib  two words.mtl\nmtllibx x\nf 1\nmtllib a.mtl");
  EXPECT_EQ(names_of(scene_of({obj})), (Names{"a", "b", "c"}));
  EXPECT_TRUE(scene_of({directory.file("empty.obj", "v 0 0 0\n")}).materials.empty());
}

TEST(ReadObj, RefusesLibrariesThatAreMissingOrElsewhere) {
  const TemporaryDirectory directory;
  directory.file("a.mtl", "");
  std::string many, name = "a.mtl";
  for (int i = 0; i < 1001; ++i) many += "mtllib " + (name = "./" + name) + "\n";
  const std::string gone = "cannot read '" + directory / "gone.mtl" + "': there is no such file";
  const std::string folder = directory.path().string();
  for (const auto& [lines, words] : std::vector<std::pair<std::string, std::string>>{
           {"\nmtllib gone.mtl\n", "2: " + gone},
           {"mtllib ../a.mtl", "1: '../a.mtl' is outside of the scene's folder '" + folder + "'"},
           {"mtllib", "1: the name of a file is empty"},
           {many, "1001: there are more than 1000 lines mtllib"}}) {
    const std::string file = directory.file("a.obj", lines);
    EXPECT_EQ(refusal([&] { scene_of({file}); }), "'" + file + "', line " + words);
  }
  EXPECT_EQ(refusal([&] { scene_of({directory / "x.obj"}); }),
            "cannot read '" + directory / "x.obj" + "': there is no such file");
}

}  // namespace
}  // namespace shadefit::scene
