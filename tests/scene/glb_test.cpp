#include "scene/gltf/glb.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/scene/samples.hpp"

namespace shadefit::scene {
namespace {

using shadefit::testing::chunk;
using shadefit::testing::glb_of;
using shadefit::testing::refusal;
using shadefit::testing::word;
using namespace std::string_literals;

TEST(Glb, HasItsChunksAndEndsWhereItSays) {
  const std::string file = glb_of(chunk("JSON", "{}  ") + chunk("what", "skip") + chunk("BIN\0"s, "1234"));
  const Glb glb = parse_glb(file);
  EXPECT_EQ(glb.json, "{}  ");
  ASSERT_TRUE(glb.binary.has_value());
  EXPECT_EQ(*glb.binary, "1234");
  const std::string longer = glb_of(chunk("JSON", "{}  ")) + "left over";
  EXPECT_EQ(parse_glb(longer).json, "{}  ");
  EXPECT_FALSE(parse_glb(longer).binary.has_value());
}

TEST(Glb, RefusesWhatIsNone) {
  const std::string json = chunk("JSON", "{}  ");
  const std::string most = word(std::numeric_limits<std::uint32_t>::max());
  for (const auto& [file, words] : std::vector<std::pair<std::string, std::string>>{
           {"", "byte 0: a GLB file begins with 12 bytes, and has 0"},
           {"glTF1234567", "byte 0: a GLB file begins with 12 bytes, and has 11"},
           {"GLTF" + word(2) + word(12), "byte 0: a GLB file begins with 'glTF'"},
           {"glTF" + word(1) + word(12), "byte 4: version 1 of GLB is not 2"},
           {"glTF" + word(2) + word(13), "byte 8: the length 13 is not within the file's 12 bytes"},
           {"glTF" + word(2) + word(11), "byte 8: the length 11 is not within the file's 12 bytes"},
           {glb_of(""), "byte 12: there is no JSON chunk"},
           {glb_of(json + "1234567"), "byte 24: the file ends within a chunk's header"},
           {glb_of(word(5) + "JSON{}  "), "byte 12: a chunk of 5 bytes goes past the end, 4 bytes on"},
           {glb_of(most + "JSON{}  "), "byte 12: a chunk of 4294967295 bytes goes past the end, 4 bytes on"},
           {glb_of(chunk("BIN\0"s, "1234")), "byte 12: the first chunk, and no other, has to be JSON"},
           {glb_of(json + json), "byte 24: the first chunk, and no other, has to be JSON"}})
    EXPECT_EQ(refusal([&bytes = file] { parse_glb(bytes); }), words);
}

}  // namespace
}  // namespace shadefit::scene
